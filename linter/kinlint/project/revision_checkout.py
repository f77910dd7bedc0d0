"""A directory with the files of a revision, for as long as somebody looks at them.

What did not change since then is copied from the working tree, the rest comes from git. Meshes and
pictures are empty, since nobody looks into them. What git ignores, and submodules, are links to
what is there now.
"""

from __future__ import annotations

import os
import re
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from kinlint.files.bounded_read import SIZE
from kinlint.files.file_exists import KINDS
from kinlint.files.revision import Revision
from kinlint.formats.records import GLOBBED

EMPTY = KINDS[0] | KINDS[1]
POINTER = re.compile(
    rb"version https://git-lfs\.github\.com/spec/v1\n(?:.*\n)*?oid sha256:([0-9a-f]{64})\n"
)
"""Content of a file in git whose data Git LFS keeps."""


@contextmanager
def checkout(revision: Revision) -> Iterator[Path]:
    """The directory, in place of the top of the repository. It is gone when the block ends."""
    with tempfile.TemporaryDirectory(prefix="kinlint-", ignore_cleanup_errors=True) as made:
        root = Path(os.path.realpath(made))
        (root / ".git").touch()
        _fill(root, revision)
        yield root


def checkout_path(path: Path, revision: Revision, root: Path) -> Path:
    """Return the path in the checkout at *root* of the file at *path*.

    *path* if it is not in there.
    """
    top = revision.repository.top
    there = root / path.relative_to(top) if path.is_relative_to(top) else path
    return there if there.exists() else path


def _fill(root: Path, revision: Revision) -> None:
    top = revision.repository.top
    apart = {*revision.changed.values(), *revision.deleted}
    stored = []
    for path in revision.files:
        target = _made(root, path.relative_to(top))
        if target is None:
            continue
        if path.suffix.lower() in EMPTY:
            target.touch()
        elif path in apart or not _copied(path, target):
            stored.append(path)
    for path, data in revision.read(stored).items():
        if (target := _made(root, path.relative_to(top))) is not None:
            target.write_bytes(_meant(data, revision))
    for path in (*revision.submodules, *revision.ignored):
        target = _made(root, path.relative_to(top))
        if target is not None and path.exists() and not os.path.lexists(target):
            with suppress(OSError):
                target.symlink_to(path, target_is_directory=path.is_dir())


def _made(root: Path, below: Path) -> Path | None:
    """The path *below* a *root*, its directory made; None if it would lead out or cannot be."""
    if ".." in below.parts or below.is_absolute() or ".git" in below.parts:
        return None
    target = root / below
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
    except OSError:
        return None
    return target


def _copied(path: Path, target: Path) -> bool:
    """Copy the file at *path* unless it is too large to be read, and tell whether it exists."""
    try:
        if path.name.lower().endswith(GLOBBED) or path.stat().st_size <= SIZE:
            shutil.copyfile(path, target)
    except OSError:
        return False
    return True


def _meant(data: bytes, revision: Revision) -> bytes:
    """*data*, or what it points to in the store of Git LFS, if that is here."""
    pointer = POINTER.match(data)
    if pointer is None:
        return data
    oid = pointer[1].decode()
    try:
        return (revision.repository.store / "lfs/objects" / oid[:2] / oid[2:4] / oid).read_bytes()
    except OSError:
        return data
