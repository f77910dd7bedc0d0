"""IRIs and blank nodes in files that are graphs: where they are described and mentioned."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.document import Document
from kinlint.navigation.occurrence import Occurrence, Role
from kinlint.navigation.statement_index import StatementIndex
from kinlint.terms import RDF, iri, is_blank, is_literal
from kinlint.vocabulary import SRC

REST = iri(f"{RDF}rest")
OWN = f"<{SRC}"


def terms(document: Document) -> Iterator[Occurrence]:
    """Yield every node that *document* describes, and every term that is a value in it."""
    losses = StatementIndex(document).losses
    described = set()
    for node, spans in document.map.nodes.items():
        if node not in losses and node != document.graph:
            described.add((node, spans.best))
            yield Occurrence(document.location(spans.best), node, Role.DESCRIPTION)
    for (subject, predicate, value), span in document.map.triples.items():
        if is_literal(value) or predicate == REST or predicate.startswith(OWN):
            continue
        if subject in losses or subject == document.graph:
            continue
        if is_blank(value) and value not in document.map.nodes:
            continue
        if (value, span) not in described:
            yield Occurrence(document.location(span), value, Role.REFERENCE)
