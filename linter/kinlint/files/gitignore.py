"""Ignored files of git: patterns of `.gitignore` and `.git/info/exclude` (gitignore(5))."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from kinlint.files.bounded_read import head
from kinlint.files.packages import REPOSITORY, SOURCE
from kinlint.light_dataclasses import dataclass, field

if TYPE_CHECKING:
    from pathspec import GitIgnoreSpec

Patterns: TypeAlias = "tuple[Path, GitIgnoreSpec]"
"""Patterns, and the directory that they start at."""
FILE = ".gitignore"
EXCLUDE = "info/exclude"
SIZE = 1 << 20
"""Number of bytes of a file of patterns that are read."""


class Rules(NamedTuple):
    """Patterns that hold in a directory."""

    versioned: bool
    """True if the directory lies in a repository."""
    patterns: tuple[Patterns, ...] = ()
    """Patterns, the innermost last."""


@dataclass
class GitIgnore:
    """Ignored files in a walk from `top`, which itself is wanted even if git ignores it.

    In a repository its files of patterns count, outside of one those at or below `outer`.
    """

    top: Path
    """Directory in which the walk begins."""
    outer: Path
    """Outermost directory whose patterns count where there is no repository."""
    _known: dict[Path, Rules] = field(default_factory=dict)

    def ignores(self, path: Path, *, directory: bool) -> bool:
        """Tell whether *path*, which lies below `top`, is ignored."""
        rules = self._rules(path.parent).patterns
        if not rules or not _matched(path, rules, directory=directory):
            return False
        if path != self.top and self.ignores(self.top, directory=True):
            own = [each for each in rules if each[0].is_relative_to(self.top)]
            return _matched(path, own, directory=directory)
        return not (directory and _is_checkout(path))

    def _rules(self, directory: Path) -> Rules:
        if directory not in self._known:
            self._known[directory] = self._read(directory)
        return self._known[directory]

    def _read(self, directory: Path) -> Rules:
        if (directory / REPOSITORY).exists():
            files = (directory / REPOSITORY / EXCLUDE, directory / FILE)
            return Rules(versioned=True, patterns=tuple(_patterns(directory, *files)))
        top = directory == directory.parent
        above = Rules(versioned=False) if top else self._rules(directory.parent)
        if not above.versioned and not directory.is_relative_to(self.outer):
            return above
        own = _patterns(directory, directory / FILE)
        return Rules(above.versioned, (*above.patterns, *own))


def _patterns(directory: Path, *files: Path) -> Iterator[Patterns]:
    """Yield the patterns in *files*, which start at *directory*."""
    lines = [line for file in files for line in (head(file, SIZE) or "").splitlines()]
    if lines:
        yield directory, _compiled(lines)


def _compiled(lines: list[str]) -> GitIgnoreSpec:
    from pathspec import GitIgnoreSpec  # noqa: PLC0415  only where something is ignored

    try:
        return GitIgnoreSpec.from_lines(lines)
    except ValueError:
        if len(lines) == 1:  # git passes over a pattern that is none
            return GitIgnoreSpec.from_lines([])
        each = [pattern for line in lines for pattern in _compiled([line]).patterns]
        return GitIgnoreSpec(each)


def _matched(path: Path, rules: Sequence[Patterns], *, directory: bool) -> bool:
    """Tell whether the last of *rules* that speaks of *path* ignores it."""
    for base, patterns in reversed(rules):
        name = path.relative_to(base).as_posix() + "/" * directory
        if (found := patterns.check_file(name).include) is not None:
            return found
    return False


def _is_checkout(path: Path) -> bool:
    """Tell whether *path* is the `src` of a workspace with repositories, or one of these.

    Workspaces that vcstool fills ignore them, and they are what is worked on.
    """
    if path.name == SOURCE:
        try:
            return any((each / REPOSITORY).exists() for each in path.iterdir())
        except OSError:
            return False
    return path.parent.name == SOURCE and (path / REPOSITORY).exists()
