"""Elements of files by their tags, whatever XML format the file is in."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache

from kinlint.document import Document
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.formats.records import BY_NAME, ELEMENTS
from kinlint.terms import Term, iri


@cache
def _properties(tag: str) -> tuple[Term, ...]:
    """Return the properties that lead from an element to one called *tag* within it."""
    return tuple(iri(namespace + tag) for namespace in ELEMENTS)


def elements(scan: PredicateIndex, parent: Term, tag: str) -> list[Term]:
    """Return the elements called *tag* directly within *parent*, an element or a document."""
    return [each for way in _properties(tag) for each in scan.table(way).values(parent)]


def elements_by_parent(scan: PredicateIndex, tag: str) -> Iterator[tuple[Term, Sequence[Term]]]:
    """Yield what has elements called *tag* directly within it, with these."""
    for way in _properties(tag):
        yield from scan.table(way).items()


def robot_elements(scan: PredicateIndex, document: Document) -> list[Term]:
    """Return the elements of *document* that are robots; none if it describes none."""
    found = [document.graph]
    for tag in BY_NAME[document.format.lifted_as].robot_path:
        found = [each for parent in found for each in elements(scan, parent, tag)]
    return [] if found == [document.graph] else found
