"""Divides the files of a run into independent groups."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import PurePath
from typing import NamedTuple

from kinlint.file_format import Format
from kinlint.formats.dependencies.mentions import Mentions, is_pattern
from kinlint.formats.launch.format import LAUNCH
from kinlint.formats.recognition import with_format
from kinlint.formats.yaml.format import YAML
from kinlint.text import SourceText

CONFIGURATIONS = (YAML, LAUNCH)
"""Formats whose files belong to robots that were found for them, or to none."""
PAIR = 2
"""Number of files that are compared whatever their names."""


class JoinKeys(NamedTuple):
    """Properties that may join a file to others: format, names of robots, included files."""

    format: Format | None
    """Format of the file; None if it is not recognised."""
    robots: frozenset[str] = frozenset()
    """Names of the robots that it describes."""
    included: tuple[str, ...] = ()
    """Paths of the files that it includes."""


def join_keys(source: SourceText) -> JoinKeys:
    """Return the keys of *source*."""
    form = with_format(source).format
    if form is None or not form.describes_robots:
        return JoinKeys(form)
    found = Mentions(source)
    return JoinKeys(form, frozenset(name.casefold() for name in found.robots), found.included)


def group_sources(
    sources: Sequence[SourceText], known: Callable[[SourceText], JoinKeys] = join_keys
) -> Iterator[list[SourceText]]:
    """Yield *sources* in independent groups, in the order of their first members.

    Composable files make one model, together with all others, since names may join them. Files of
    elements belong together if they describe robots of one name, or if one may include the other,
    or both the same file; so do those of one name but for the suffix, and two of different formats
    that are alone, which are compared whatever their robots are called. An SRDF, which need not
    name its robot correctly, joins all; so does a robot whose name is computed, where robots in
    another format may be the same. *known* returns the keys of a source. A YAML file belongs to the
    robots that it was paired with, a launch file to none.
    """
    if any(each.format in CONFIGURATIONS for each in sources):
        yield from _with_configurations(sources, known)
        return
    tied = [known(source) for source in sources]
    forms = {each.format for each in tied}
    if not all(form and form.describes_robots for form in forms):
        yield list(sources)
        return
    if len(forms) > 1 and any("$" in name for each in tied for name in each.robots):
        yield list(sources)
        return
    yield from _listed(sources, _joined(sources, tied))


def _with_configurations(
    sources: Sequence[SourceText], known: Callable[[SourceText], JoinKeys]
) -> Iterator[list[SourceText]]:
    """Yield the groups of *sources* with YAML files in those of their robots."""
    others = [each for each in sources if each.format not in CONFIGURATIONS]
    groups = _Groups(len(sources))
    place = {id(each): index for index, each in enumerate(sources)}
    names = {each.name: index for index, each in enumerate(sources)}
    for group in group_sources(others, known) if others else ():
        for each in group:
            groups.join(place[id(group[0])], place[id(each)])
    for index, each in enumerate(sources):
        pairing = each.pairing if each.format == YAML else None
        joined = () if pairing is None else (pairing.partner, *pairing.others, *pairing.annotations)
        for name in joined:
            if name in names:
                groups.join(index, names[name])
    yield from _listed(sources, groups)


def _listed(sources: Sequence[SourceText], groups: _Groups) -> Iterator[list[SourceText]]:
    found: dict[int, list[SourceText]] = {}
    for index, source in enumerate(sources):
        found.setdefault(groups.first(index), []).append(source)
    yield from found.values()


def _joined(sources: Sequence[SourceText], tied: Sequence[JoinKeys]) -> _Groups:
    """Return the groups of *sources* by the names of robots and included files in *tied*."""
    groups = _Groups(len(sources))
    robots: dict[str, int] = {}
    users: dict[str, int] = {}
    files: dict[str, list[int]] = {}
    stems: dict[tuple[PurePath, str], int] = {}
    if len({each.format for each in tied}) == len(tied) == PAIR:
        groups.join(0, 1)
    for index, source in enumerate(sources):
        path = PurePath(source.name)
        stem = path.parent, path.name.partition(".")[0].casefold()
        groups.join(index, stems.setdefault(stem, index))
        for name in tied[index].robots:
            groups.join(index, robots.setdefault(name, index))
        for part in path.parts[-3:]:
            files.setdefault(part, []).append(index)
    for index, each in enumerate(tied):
        for meant in each.included:
            groups.join(index, users.setdefault(meant, index))
    mixed = [index for index, each in enumerate(tied) if each.format and each.format.expands_to]
    for meant, index in users.items():
        for other in mixed if is_pattern(meant) else files.get(meant, ()):
            groups.join(index, other)
    return groups


class _Groups:
    """Numbers from 0 that are joined into groups, each known by its least."""

    def __init__(self, size: int) -> None:
        self._above = list(range(size))

    def first(self, one: int) -> int:
        """Return the least number of the group of *one*."""
        while self._above[one] != one:
            self._above[one] = self._above[self._above[one]]
            one = self._above[one]
        return one

    def join(self, one: int, other: int) -> None:
        """Make one group of those of *one* and *other*."""
        least, most = sorted((self.first(one), self.first(other)))
        self._above[most] = least
