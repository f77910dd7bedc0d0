"""The texts of files: what is open, else what the disk holds, read again when it changed."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TypeAlias

from kinlint.errors import SourceError
from kinlint.files.pathname import real
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.project.discovery import Input
from kinlint.project.reading import read_source
from kinlint.server.frozen_state import FrozenState
from kinlint.text import SourceText

Stamp: TypeAlias = tuple[int, int] | None


@dataclass
class DocumentStore:
    """The texts at one moment, of which equal ones stay the same objects from one to the next."""

    snapshot: FrozenState
    """Open texts and files at one moment."""
    _kept: dict[Path, tuple[Stamp, SourceText | SourceError]] = field(default_factory=dict)
    _seen: set[Path] = field(default_factory=set)
    _overlay: Mapping[Path, SourceText] = field(default_factory=dict)
    _renamed: dict[str, tuple[SourceText, SourceText]] = field(default_factory=dict)

    def advance(self, snapshot: FrozenState) -> None:
        """Go on to *snapshot*; files are looked at again if something happened on disk."""
        if snapshot.epoch != self.snapshot.epoch:
            self._kept = {path: kept for path, kept in self._kept.items() if path in self._seen}
            self._seen.clear()
            self._renamed.clear()
        self.snapshot = snapshot
        self._overlay = {real(path): each.source for path, each in snapshot.buffers.items()}

    @property
    def overlay(self) -> Mapping[Path, SourceText]:
        """The open texts by the real paths of their files."""
        return self._overlay

    def text(self, one: Input) -> SourceText:
        """Return the text of *one*: the open buffer, or the file.

        Raises `SourceError` if it is unreadable.
        """
        assert one.path is not None
        if (buffer := self.snapshot.buffers.get(one.path)) is not None:
            return self._called(one.name, buffer.source)
        kept = self._kept.get(one.path)
        if kept is None or one.path not in self._seen:
            now = stamp(one.path)
            if kept is None or kept[0] != now or kept[1].name != one.name:
                kept = now, _read(one)
                self._kept[one.path] = kept
            self._seen.add(one.path)
        if isinstance(kept[1], SourceError):
            raise kept[1]
        return kept[1]

    def _called(self, name: str, source: SourceText) -> SourceText:
        """Return *source* by *name*, which is another where the working directory is another."""
        if source.name == name:
            return source
        before, renamed = self._renamed.get(name, (None, source))
        if before is not source:
            renamed = replace(source, name=name)
            self._renamed[name] = source, renamed
        return renamed


def _read(one: Input) -> SourceText | SourceError:
    try:
        return read_source(one)
    except SourceError as error:
        return error


def stamp(path: Path) -> Stamp:
    """Return modification time and size of the file at *path*; None if there is none."""
    try:
        state = path.stat()
    except (OSError, ValueError):
        return None
    return state.st_mtime_ns, state.st_size


def stamps(paths: Iterable[Path]) -> tuple[tuple[str, Stamp], ...]:
    """Return the stamps of the files at *paths*, directories followed."""
    found: dict[str, Stamp] = {}
    for path in paths:
        below = sorted(path.rglob("*")) if path.is_dir() else [path]
        found |= {str(one): stamp(one) for one in below}
    return tuple(found.items())
