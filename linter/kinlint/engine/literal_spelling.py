"""Spellings of literals in documents, of which a store gives back its own canonical form."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property, lru_cache
from typing import TYPE_CHECKING

import pyoxigraph as ox

from kinlint.addresses import document_of
from kinlint.terms import Term, Triple, is_blank

if TYPE_CHECKING:
    from kinlint.document import Document


class Spelling:
    """The typed and tagged literals of one document, indexed when first asked for."""

    def __init__(self, document: Document) -> None:
        self.document = document
        self._known: dict[tuple[Term, Term], dict[Term, Term]] = {}
        self._by_property: dict[Term, Mapping[Term, Sequence[Term]]] = {}

    def as_written(self, triple: Triple) -> Triple | None:
        """Return the triple that the document writes for *triple*.

        None if it has no place for any.
        """
        if triple in self.document.map.triples:
            return triple
        subject, predicate, value = triple
        if _is_exact(value):
            return None
        same = self._normals(subject, predicate).get(normal(value))
        return None if same is None else (subject, predicate, same)

    def _normals(self, subject: Term, predicate: Term) -> dict[Term, Term]:
        """Return the literals of a property of a node as written, by their form in a store."""
        key = (subject, predicate)
        if key not in self._known:
            written = self._literals(predicate).get(subject, ())
            self._known[key] = {normal(each): each for each in reversed(written)}
        return self._known[key]

    def _literals(self, predicate: Term) -> Mapping[Term, Sequence[Term]]:
        """Return the literals of a property that the document has places for, by subject."""
        if predicate not in self._by_property:
            index: dict[Term, list[Term]] = {}
            for triple in self.document.saying(predicate):
                if not _is_exact(triple[2]) and triple in self.document.map.triples:
                    index.setdefault(triple[0], []).append(triple[2])
            self._by_property[predicate] = index
        return self._by_property[predicate]


class Spellings:
    """The documents, by graph, that state a triple, each with its own spelling."""

    def __init__(self, documents: Mapping[Term, Document]) -> None:
        self.documents = documents
        self._known: dict[Term, Spelling] = {}

    def written(self, triple: Triple) -> Iterator[tuple[Document, Triple]]:
        """Yield the documents that say *triple*, as they spell it."""
        for document in self._speaking(triple[0]):
            if document.graph not in self._known:
                self._known[document.graph] = Spelling(document)
            spelled = self._known[document.graph].as_written(triple)
            if spelled is not None:
                yield document, spelled

    def _speaking(self, subject: Term) -> Sequence[Document]:
        """Return the documents that may state something of *subject*.

        One for elements and blank nodes.
        """
        own = self.documents.get(document_of(subject))
        if own is not None:
            return (own,)
        if is_blank(subject):
            if len(self.documents) == 1:
                return tuple(self.documents.values())
            home = self._homes.get(subject)
            return () if home is None else (home,)
        return self._speakers.get(subject, ())

    @cached_property
    def _speakers(self) -> Mapping[Term, Sequence[Document]]:
        """The documents with places for statements about each subject that has an IRI."""
        found: dict[Term, list[Document]] = {}
        for document in self.documents.values():
            if not document.format.is_tree:
                for subject in dict.fromkeys(each[0] for each in document.map.triples):
                    found.setdefault(subject, []).append(document)
        return found

    @cached_property
    def _homes(self) -> Mapping[Term, Document]:
        """The document of each blank node."""
        return {
            node: document
            for document in self.documents.values()
            for node, _, _ in document.statements
            if node[0] == "_"
        }


def _is_exact(value: Term) -> bool:
    """Tell whether stores keep the spelling: IRIs, blank nodes and plain strings."""
    return value[0] != '"' or value[-1] == '"'


@lru_cache(maxsize=4096)
def normal(value: Term) -> Term:
    """Return *value* as Oxigraph gives it back."""
    if _is_exact(value):
        return value
    scratch = ox.Store()
    scratch.extend(ox.parse(f"<any:> <any:> {value} .", ox.RdfFormat.N_TRIPLES, lenient=True))
    return str(next(iter(scratch)).object)


def component(property_: Term) -> tuple[str, int]:
    """Return a sort key for properties of the numbers of one attribute: the last one first."""
    stem, _, number = property_[:-1].rpartition("-")
    return (stem, -int(number)) if number.isdecimal() else (property_, 0)
