"""Names in files of elements: where something gets its name, and where it is called by it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.addresses import child, local_name, root_of
from kinlint.document import Document
from kinlint.navigation.occurrence import Occurrence, Role
from kinlint.navigation.sdf_names import sdf_names
from kinlint.navigation.statement_index import StatementIndex
from kinlint.terms import Term, Triple, iri, literal, literal_value
from kinlint.vocabulary import ATTRIBUTE, SRC, URDF

NAME, LINK = iri(f"{ATTRIBUTE}name"), iri(f"{ATTRIBUTE}link")
ENDS = frozenset({iri(f"{URDF}parent"), iri(f"{URDF}child")})
VISUAL, MATERIAL = iri(f"{URDF}visual"), iri(f"{URDF}material")
JOINED = iri(f"{SRC}joinedTo")
ATTRIBUTES = f"<{ATTRIBUTE}"


def named_elements(document: Document, references: Sequence[Triple]) -> Iterator[Occurrence]:
    """Every name of an element in *document*, and every use of one, as *references* have it."""
    said = StatementIndex(document)
    calls = dict(_calls(said, references))
    if document.format.name == "sdf":
        calls.update(sdf_names(document, said))
    for (subject, predicate, value), target in calls.items():
        if (place := said.place(subject, predicate, value)) is not None:
            yield Occurrence(place, target, Role.REFERENCE)
    for subject, statements in said.of.items():
        for predicate, value in statements:
            if predicate != NAME or (subject, predicate, value) in calls:
                continue
            if (place := said.place(subject, predicate, value)) is not None:
                yield Occurrence(place, subject, Role.DESCRIPTION)


def _calls(said: StatementIndex, references: Sequence[Triple]) -> Iterator[tuple[Triple, Term]]:
    """The attributes that name something else, each with what it names."""
    own = said.of
    for element, predicate, target in references:
        if element in own:
            name = literal(local_name(target))
            if (attribute := _attribute(own[element], predicate, name)) is not None:
                yield (element, attribute, name), target
    for subject, statements in own.items():
        for predicate, value in statements:
            if predicate in ENDS:
                for link in said.values(value, LINK):
                    yield (value, LINK, link), child(root_of(value), "link", literal_value(link))
            elif predicate == VISUAL:
                yield from _materials(said, value)
            elif predicate == JOINED:
                yield from (((subject, NAME, name), value) for name in said.values(subject, NAME))


def _materials(said: StatementIndex, visual: Term) -> Iterator[tuple[Triple, Term]]:
    """The materials that *visual* takes from the robot."""
    for material in said.values(visual, MATERIAL):
        for name in said.values(material, NAME):
            shared = child(root_of(visual), "material", literal_value(name))
            if shared in said.of:
                yield (material, NAME, name), shared


def _attribute(statements: Sequence[tuple[Term, Term]], predicate: Term, name: Term) -> Term | None:
    """The attribute by which an element that says *statements* names what *predicate* leads to."""
    likely = f"{ATTRIBUTES}{predicate.rpartition('#')[2]}"
    found = [each for each, value in statements if value == name and each.startswith(ATTRIBUTES)]
    return likely if likely in found else next(iter(found), None)
