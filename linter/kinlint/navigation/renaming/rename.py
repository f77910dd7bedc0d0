"""Renames a thing in all files of a model, if that changes nothing else."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from kinlint.addresses import is_address
from kinlint.configuration.settings import Settings
from kinlint.finding import TextEdit
from kinlint.fixes.texts import Texts
from kinlint.light_dataclasses import dataclass
from kinlint.navigation.index import Index
from kinlint.navigation.occurrence import Occurrence, Role
from kinlint.navigation.renaming.macro_places import call_places
from kinlint.navigation.renaming.named_thing import NamedThing, exists, things
from kinlint.navigation.renaming.rename_proof import prove
from kinlint.navigation.renaming.renaming_error import NotRenamable
from kinlint.pipeline.analyzer import Examination
from kinlint.text import Location, Span

EVALUATED = "$"
ARGUMENT = "argument"


@dataclass(frozen=True)
class Renaming:
    """Things that share a name at a place, and all places of the name."""

    things: Sequence[NamedThing]
    """The things; several where a file is read more than once, such as a model that is included."""
    places: Mapping[Location, None]
    """The places of the name."""

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
        for thing in renaming.things:
            thing.renamed(new)
            if new != thing.name and exists(thing, new, known):
                raise NotRenamable(f"{thing.kind} '{new}' exists already")
        found = [TextEdit(place, new) for place in renaming.places]
        nodes = [each for each in renaming.things if each.definition is None]
        meant = {each.entity: each.renamed(new) for each in nodes}
        prove(found, meant, made, texts, settings)
        return found

    def _renaming(self, named: Sequence[NamedThing]) -> Renaming:
        """Return all that is called by the name of *named*, with all places of the name."""
        places: dict[Location, None] = {}
        waiting, known = list(named), dict.fromkeys(each.entity for each in named)
        first = named[0]
        while waiting:
            thing = waiting.pop()
            if thing.name != first.name:
                continue
            self._check_kind(thing)
            for each in self._mentions(thing):
                place = self._place(thing, each)
                if place is None or place in places:
                    continue
                places[place] = None
                for other in self._index.at(place.source.name, place.span.start):
                    if other.entity not in known and other.location == each.location:
                        known[other.entity] = None
                        waiting += [one for one in things([other.entity]) if one.name == first.name]
            sources = {s.name: s for one in self._index.documents for s in one.sources}
            places |= dict.fromkeys(call_places(thing.entity, sources.values()))
        found = [each for each in map(NamedThing, known) if each.name == first.name]
        self._check_places(first, places)
        return Renaming(found, dict(sorted(places.items(), key=_order)))

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

    def _place(self, thing: NamedThing, each: Occurrence) -> Location | None:
        """Return the part of a place that is the name of *thing*; None if it has none."""
        source, span = each.location.source, each.location.span
        written = source[span]
        part = thing.part_of(written, each.entity)
        if part is None:
            if each.entity == thing.entity and EVALUATED in written:
                line = f"{source.name}:{each.location.start.line}"
                raise NotRenamable(
                    f"the name of {thing.kind} '{thing.name}' is put together by '{written}'"
                    f" at {line}: rename what it is put together from"
                )
            return None
        return Location(source, Span(span.start + part[0], span.start + part[1]))

    def _check_places(self, thing: NamedThing, places: Mapping[Location, None]) -> None:
        if not places:
            raise NotRenamable(f"no file writes the name of {thing.kind} '{thing.name}' as it is")
        for place in places:
            if not self._is_ours(self._index.paths[place.source.name]):
                raise NotRenamable(
                    f"{thing.kind} '{thing.name}' is named in {place.source.name},"
                    " which is outside of the workspace"
                )


def _order(item: tuple[Location, None]) -> tuple[str, Span]:
    return item[0].source.name, item[0].span
