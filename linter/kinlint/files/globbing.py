"""The paths that a glob pattern stands for, found without following links to directories."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from pathlib import Path

from kinlint.files.pathglob import MAGIC, absolute, translate

ANY_DEPTH = "**"


def matches(
    pattern: str, skip: Callable[[Path], bool], unreadable: Callable[[OSError], None]
) -> list[Path]:
    """Return the absolute paths that *pattern* matches, sorted.

    `*` and the like match no name with a leading dot unless they have one; `**` is any number of
    directories, `{a,b}` is either. What wildcards stand for and *skip* is true of is not looked
    into. Links to directories are followed only where the pattern says so, so that loops end.
    """
    from kinlint.files.glob_alternatives import alternatives  # noqa: PLC0415  few runs

    found = set[Path]()
    for alternative in filter(None, alternatives(pattern)):
        parts = Path(os.path.expanduser(alternative)).parts  # noqa: PTH111  never fails
        fixed = next((i for i, part in enumerate(parts) if MAGIC.search(part)), len(parts))
        # Several ** in a row mean what one means, and would be walked many times.
        rest = [
            part
            for before, part in pairwise(("", *parts[fixed:]))
            if not before == part == ANY_DEPTH
        ]
        found.update(_Walk(skip, unreadable).below(absolute(Path(*parts[:fixed])), rest))
    return sorted(found)


class _Walk:
    """A walk that passes over what `skip` says, and tells `unreadable` of what it cannot see."""

    def __init__(self, skip: Callable[[Path], bool], unreadable: Callable[[OSError], None]) -> None:
        self._skip = skip
        self._unreadable = unreadable

    def below(self, base: Path, parts: Sequence[str]) -> Iterator[Path]:
        """Yield the matches of *parts* of a pattern below *base*."""
        if not parts:
            yield base
            return
        head, rest = parts[0], parts[1:]
        if not MAGIC.search(head):
            if os.path.lexists(base / head):
                yield from self.below(base / head, rest)
            return
        if head == ANY_DEPTH:
            yield from self._at_any_depth(base, parts)
            return
        for entry in self._entries(base, head):
            if not rest or entry.is_dir():
                yield from self.below(base / entry.name, rest)

    def _at_any_depth(self, base: Path, parts: Sequence[str]) -> Iterator[Path]:
        """Yield the same for *parts* that begin with `**`."""
        rest = parts[1:]
        if rest:
            yield from self.below(base, rest)
        for entry in self._entries(base, "*"):
            if entry.is_dir(follow_symlinks=False):
                yield from self.below(base / entry.name, parts)
            elif not rest:
                yield base / entry.name

    def _entries(self, base: Path, wanted: str) -> list[os.DirEntry[str]]:
        """Return the entries of *base* that match the wildcards of *wanted*."""
        name = re.compile(translate(wanted), re.DOTALL)
        hidden = wanted.startswith(".")
        return [
            entry
            for entry in self._all(base)
            if name.fullmatch(entry.name)
            and (hidden or not entry.name.startswith("."))
            and not self._skip(base / entry.name)
        ]

    def _all(self, base: Path) -> list[os.DirEntry[str]]:
        try:
            with os.scandir(base) as entries:
                return sorted(entries, key=lambda entry: entry.name)
        except (FileNotFoundError, NotADirectoryError):
            return []
        except OSError as error:
            self._unreadable(error)
            return []
