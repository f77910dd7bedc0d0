"""An index of the triples of documents and vocabulary, without a store of it all."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from functools import cached_property, lru_cache
from itertools import islice
from pathlib import Path
from typing import NamedTuple

import pyoxigraph as ox

from kinlint.document import Document
from kinlint.engine.compiler.shacl_terms import SUBCLASS
from kinlint.engine.constraint import Constraint
from kinlint.engine.store import Store
from kinlint.file_format import Format
from kinlint.terms import RDF_TYPE, Term, is_iri


class Vocabulary:
    """The statements of vocabulary files, which no edit changes."""

    def __init__(self, files: Sequence[Path]) -> None:
        self._store = Store()
        self._store.load_vocabulary(files)
        self._known: dict[tuple[Term, Term | None], tuple[Term, ...]] = {}

    @property
    def quads(self) -> ox.Store:
        """All statements."""
        return self._store.oxigraph

    def subjects(self, predicate: Term, value: Term | None = None) -> tuple[Term, ...]:
        """Return what has *predicate*, with *value* if one is given."""
        key = predicate, value
        if key not in self._known:
            self._known[key] = tuple(self._store.subjects(predicate, value))
        return self._known[key]


@lru_cache(maxsize=4)
def vocabulary_of(files: tuple[Path, ...]) -> Vocabulary:
    """Return the statements of *files*."""
    return Vocabulary(files)


class Signature(NamedTuple):
    """The formats of documents, the properties that they state, and of some with what values."""

    formats: frozenset[Format]
    properties: frozenset[Term]
    pairs: frozenset[tuple[Term, Term]]


def signature(documents: Sequence[Document], valued: Collection[Term]) -> Signature:
    """Return the signature of *documents*, with the IRIs that *valued* properties have."""
    properties, pairs = set[Term](), set[tuple[Term, Term]]()
    for document in documents:
        properties.update([predicate for _, predicate, _ in document.statements])
        pairs.update(
            [
                (predicate, value)
                for _, predicate, value in document.statements
                if predicate in valued and is_iri(value)
            ]
        )
    formats = frozenset(document.format for document in documents)
    return Signature(formats, frozenset(properties), frozenset(pairs))


def valued(constraints: Iterable[Constraint]) -> frozenset[Term]:
    """Return the properties that need a certain value for some of *constraints* to be violated."""
    ways = (way for each in constraints for way in (*each.targets, *each.premises))
    paths = (predicate for _, predicate, value in ways if is_iri(value))
    return frozenset({RDF_TYPE, *(step for path in paths for step in path.split("|"))})


class TripleIndex:
    """The triples of documents and vocabulary, looked up by property and value."""

    def __init__(self, documents: Sequence[Document], vocabulary: Vocabulary) -> None:
        self._documents = documents
        self._vocabulary = vocabulary

    def subjects(self, predicate: Term, value: Term | None = None) -> Iterator[Term]:
        """Yield what has *predicate*, and *value* if given; but for subclasses, one of it."""
        found = self._values.get(predicate, {})
        if predicate == SUBCLASS:
            yield from self._below(value) if found else ()
        elif value is None:
            yield from islice(found.values(), 1)
        elif value in found:
            yield found[value]
        yield from self._vocabulary.subjects(predicate, value)

    def _below(self, value: Term | None) -> Iterator[Term]:
        for document in self._documents:
            for subject, predicate, wider in document.statements:
                if predicate == SUBCLASS and value in {None, wider}:
                    yield subject

    @cached_property
    def _values(self) -> dict[Term, dict[Term, Term]]:
        found: dict[Term, dict[Term, Term]] = {}
        for document in self._documents:
            for subject, predicate, value in document.statements:
                if predicate not in found:
                    found[predicate] = {}
                found[predicate][value] = subject
        return found
