"""Brings what a store has asserted in step with documents."""

from __future__ import annotations

from collections.abc import Sequence

import pyoxigraph as ox

from kinlint.document import Document
from kinlint.engine.store import ASSERTED_GRAPH, Store
from kinlint.incremental.change import Changes, quads
from kinlint.incremental.difference import difference
from kinlint.terms import Triple


def assert_again(
    store: Store, documents: Sequence[Document], vocabulary: ox.Store, changes: Changes
) -> None:
    """Assert what *documents* say in place of what those of *store* said, graph by graph.

    The graphs are the same. Two spellings of a literal are one statement of a store, so of what
    is gone something may stay; so may what *vocabulary* says, too.
    """
    gone, come = set[Triple](), set[Triple]()
    for document in documents:
        known = store.documents[document.graph].statements
        if known is not document.statements and list(known) != list(document.statements):
            changes.rewritten = True
            apart = difference(known, document.statements)
            gone |= apart.removed
            come |= apart.added
    store.restate(documents)
    if not gone and not come:
        return
    removed = quads(gone, ASSERTED_GRAPH)
    if removed:
        subjects = {subject for subject, _, _ in gone}
        pairs = {(subject, predicate) for subject, predicate, _ in gone}
        still = [
            each
            for document in documents
            for each in document.statements
            if each[0] in subjects and each[:2] in pairs
        ]
        kept = set(quads(still, ASSERTED_GRAPH))
        removed = [each for each in removed if each not in kept and each not in vocabulary]
    changes.make(removed, quads(come, ASSERTED_GRAPH))
