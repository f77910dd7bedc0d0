"""Access to the environment: files, directories, variables, the date.

Each is a tracked question.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from pathlib import Path

from kinlint.files.tracked_io import question

WRITING = 0o222
"""Mode bits of files that somebody may write."""


@question
def variable(name: str) -> str | None:
    """Return the environment variable *name*; None if it is not set."""
    return os.environ.get(name)


class Environment(Mapping[str, str]):
    """The variables of the environment, each of which is a question."""

    def __getitem__(self, name: str) -> str:
        found = variable(name)
        if found is None:
            raise KeyError(name)
        return found

    def __iter__(self) -> Iterator[str]:
        return iter(os.environ)

    def __len__(self) -> int:
        return len(os.environ)


@question
def today() -> str:
    """Return the day, as in `2027-01-01`."""
    from datetime import date  # noqa: PLC0415  few models ask

    return date.today().isoformat()  # noqa: DTZ011  the day where the user is


@question
def kind(path: Path) -> str | None:
    """Return the kind of *path*, links followed.

    `file`, `directory`, `other`; None if it is not there.
    """
    try:
        if path.is_dir():
            return "directory"
        if path.is_file():
            return "file"
        return "other" if path.exists() else None
    except (OSError, ValueError):
        return None


@question
def listing(directory: Path) -> dict[str, bool]:
    """Return the names in *directory*, sorted, and whether each is a directory.

    None if it is none.
    """
    try:
        with os.scandir(directory) as entries:
            return {each.name: each.is_dir() for each in sorted(entries, key=lambda one: one.name)}
    except (OSError, ValueError):
        return {}


@question
def writable(path: Path) -> bool:
    """Tell whether the file at *path* may be written and replaced."""
    try:
        mode = path.stat().st_mode
    except OSError:
        return False
    return bool(mode & WRITING) and os.access(path, os.W_OK) and os.access(path.parent, os.W_OK)


@question
def modified(path: Path) -> tuple[int, int] | None:
    """Return when the file at *path* was last written, in ns, and its size; None without one."""
    try:
        about = path.stat()
    except (OSError, ValueError):
        return None
    return about.st_mtime_ns, about.st_size
