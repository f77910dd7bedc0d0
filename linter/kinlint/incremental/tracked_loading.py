"""Asserts what documents say, and again what changed of it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path

import pyoxigraph as ox

from kinlint.document import Document
from kinlint.engine.store import ASSERTED_GRAPH, Store
from kinlint.incremental.change import Changes, to_quads
from kinlint.incremental.difference import triple_difference
from kinlint.terms import Triple


class TrackedLoading:
    """Documents and vocabulary to asserted statements."""

    def __init__(self, store: Store, vocabulary: Sequence[Path]) -> None:
        self._store = store
        self._vocabulary = tuple(vocabulary)
        self._loaded = False

    def run(self, documents: Sequence[Document], changes: Changes) -> None:
        """Assert what *documents* say, and the vocabulary."""
        if self._loaded:
            self._restate(documents, changes)
        else:
            self._store.load(documents)
            self._store.load_vocabulary(self._vocabulary)
            self._loaded = True

    def _restate(self, documents: Sequence[Document], changes: Changes) -> None:
        """Assert what *documents* say in place of what those of the store said, graph by graph.

        The graphs are the same. Two spellings of a literal are one statement of a store, so of what
        is gone something may stay; so may what the vocabulary says, too.
        """
        gone, come = set[Triple](), set[Triple]()
        for document in documents:
            known = self._store.documents[document.graph].statements
            if known is not document.statements and list(known) != list(document.statements):
                changes.rewritten = True
                apart = triple_difference(known, document.statements)
                gone |= apart.removed
                come |= apart.added
        self._store.restate(documents)
        if not gone and not come:
            return
        removed = to_quads(gone, ASSERTED_GRAPH)
        if removed:
            subjects = {subject for subject, _, _ in gone}
            pairs = {(subject, predicate) for subject, predicate, _ in gone}
            still = [
                each
                for document in documents
                for each in document.statements
                if each[0] in subjects and each[:2] in pairs
            ]
            kept = set(to_quads(still, ASSERTED_GRAPH))
            vocabulary = _vocabulary(self._vocabulary)
            removed = [each for each in removed if each not in kept and each not in vocabulary]
        changes.apply(removed, to_quads(come, ASSERTED_GRAPH))


@lru_cache(maxsize=4)
def _vocabulary(files: tuple[Path, ...]) -> ox.Store:
    """Return the statements of *files*, which no edit changes."""
    store = Store()
    store.load_vocabulary(files)
    return store.oxigraph
