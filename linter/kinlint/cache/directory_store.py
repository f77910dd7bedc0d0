"""A directory of texts by key: each written as a whole or not at all, the oldest going first.

Several processes may use it at once. What is damaged, foreign or cannot be read is as good as
absent, and what cannot be written is not kept: a cache costs time at worst, never the run.
"""

from __future__ import annotations

import os
import stat
import time
from collections.abc import Iterator
from contextlib import suppress
from hashlib import sha256
from pathlib import Path

from kinlint.files.cache_file import UNDONE, write_cache_file
from kinlint.light_dataclasses import dataclass

BEGIN, END = "report-", ".json"
MOST_BYTES = 128 * 2**20
"""Size in bytes at which the oldest entries are removed."""
KEPT = 0.75
ABANDONED = 3600.0
"""After how many seconds what nobody finished writing is nobody's."""


@dataclass(frozen=True)
class DirectoryStore:
    """Texts that are kept in a directory."""

    folder: Path
    """Directory of the texts; it is made with the first of them."""

    def get(self, key: str) -> str | None:
        """The text of *key* as it was put, if it is there and ours; it counts as new again."""
        try:
            with self._path(key).open("rb") as stream:
                if not _ours(os.fstat(stream.fileno())):
                    return None
                digest, _, data = stream.read().partition(b"\n")
            if _digest(key, data) != digest:
                return None
            text = data.decode()
        except (OSError, ValueError):
            return None
        with suppress(OSError):
            os.utime(self._path(key))
        return text

    def put(self, key: str, text: str) -> None:
        """Keep *text* under *key*."""
        data = text.encode()
        with suppress(OSError):
            write_cache_file(self._path(key), _digest(key, data) + b"\n" + data)

    def bound(self, most: int = MOST_BYTES) -> None:
        """Let the oldest go if all have more than *most* bytes, and what was never finished."""
        with suppress(OSError):
            found = sorted(self._found(), key=lambda one: one[1].st_mtime)
            size, over = sum(about.st_size for _, about in found), False
            abandoned = time.time() - ABANDONED
            for path, about in found:
                over = over or size > most
                stale = path.suffix == UNDONE and about.st_mtime < abandoned
                if stale or (over and size > most * KEPT):
                    path.unlink(missing_ok=True)
                    size -= about.st_size

    def clear(self) -> tuple[int, int]:
        """Remove all, and the directory if nothing else is in it: how many, and their bytes.

        Raises OSError if something cannot be removed.
        """
        count = size = 0
        for path, about in list(self._found()):
            path.unlink(missing_ok=True)
            count, size = count + 1, size + about.st_size
        with suppress(OSError):
            self.folder.rmdir()
        return count, size

    def _path(self, key: str) -> Path:
        return self.folder / f"{BEGIN}{key}{END}"

    def _found(self) -> Iterator[tuple[Path, os.stat_result]]:
        if not self.folder.is_dir():
            return
        with os.scandir(self.folder) as entries:
            for each in entries:
                if not each.name.startswith(BEGIN) or not each.name.endswith((END, UNDONE)):
                    continue
                with suppress(FileNotFoundError):
                    yield Path(each.path), each.stat(follow_symlinks=False)


def _digest(key: str, data: bytes) -> bytes:
    """Return a digest that *data* has under *key* only, so that no entry passes for another."""
    return sha256(f"{key}\n".encode() + data).hexdigest().encode()


def _ours(about: os.stat_result) -> bool:
    """Tell whether a file is a regular one that this user wrote."""
    return stat.S_ISREG(about.st_mode) and (
        not hasattr(os, "geteuid") or about.st_uid == os.geteuid()
    )
