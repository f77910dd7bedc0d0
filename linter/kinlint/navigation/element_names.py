"""Names in files of elements: where something gets its name, and where it is called by it."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping

from kinlint.addresses import last_tag, local_name
from kinlint.document import Document
from kinlint.formats.xml.element_types import ElementType, Schema
from kinlint.formats.xml.references import names_in
from kinlint.formats.xml.schema import schema
from kinlint.navigation.occurrence import CLASS, Occurrence, Role
from kinlint.navigation.statement_index import StatementIndex
from kinlint.terms import Term, iri, iri_value, literal_value
from kinlint.vocabulary import ATTRIBUTE, REFERENCE

DEFAULT = "default"
CLASS_NAME = iri(f"{ATTRIBUTE}class")
IDENTIFIERS = (iri(f"{ATTRIBUTE}id"), iri(f"{ATTRIBUTE}sid"))
"""Attributes that addresses lead by, the one of the whole document first."""
CLASS_NAMES = frozenset({CLASS_NAME, iri(f"{ATTRIBUTE}childclass")})


def _types(table: Schema) -> Iterator[ElementType]:
    return (each for types in table.types.values() for each in types)


def named_elements(document: Document) -> Iterator[Occurrence]:
    """Yield every name of an element in *document*, and every use of one."""
    said = StatementIndex(document)
    leading = {
        (element, predicate): target
        for element, predicate, target in document.statements
        if predicate.startswith(f"<{REFERENCE}")
    }
    calls = {
        (each.element, each.place, each.value): target
        for each in names_in(document)
        if (target := leading.get((each.element, each.reference.predicate))) is not None
    }
    for (subject, predicate, value), target in calls.items():
        place = said.place(subject, predicate, value)
        if place is not None and last_tag(target) != DEFAULT:
            yield Occurrence(place, target, Role.REFERENCE)
    table = schema(document.format.lifted_as)
    naming = iri(ATTRIBUTE + table.names)
    yield from _of_other_kinds(said, calls, leading)
    yield from _classes(said, document, leading)
    if any(type_.addresses for type_ in _types(table)):
        yield from _addresses(document, said, naming)
    for subject, predicate, value in document.statements:
        if predicate != naming or (subject, predicate, value) in calls:
            continue
        if (place := said.place(subject, predicate, value)) is not None:
            yield Occurrence(place, subject, Role.DESCRIPTION)


def _of_other_kinds(
    said: StatementIndex,
    calls: Collection[tuple[Term, Term, Term]],
    leading: Mapping[tuple[Term, Term], Term],
) -> Iterator[Occurrence]:
    """Yield uses of names beside *calls*, whose kind another attribute says, by where they lead."""
    for (subject, predicate), target in leading.items():
        place_of = iri(ATTRIBUTE + iri_value(predicate).removeprefix(REFERENCE))
        for value in said.values(subject, place_of):
            if (subject, place_of, value) in calls or literal_value(value) != local_name(target):
                continue
            if (place := said.place(subject, place_of, value)) is not None:
                yield Occurrence(place, target, Role.REFERENCE)


def _classes(
    said: StatementIndex, document: Document, leading: Mapping[tuple[Term, Term], Term]
) -> Iterator[Occurrence]:
    """Yield the names of default classes, and their uses, by where these lead."""
    for subject, predicate, value in document.statements:
        if predicate not in CLASS_NAMES:
            continue
        own = last_tag(subject) == DEFAULT and predicate == CLASS_NAME
        reference = predicate.replace(ATTRIBUTE, REFERENCE)
        target = subject if own else leading.get((subject, reference))
        place = said.place(subject, predicate, value)
        if target is not None and place is not None and last_tag(target) == DEFAULT:
            entity = f"{CLASS}:{literal_value(value)}@{target}"
            yield Occurrence(place, entity, Role.DESCRIPTION if own else Role.REFERENCE)


def _addresses(document: Document, said: StatementIndex, naming: Term) -> Iterator[Occurrence]:
    """Yield the places of addresses in *document*, and of identifiers of what has no name."""
    leading = [each for each in document.statements if each[1].startswith(f"<{REFERENCE}")]
    for subject, predicate, target in leading:
        if (place := said.place(subject, predicate, target)) is not None:
            yield Occurrence(place, target, Role.REFERENCE)
    for target in dict.fromkeys(each[2] for each in leading):
        stated = dict(said.by_subject.get(target, ()))
        own = next((each for each in IDENTIFIERS if each in stated and naming not in stated), None)
        if own is not None and (place := said.place(target, own, stated[own])) is not None:
            yield Occurrence(place, target, Role.DESCRIPTION)
