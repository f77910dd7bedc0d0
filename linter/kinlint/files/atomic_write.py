"""Replaces files as a whole: whoever looks finds the old content or the new, never a part."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from hashlib import sha256
from pathlib import Path
from typing import BinaryIO

try:
    import fcntl
except ImportError:  # On Windows, files that are open cannot be removed.
    fcntl = None  # type: ignore[assignment]

SUFFIX = ".tmp"
SLOTS = 4
"""The number of processes that may replace one file at once, and leave nothing if killed."""
BINARY = getattr(os, "O_BINARY", 0)


@contextmanager
def replacement(path: Path) -> Iterator[BinaryIO]:
    """Open a stream whose content replaces the file at *path* once it is complete.

    If the block raises, the file stays as it was. Symbolic links stay links, an existing file keeps
    its mode and, as far as the process may give files away, its owner and group; its other hard
    links keep the old content. What is no regular file, such as `/dev/stdout`, is written to as it
    is. What a killed process left of an earlier replacement of the file is removed.
    """
    # The links of /dev/stdout lead nowhere by name if it is a pipe.
    if path.exists() and not path.is_file():
        with path.open("wb") as stream:
            yield stream
        return
    target = Path(os.path.realpath(path))
    old = target.stat() if target.exists() else None
    mode = old.st_mode & 0o777 if old else 0o666 & ~_umask()
    handle, temporary = _new_file(target)
    try:
        with os.fdopen(handle, "wb") as stream:
            yield stream
            stream.flush()
            os.fsync(stream.fileno())
            if old and fcntl is not None:
                for owner in ((-1, old.st_gid), (old.st_uid, -1)):
                    with suppress(PermissionError):  # Only the superuser gives files away.
                        os.chown(temporary, *owner)
            temporary.chmod(mode)
            if fcntl is not None:  # Unlocked, it would be taken for an abandoned one.
                temporary.replace(target)
        if fcntl is None:
            temporary.replace(target)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise


def _new_file(target: Path) -> tuple[int, Path]:
    """Return a new file beside *target* that no other process takes for an abandoned one.

    Its name is one of a few that belong to *target*, so that what was abandoned is found without
    a look at all files of the directory. If others hold all of them, it is a random one.
    """
    prefix = f".kinlint-{sha256(os.fsencode(target.name)).hexdigest()[:16]}-"
    slots = [target.parent / f"{prefix}{number}{SUFFIX}" for number in range(SLOTS)]
    for path in slots:
        _remove_abandoned(path)
    for path in slots:
        with suppress(FileExistsError):
            handle = os.open(path, os.O_RDWR | os.O_CREAT | os.O_EXCL | BINARY, 0o600)
            if _lock(handle, path):
                return handle, path
            os.close(handle)
    import tempfile  # noqa: PLC0415  slow to import, and most runs write no file

    handle, name = tempfile.mkstemp(SUFFIX, prefix, target.parent)
    return handle, Path(name)


def _lock(handle: int, path: Path) -> bool:
    """Lock the file that was just made at *path*, unless another process has removed it already."""
    if fcntl is None:
        return True
    with suppress(OSError):  # Where nothing can be locked, nothing is taken for abandoned.
        fcntl.flock(handle, fcntl.LOCK_EX)
    with suppress(OSError):
        return os.path.samestat(os.fstat(handle), path.stat())
    return False


def _remove_abandoned(path: Path) -> None:
    """Remove the new file at *path*, if any, if its process was killed before it was done."""
    with suppress(OSError):
        if fcntl is None:
            path.unlink()
            return
        handle = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK)
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
            if os.path.samestat(os.fstat(handle), path.stat()):
                path.unlink()
        finally:
            os.close(handle)


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
