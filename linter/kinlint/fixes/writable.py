"""Tells which of the files that others include may be written."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path

from kinlint.configuration.settings import Settings
from kinlint.edits import NotExpressible
from kinlint.files.environment import kind, writable
from kinlint.files.installed_files import SYSTEM
from kinlint.files.packages import SKIPPED
from kinlint.files.pathname import real
from kinlint.fixes.texts import Texts
from kinlint.light_dataclasses import dataclass


@dataclass(frozen=True)
class WritableFiles:
    """The files that may be written."""

    given: frozenset[Path]
    """Real paths of files that were named themselves."""
    roots: tuple[Path, ...]
    """Directories whose files may be written, unless they are installed or made there."""

    @classmethod
    def from_texts(cls, texts: Texts, settings: Settings) -> WritableFiles:
        """Return those below the directory that all given files share, or where kinlint works."""
        named = [each for each in texts.given if not each.companion]
        given = [path for each in named if kind(path := texts.path(each)) == "file"]
        spaces = {settings.for_file(each.name).workspace for each in named}
        roots = {Path.cwd(), *(real(each) for each in spaces if each is not None)}
        if given:
            roots.add(_shared(path.parent for path in given))
        return cls(frozenset(given), tuple(each for each in roots if each != each.parent))

    def check(self, path: Path, name: str) -> None:
        """Raise `NotExpressible` if the file at *path*, called *name*, is not to be written."""
        if path in self.given:
            return
        if not any(_holds(root, path) for root in self.roots):
            raise NotExpressible(f"it is written in {name}, which is not among the linted files")
        if not writable(path):
            raise NotExpressible(f"it is written in {name}, which cannot be written to")


def _holds(root: Path, path: Path) -> bool:
    """Tell whether *path* lies below *root*, and is neither installed nor made there."""
    if not path.is_relative_to(root) or any(path.is_relative_to(each) for each in SYSTEM):
        return False
    return SKIPPED.isdisjoint(path.relative_to(root).parts)


def _shared(directories: Iterable[Path]) -> Path:
    try:
        return Path(os.path.commonpath(list(directories)))
    except ValueError:  # several drives
        return Path.cwd()
