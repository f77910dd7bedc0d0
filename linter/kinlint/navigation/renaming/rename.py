"""Renames a thing in all files of a model, if that changes nothing else."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from kinlint.addresses import is_address
from kinlint.configuration.settings import Settings
from kinlint.finding import TextEdit
from kinlint.fixes.texts import Texts
from kinlint.light_dataclasses import dataclass
from kinlint.navigation.index import Index
from kinlint.navigation.occurrence import Entity, Occurrence, Role
from kinlint.navigation.renaming.macro_places import call_places
from kinlint.navigation.renaming.named_thing import NamedThing, exists, things
from kinlint.navigation.renaming.rename_proof import prove
from kinlint.navigation.renaming.renaming_error import NotRenamable
from kinlint.pipeline.analyzer import Examination
from kinlint.text import Location, Span

EVALUATED = "$"
ARGUMENT = "argument"
_COMPUTED = re.compile(r"[^${}()]*\$.*[})](?P<tail>[^${}()]+)|(?P<head>[^${}()]+)\$.*", re.DOTALL)


class Computed(NamedTuple):
    """Parts of a name that an expression of xacro computes at a place, empty by default."""

    before: str = ""
    """Part before the one that is written out."""
    after: str = ""
    """Part behind it."""


@dataclass(frozen=True)
class Renaming:
    """Things that share a name at a place, and all places of the name."""

    things: Sequence[NamedThing]
    """The things; several where a file is read more than once, such as a model that is included,
    or where a macro makes one at each call."""
    places: Mapping[Location, Mapping[Entity, Computed]]
    """The places where names, or parts of them, are written out, with the things named there."""

    @property
    def name(self) -> str:
        """The name that they have."""
        return self.things[0].name


class Renamer:
    """Renames in the files of one model, which *index* has; *is_ours* tells the files to change."""

    def __init__(self, index: Index, is_ours: Callable[[Path], bool]) -> None:
        self._index, self._is_ours = index, is_ours

    def prepare(self, name: str, offset: int) -> tuple[Renaming, Span]:
        """Return what is renamed at *offset* of the text called *name*, and where it stands there.

        Raises `NotRenamable`.
        """
        found = self._index.at(name, offset)
        named = things([each.entity for each in found])
        if not named:
            raise NotRenamable("nothing that can be renamed is named here")
        renaming = self._renaming(named)
        paths = self._index.paths
        for place in renaming.places:
            start, end = place.span
            if paths[place.source.name] == paths[name] and start <= offset <= end:
                return renaming, place.span
        raise NotRenamable(f"{named[0].kind} '{named[0].name}' is called by another name here")

    def edits(
        self, renaming: Renaming, new: str, made: Examination, texts: Texts, settings: Settings
    ) -> Sequence[TextEdit]:
        """Return the edits that have *renaming* called *new*; the graph changes by no more.

        *made* is the examination of *texts*. *new* may have the prefix or namespace of a node, too.
        Raises `NotRenamable`.
        """
        new = renaming.things[0].local(new, next(iter(renaming.places)))
        known = {each.entity for each in self._index.occurrences if each.role is Role.DESCRIPTION}
        names, written = _new_names(renaming, new)
        for thing in renaming.things:
            name = names[thing.entity]
            thing.renamed(name)
            if name != thing.name and exists(thing, name, known):
                raise NotRenamable(f"{thing.kind} '{name}' exists already")
        found = [TextEdit(place, text) for place, text in written.items()]
        nodes = [each for each in renaming.things if each.definition is None]
        meant = {each.entity: each.renamed(names[each.entity]) for each in nodes}
        prove(found, meant, made, texts, settings)
        return found

    def _renaming(self, named: Sequence[NamedThing]) -> Renaming:
        """Return all that is called by the name of *named*, with all places of the name."""
        places: dict[Location, dict[Entity, Computed]] = {}
        first = named[0]
        waiting = [each for each in named if each.name == first.name]
        known = {each.entity: each for each in waiting}
        while waiting:
            thing = waiting.pop()
            self._check_kind(thing)
            for each in self._mentions(thing):
                found = self._place(thing, each)
                if found is None:
                    continue
                place, computed = found
                places.setdefault(place, {})[thing.entity] = computed
                for other in self._sharing(thing, each, place, computed):
                    if other.entity not in known:
                        known[other.entity] = other
                        waiting.append(other)
            sources = {s.name: s for one in self._index.documents for s in one.sources}
            for place in call_places(thing.entity, sources.values()):
                places.setdefault(place, {})[thing.entity] = Computed()
        self._check_places(first, places)
        return Renaming([*known.values()], dict(sorted(places.items(), key=_order)))

    def _sharing(
        self, thing: NamedThing, named: Occurrence, place: Location, computed: Computed
    ) -> Iterator[NamedThing]:
        """Yield what changes its name with *thing*, as it is named by the same words at *place*."""
        for each in self._index.at(place.source.name, place.span.start):
            if each.location == named.location:
                for other in things([each.entity]):
                    written = each.location.source[each.location.span]
                    if other.name == thing.name or (
                        computed != Computed() and _computed(other.name, written) is not None
                    ):
                        yield other

    def _check_kind(self, thing: NamedThing) -> None:
        if thing.kind == ARGUMENT and thing.definition is not None:
            raise NotRenamable(
                f"argument '{thing.name}' is given by launch files and on command lines,"
                " which are not read"
            )
        if thing.definition is None and not self._index.descriptions([thing.entity]):
            raise NotRenamable(f"'{thing.name}' is described in no file of the model")

    def _mentions(self, thing: NamedThing) -> list[Occurrence]:
        """Return every place that names *thing*, or something by a path through it."""
        inside = f"{thing.entity[:-1]}/"
        return [
            each
            for each in self._index.occurrences
            if each.entity == thing.entity
            or (is_address(thing.entity) and each.entity.startswith(inside))
        ]

    def _place(self, thing: NamedThing, each: Occurrence) -> tuple[Location, Computed] | None:
        """Return the part of a place that is the name of *thing*, or that part of the name.

        None if there is none.
        """
        source, span = each.location.source, each.location.span
        written, computed = source[span], Computed()
        part = thing.part_of(written, each.entity)
        if part is None:
            if each.entity != thing.entity or EVALUATED not in written:
                return None
            found = _computed(thing.name, written)
            if found is None:
                line = f"{source.name}:{each.location.start.line}"
                raise NotRenamable(
                    f"the name of {thing.kind} '{thing.name}' is put together by '{written}'"
                    f" at {line}: rename what it is put together from"
                )
            part, computed = found
        return Location(source, Span(span.start + part[0], span.start + part[1])), computed

    def _check_places(self, thing: NamedThing, places: Iterable[Location]) -> None:
        if not places:
            raise NotRenamable(f"no file writes the name of {thing.kind} '{thing.name}' as it is")
        for place in places:
            if not self._is_ours(self._index.paths[place.source.name]):
                raise NotRenamable(
                    f"{thing.kind} '{thing.name}' is named in {place.source.name},"
                    " which is outside of the workspace"
                )


def _computed(name: str, written: str) -> tuple[tuple[int, int], Computed] | None:
    """Return the part of *written*, an expression of *name*, that is written out, and the rest.

    That is the end, if it is, else the beginning; None if neither is.
    """
    match = _COMPUTED.fullmatch(written)
    if match is None:
        return None
    if match["tail"]:
        found = match.span("tail"), Computed(before=name.removesuffix(match["tail"]))
    else:
        found = match.span("head"), Computed(after=name.removeprefix(match["head"]))
    return None if name in found[1] else found


def _new_names(renaming: Renaming, new: str) -> tuple[Mapping[Entity, str], Mapping[Location, str]]:
    """Return the new name of each thing, and what is written at each place.

    The first thing is called *new*. Others that are named by the same words, such as what a macro
    makes at its next call, keep what is computed of their names. Raises `NotRenamable`.
    """
    first = renaming.things[0]
    names = {each.entity: new for each in renaming.things if each.name == first.name}
    written: dict[Location, str] = {}
    known = -1
    while known < len(written):
        known = len(written)
        for place, named in renaming.places.items():
            for entity, (before, after) in named.items():
                if entity not in names:
                    continue
                name = names[entity]
                end = len(name) - len(after)
                text = name[len(before) : end]
                if (before or after) and (not text or before + text + after != name):
                    kept = f"begins with '{before}'" if before else f"ends with '{after}'"
                    line = f"{place.source.name}:{place.start.line}"
                    raise NotRenamable(f"the name {kept}, which is computed at {line}")
                if written.setdefault(place, text) != text:
                    raise NotRenamable("the places of the name would differ")
                for other, (head, tail) in named.items():
                    names.setdefault(other, head + text + tail)
    if len(written) < len(renaming.places) or len(names) < len(renaming.things):
        raise NotRenamable("the places of the name would differ")
    return names, written


def _order(item: tuple[Location, object]) -> tuple[str, Span]:
    return item[0].source.name, item[0].span
