"""Things that can be renamed: their name, and what it may become."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from urllib.parse import unquote

from kinlint.addresses import enclosing, is_address, is_element, last_tag, local_name, sibling
from kinlint.light_dataclasses import dataclass
from kinlint.navigation.occurrence import CLASS, Entity
from kinlint.navigation.renaming.renaming_error import NotRenamable
from kinlint.navigation.xacro_names import label
from kinlint.terms import iri_value, is_iri
from kinlint.text import Location

SEPARATOR = "::"
"""Mark between the names of models, each in the one before, and of what is in the last."""
IDENTIFIER = re.compile(r"[^\W\d]\w*")
TAG = re.compile(r"[^\W\d][\w.-]*")
NAME = re.compile(r"[^\s<>&\"'$](?:[^<>&\"'$\r\n\t]*[^\s<>&\"'$])?")
LOCAL = re.compile(r"[\w.~-]+")
OPENING = frozenset({'"', "<", " ", "\t", "\n"})
"""Characters before the name of a node of a graph."""
_LOCAL_PART = re.compile(r"[^#/:]*\Z")


@dataclass(frozen=True)
class NamedThing:
    """Something that has a name, by which it is called in other places."""

    entity: Entity
    """The entity."""

    @property
    def definition(self) -> tuple[str, str] | None:
        """The kind and name of what xacro defines and of default classes; None of anything else."""
        return label(self.entity)

    @property
    def name(self) -> str:
        """The name that changes: of an IRI, what stands behind its namespace."""
        if self.definition is not None:
            return self.definition[1]
        if is_address(self.entity):
            return local_name(self.entity) if is_element(self.entity) else ""
        found = _LOCAL_PART.search(iri_value(self.entity)) if is_iri(self.entity) else None
        return unquote(found[0]) if found else ""

    @property
    def kind(self) -> str:
        """The kind in a word, such as `link`."""
        if self.definition is not None:
            return self.definition[0]
        return last_tag(self.entity) if is_address(self.entity) else "node"

    def renamed(self, name: str) -> Entity:
        """Return the entity with another *name*; raises `NotRenamable` where that is none."""
        if self.definition is not None:
            form = {"macro": TAG, CLASS: NAME}.get(self.kind, IDENTIFIER)
            _check(form, name, f"the name of a {self.kind}")
            return self.entity
        if is_address(self.entity):
            _check(NAME, name, f"the name of a {self.kind}")
            if SEPARATOR in name:
                raise NotRenamable(f"'{SEPARATOR}' cannot be in a name")
            return sibling(self.entity, self.kind, name)
        _check(LOCAL, name, "the last part of an IRI")
        return f"{self.entity[: -1 - len(self.name)]}{name}>"

    def local(self, name: str, place: Location) -> str:
        """Return *name* without the prefix of the name at *place*, or the namespace of the IRI."""
        if self.definition is not None or is_address(self.entity):
            return name
        end = _LOCAL_PART.search(name)
        head = name[: end.start()] if end else ""
        before = place.source.text[: place.span.start].removesuffix(head)
        written = before[-1:] in OPENING and len(before) + len(head) == place.span.start
        own = iri_value(self.entity)[: -len(self.name)] == head
        return name[len(head) :] if written or own else name

    def part_of(self, written: str, named: Entity) -> tuple[int, int] | None:
        """Return the part of *written*, which names the entity *named*, that is this name.

        None if there is none. A path through nested models has a part for each.
        """
        if self.definition is not None or not is_address(self.entity):
            return self._end_of(written) if named == self.entity else None
        end = len(written)
        for each in enclosing(named):
            if not _has_name(each, written):
                continue
            start = written.rfind(SEPARATOR, 0, end)
            start = 0 if start < 0 else start + len(SEPARATOR)
            if written[start:end] != local_name(each):
                return None
            if each == self.entity:
                return start, end
            end = start - len(SEPARATOR)
            if end < 0:
                return None
        return None

    def _end_of(self, written: str) -> tuple[int, int] | None:
        plain = written.strip('"')
        start = written.find(plain) + len(plain) - len(self.name)
        before = plain[: -len(self.name)]
        bounded = not before or before[-1] in ":/#" or self.definition is not None
        if not plain.endswith(self.name) or not bounded:
            return None
        return start, start + len(self.name)


def _has_name(node: Entity, written: str) -> bool:
    """Tell whether the last step of *node* is a name that a path such as *written* may have."""
    name = local_name(node)
    return bool(name and last_tag(node)) and name in written


def _check(form: re.Pattern[str], name: str, what: str) -> None:
    if not form.fullmatch(name):
        raise NotRenamable(f"'{name}' cannot be {what}")


def exists(thing: NamedThing, name: str, known: Collection[Entity]) -> bool:
    """Tell whether something of the kind of *thing* is called *name* among *known* already."""
    if thing.definition is not None:
        return any(label(each) == (thing.kind, name) for each in known)
    return thing.renamed(name) in known


def things(entities: Sequence[Entity]) -> list[NamedThing]:
    """Return those of *entities* that have a name which can change."""
    return [each for each in map(NamedThing, entities) if each.name]
