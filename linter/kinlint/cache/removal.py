"""Removes what kinlint keeps from one run for the next, and nothing else."""

from __future__ import annotations

from contextlib import suppress
from pathlib import Path

from kinlint.cache.directory_store import DirectoryStore
from kinlint.cache.report_cache import FOLDER
from kinlint.catalogue.compiled_store import STORED
from kinlint.installation import STORED as DIGESTS
from kinlint.light_dataclasses import dataclass


@dataclass(frozen=True)
class Cleared:
    """Number of reports and compiled catalogues removed, and their size in bytes."""

    reports: int = 0
    """Number of reports removed."""
    catalogues: int = 0
    """Number of compiled catalogues removed."""
    size: int = 0
    """Size of all of them in bytes."""


def clear(directory: Path) -> Cleared:
    """Remove the cache in *directory*, and the directory itself if nothing else is in it.

    Raises OSError if something cannot be removed.
    """
    reports, size = DirectoryStore(directory / FOLDER).clear()
    catalogues = 0
    for pattern in STORED:
        for path in directory.glob(pattern):
            size += path.lstat().st_size
            path.unlink(missing_ok=True)
            catalogues += 1
    for pattern in DIGESTS:
        for path in directory.glob(pattern):
            path.unlink(missing_ok=True)
    with suppress(OSError):
        directory.rmdir()
    return Cleared(reports, catalogues, size)
