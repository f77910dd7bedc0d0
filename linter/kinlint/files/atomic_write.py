"""Replaces files as a whole: whoever looks finds the old content or the new, never a part."""

from __future__ import annotations

import os
import tempfile
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


@contextmanager
def replacement(path: Path) -> Iterator[BinaryIO]:
    """Open a stream whose content replaces the file at *path* once it is complete.

    If the block raises, the file stays as it was. Symbolic links stay links, an existing file keeps
    its mode, and its other hard links keep the old content. What is no regular file, such as
    `/dev/stdout`, is written to as it is. What a killed process left of an earlier replacement of
    the file is removed.
    """
    # The links of /dev/stdout lead nowhere by name if it is a pipe.
    if path.exists() and not path.is_file():
        with path.open("wb") as stream:
            yield stream
        return
    target = Path(os.path.realpath(path))
    mode = target.stat().st_mode & 0o777 if target.exists() else 0o666 & ~_umask()
    prefix = f".kinlint-{sha256(os.fsencode(target.name)).hexdigest()[:16]}-"
    _remove_abandoned(target.parent, prefix)
    handle, temporary = _locked(target.parent, prefix)
    try:
        with os.fdopen(handle, "wb") as stream:
            yield stream
            stream.flush()
            os.fsync(stream.fileno())
            temporary.chmod(mode)
            if fcntl is not None:  # Unlocked, it would be taken for an abandoned one.
                temporary.replace(target)
        if fcntl is None:
            temporary.replace(target)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise


def _locked(directory: Path, prefix: str) -> tuple[int, Path]:
    """Return a new file that is locked, so that no other process takes it for an abandoned one."""
    while True:
        handle, name = tempfile.mkstemp(SUFFIX, prefix, directory)
        if fcntl is None:
            return handle, Path(name)
        fcntl.flock(handle, fcntl.LOCK_EX)
        with suppress(OSError):
            if os.path.samestat(os.fstat(handle), Path(name).stat()):
                return handle, Path(name)
        os.close(handle)


def _remove_abandoned(directory: Path, prefix: str) -> None:
    """Remove the new files in *directory* whose process was killed before it was done."""
    with suppress(OSError):
        for path in directory.glob(f"{prefix}*{SUFFIX}"):
            with suppress(OSError):
                if fcntl is None:
                    path.unlink()
                    continue
                with path.open("rb") as stream:
                    fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
                    path.unlink()


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask
