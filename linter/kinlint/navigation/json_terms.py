"""The keys of a JSON-LD file, and identifiers that stand in it more than once."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from kinlint.formats.json_text.json_values import Array, Key, Object, Text
from kinlint.navigation.document_excerpt import Excerpt
from kinlint.navigation.occurrence import Entity, Occurrence, Role
from kinlint.terms import RDF_TYPE, Term
from kinlint.text import Span
from kinlint.vocabulary import SRC

CONTEXT, ID = "@context", "@id"
OWN = f"<{SRC}"


class Member(NamedTuple):
    """A key with its value, in an object; `outer` is the member that the object is in."""

    key: Key
    """Key, with its place."""
    value: Any
    """The value."""
    object: Object
    """Object that contains the member."""
    outer: Member | None
    """None at the top."""


def keys_and_names(excerpt: Excerpt, known: Mapping[Span, Entity]) -> Iterator[Occurrence]:
    """Yield the keys in *excerpt* as the properties that they mean, and names that are repeated.

    *known* are the entities whose names have a place already, by that place.
    """
    document = excerpt.document
    members = list(_members(excerpt.value))
    stated = [each for each in members if not _in_context(each)]
    meanings: dict[str, Term] = {}
    for key, property_ in _properties(excerpt, stated):
        meanings.setdefault(key, property_)
        yield Occurrence(document.location(key.span), property_, Role.REFERENCE)
    for member in members:
        if _in_context(member) and (meant := meanings.get(member.key)) is not None:
            yield Occurrence(document.location(member.key.span), meant, Role.DESCRIPTION)
    named = {document.source[span]: entity for span, entity in {**excerpt.names, **known}.items()}
    for member in stated:
        name = member.value
        if member.key == ID and isinstance(name, Text) and name.span not in known:
            entity = named.get(document.source[name.span])
            if entity is not None:
                role = Role.DESCRIPTION if len(member.object) > 1 else Role.REFERENCE
                yield Occurrence(document.location(name.span), entity, role)


def _members(value: Any) -> Iterator[Member]:
    """Yield all members of all objects in *value*, outer ones first."""
    pending: list[tuple[Any, Member | None]] = [(value, None)]
    while pending:
        at, outer = pending.pop()
        if isinstance(at, Object):
            found = [Member(k, v, at, outer) for k, v in at.items() if isinstance(k, Key)]
            yield from found
            pending += [(each.value, each) for each in found]
        elif isinstance(at, Array):
            pending += [(each, outer) for each in at]


def _in_context(member: Member) -> bool:
    """Tell whether *member* stands in a context."""
    outer = member.outer
    while outer is not None:
        if outer.key == CONTEXT:
            return True
        outer = outer.outer
    return False


def _properties(excerpt: Excerpt, members: list[Member]) -> Iterator[tuple[Key, Term]]:
    """Yield the keys that state something, each with the property of a triple that it states."""
    innermost = _Innermost(members)
    told: set[int] = set()
    triples = sorted(excerpt.triples.items(), key=lambda item: item[1])
    for (_, predicate, _), span in triples:
        if predicate == RDF_TYPE or predicate.startswith(OWN):
            continue
        member = innermost.at(span)
        while member is not None and member.key.startswith("@"):
            member = member.outer
        if member is not None and member.key.start not in told:
            told.add(member.key.start)
            yield member.key, predicate


class _Innermost:
    """Finds, for spans in ascending order, the innermost of *members* whose value has the span."""

    def __init__(self, members: list[Member]) -> None:
        self._left = sorted(members, key=lambda each: each.key.value_start, reverse=True)
        self._open: list[Member] = []

    def at(self, span: Span) -> Member | None:
        while self._left and self._left[-1].key.value_start <= span.start:
            self._push(self._left.pop())
        while self._open and self._open[-1].key.value_end < span.end:
            self._open.pop()
        return self._open[-1] if self._open else None

    def _push(self, member: Member) -> None:
        while self._open and self._open[-1].key.value_end <= member.key.value_start:
            self._open.pop()
        self._open.append(member)
