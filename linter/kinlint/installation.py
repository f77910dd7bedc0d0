"""The files of this installation, and digests of them that are kept from one run to the next.

Reading all files takes longer than linting a small model. Digests of their contents therefore hold
for as long as no file changes its size, times or inode, which is how Python itself tells whether
byte code is that of a module.
"""

from __future__ import annotations

import json
import os
import stat
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import cached_property
from hashlib import sha256
from pathlib import Path
from typing import Any, TypeAlias

from kinlint import resources
from kinlint.files.cache_file import UNDONE, write_cache_file
from kinlint.light_dataclasses import dataclass

STORED = ("digests-*.json", f"digests-*{UNDONE}")
"""Patterns for the names of files with digests in a cache, and of those being written."""
SETTLED = 2.0
"""Age in seconds from which files count as complete: changes within a tick of the clock of a file
system cannot be told apart.
"""
InstalledFile: TypeAlias = tuple[str, int, int, int, int]
"""A file of the package, of `rules/` or of `shapes/`.

Its absolute path, the times of its last modification and change in nanoseconds, its size in bytes
and the number of its inode.
"""


def _files_below(top: str) -> Iterator[InstalledFile]:
    directories = [top]
    while directories:
        with os.scandir(directories.pop()) as entries:
            for each in entries:
                if each.is_dir():
                    if each.name != "__pycache__":
                        directories.append(each.path)
                    continue
                now = each.stat()
                yield each.path, now.st_mtime_ns, now.st_ctime_ns, now.st_size, now.st_ino


@dataclass(frozen=True)
class Installation:
    """The files of this installation, as they are when they are first asked for."""

    @cached_property
    def files(self) -> tuple[InstalledFile, ...]:
        """The files, sorted by path; byte code does not count."""
        package = Path(__file__).parent
        tops = {package, resources.data("rules"), resources.data("shapes")}
        outer = (top for top in tops if package not in top.parents)
        return tuple(sorted(each for top in outer for each in _files_below(str(top))))

    def paths_below(self, directory: Path, suffix: str) -> list[str]:
        """Return the paths of files below *directory* that end in *suffix*, sorted."""
        top = f"{directory}{os.sep}"
        return [each for each, *_ in self.files if each.startswith(top) and each.endswith(suffix)]

    def digest(self, name: str, cache: Path | None, make: Callable[[], str]) -> str:
        """Return the digest *name* of files, which *make* computes unless *cache* has it."""
        if cache is None:
            return make()
        place = cache / self._name
        kept = _read(place)
        digests: dict[str, str] = kept["digests"] if kept.get("stamp") == self._stamp else {}
        if not isinstance(found := digests.get(name), str):
            found = make()
            newest = max(max(changes) for _, *changes, _, _ in self.files)
            if newest < (time.time() - SETTLED) * 1e9:
                _write(place, {"stamp": self._stamp, "digests": {**digests, name: found}})
        return found

    @cached_property
    def _name(self) -> str:
        """The name of the file with the digests, one for each installation."""
        place = str(Path(__file__).parent)
        return f"digests-{sha256(place.encode('utf-8', 'surrogatepass')).hexdigest()[:12]}.json"

    @cached_property
    def _stamp(self) -> str:
        """A digest that changes whenever a file of the installation does."""
        return sha256(repr(self.files).encode()).hexdigest()


def _read(path: Path) -> dict[str, Any]:
    """Return the digests kept at *path*, if this user wrote them."""
    try:
        with path.open("rb") as stream:
            about = os.fstat(stream.fileno())
            own = not hasattr(os, "geteuid") or about.st_uid == os.geteuid()
            kept = json.load(stream) if own and stat.S_ISREG(about.st_mode) else None
    except (OSError, ValueError):
        return {}
    return kept if isinstance(kept, dict) and isinstance(kept.get("digests"), dict) else {}


def _write(path: Path, kept: dict[str, Any]) -> None:
    """Keep *kept* at *path*; where that is impossible, the next run computes it again."""
    with suppress(OSError):
        write_cache_file(path, json.dumps(kept).encode())
