"""Statements of a document, by subject."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

from kinlint.document import Document
from kinlint.terms import Term, iri
from kinlint.text import Location
from kinlint.vocabulary import SRC

LOSS = iri(f"{SRC}document")
"""Property that every node of the source layer has."""


class StatementIndex:
    """The statements of *document*, with their places."""

    def __init__(self, document: Document) -> None:
        self.document = document

    @cached_property
    def by_subject(self) -> Mapping[Term, Sequence[tuple[Term, Term]]]:
        """The properties of each node with their values, in the order of the text."""
        found: dict[Term, list[tuple[Term, Term]]] = {}
        for subject, predicate, value in self.document.statements:
            found.setdefault(subject, []).append((predicate, value))
        return found

    @cached_property
    def losses(self) -> frozenset[Term]:
        """The nodes that stand for what the text does beyond stating something."""
        return frozenset(s for s, p, _ in self.document.statements if p == LOSS)

    def having(self, predicate: Term) -> Iterator[Term]:
        """Yield the nodes that have *predicate*, each once."""
        return iter(dict.fromkeys(s for s, p, _ in self.document.statements if p == predicate))

    def values(self, subject: Term, predicate: Term) -> Iterator[Term]:
        """Yield the values of *predicate* that *subject* has."""
        return (value for each, value in self.by_subject.get(subject, ()) if each == predicate)

    def place(self, subject: Term, predicate: Term, value: Term) -> Location | None:
        """Return the place of *value* as a value of *subject*."""
        span = self.document.map.triples.get((subject, predicate, value))
        return None if span is None else self.document.location(span)
