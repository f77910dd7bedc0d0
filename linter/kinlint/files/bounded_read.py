"""Reads files that other files name: regular ones, of bounded size, that may belong to a robot."""

from __future__ import annotations

import os
import stat
from pathlib import Path

from kinlint.files.pathname import shown
from kinlint.files.tracked_io import question

SIZE = 1 << 23
BEGINNING = 1 << 26
SYSTEM = [(name,) for name in ("dev", "etc", "proc", "run", "sys")]


class Unreadable(Exception):
    """A file that is named cannot be used; the text says why. *missing*: there is none."""

    def __init__(self, cause: str, *, missing: bool = False) -> None:
        super().__init__(cause)
        self.missing = missing


@question
def contents(path: Path, near: Path, limit: int = SIZE) -> bytes:
    """Return the content of the regular file at *path*, at most *limit* bytes.

    A file at *near* names it. Raises Unreadable, also for files that are hidden or belong to the
    system.
    """
    if _is_private(path, near):
        raise Unreadable(f"'{shown(path)}' is none of the files that a robot is made of")
    try:
        about = path.stat()
        if not stat.S_ISREG(about.st_mode):
            raise Unreadable(f"'{shown(path)}' is not a file")
        if about.st_size > limit:
            raise Unreadable(f"'{shown(path)}' has more than {limit >> 10} KiB")
        return path.read_bytes()
    except (FileNotFoundError, NotADirectoryError):
        raise Unreadable(f"there is no file '{shown(path)}'", missing=True) from None
    except (OSError, ValueError) as error:
        cause = getattr(error, "strerror", None) or str(error)
        raise Unreadable(f"'{shown(path)}' cannot be read: {cause}") from None


@question
def beginning(path: Path) -> bytes | None:
    """Return the first bytes of the regular file at *path*; None if it cannot be read."""
    try:
        if not stat.S_ISREG(path.stat().st_mode):
            return None
        with path.open("rb") as stream:
            return stream.read(BEGINNING)
    except (OSError, ValueError):
        return None


@question
def head(path: Path, size: int) -> str | None:
    """Return the first *size* characters of the regular file at *path*; None if there is none."""
    try:
        if not stat.S_ISREG(path.stat().st_mode):
            return None
        with path.open(encoding="utf-8", errors="replace") as stream:
            return stream.read(size)
    except (OSError, ValueError):
        return None


def _is_private(path: Path, near: Path) -> bool:
    """Tell whether *path* leads out of the tree of *near* to where no robots are kept."""
    try:
        real, own = Path(os.path.realpath(path)), Path(os.path.realpath(near))
    except (OSError, ValueError):
        return False
    apart = next((i for i, (a, b) in enumerate(zip(real.parts, own.parts)) if a != b), 0)  # noqa: B905  of any length
    hidden = any(part.startswith(".") for part in real.parts[apart:])
    return hidden or (real.parts[1:2] in SYSTEM and own.parts[1:2] != real.parts[1:2])
