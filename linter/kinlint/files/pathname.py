"""Path names for messages, and suggestions for paths that do not exist."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path

from kinlint.files import url_mirror
from kinlint.files.tracked_io import question
from kinlint.suggestion import nearest

NOTHING = "no such file or directory"


def has_working_directory() -> bool:
    """Tell whether the working directory is still there."""
    try:
        Path.cwd()
    except OSError:
        return False
    return True


def shown(path: Path, given: str = "") -> str:
    """Return *path* relative to the working directory if it is below it, else as it was *given*.

    What is mirrored is shown by its URL.
    """
    if url_mirror.in_use() and (url := url_mirror.name_of(path)):
        return printable(url)
    with suppress(OSError, ValueError):  # The working directory may be gone.
        return printable(path.relative_to(Path.cwd()).as_posix())
    return printable(Path(given).as_posix() if given else path.as_posix())


def printable(name: str) -> str:
    """Return *name* with bytes that are not UTF-8 escaped.

    A file name may hold any byte but NUL.
    """
    return os.fsencode(name).decode("utf-8", "backslashreplace").replace("\0", "\\x00")


@question
def real(path: str | Path) -> Path:
    """Return *path* from the root of the file system, with all links followed."""
    return Path(os.path.realpath(path))


def missing(path: Path) -> str:
    """Say why there is nothing at *path*, with what there is of a similar name."""
    try:
        siblings = [one.name for one in path.parent.iterdir()]
    except OSError:
        siblings = []
    # A common suffix says nothing of how alike two names are.
    alike = {Path(name).stem: name for name in siblings if Path(name).suffix == path.suffix}
    others = [name for name in siblings if Path(name).stem not in alike]
    found = alike.get(nearest(path.stem, alike) or "") or nearest(path.name, others)
    name, equals, value = path.name.partition("=")
    if equals and name.isidentifier() and not found:
        return f"{NOTHING}; an argument for xacro is written {printable(f'{name}:={value}')}"
    return NOTHING + (f", did you mean '{printable(found)}'?" if found else "")
