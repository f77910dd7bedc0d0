"""Files that commands write: as a whole, or not at all."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from io import TextIOWrapper
from pathlib import Path
from typing import BinaryIO, TextIO

from kinlint.errors import UsageError
from kinlint.files.atomic_write import replacement


@contextmanager
def replacing(path: Path) -> Iterator[TextIO]:
    """A stream whose text replaces the file at *path* once it is complete, or not at all.

    Raises `UsageError` if that cannot be.
    """
    with replacing_bytes(path) as stream:
        text = TextIOWrapper(stream, "utf-8", newline="\n")
        yield text
        text.detach()


@contextmanager
def replacing_bytes(path: Path) -> Iterator[BinaryIO]:
    """A stream whose bytes replace the file at *path*, as `replacing` does."""
    try:
        with replacement(path) as stream:
            yield stream
    except BrokenPipeError:
        raise
    except OSError as error:
        raise UsageError(f"cannot write {path}: {error.strerror or error}") from None
