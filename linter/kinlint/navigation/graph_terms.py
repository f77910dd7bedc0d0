"""IRIs and blank nodes in files that are graphs: where they are described and mentioned."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.navigation.document_excerpt import Excerpt
from kinlint.navigation.occurrence import Occurrence, Role
from kinlint.terms import RDF, iri, is_blank, is_literal
from kinlint.vocabulary import SRC

REST = iri(f"{RDF}rest")
OWN = f"<{SRC}"


def terms(excerpt: Excerpt) -> Iterator[Occurrence]:
    """Yield every node that *excerpt* describes, and every term that is a value in it."""
    document, losses = excerpt.document, excerpt.losses
    described = set()
    for node, spans in excerpt.nodes.items():
        if node not in losses and node != document.graph:
            described.add((node, spans.best))
            yield Occurrence(document.location(spans.best), node, Role.DESCRIPTION)
    for (subject, predicate, value), span in excerpt.triples.items():
        if is_literal(value) or predicate == REST or predicate.startswith(OWN):
            continue
        if subject in losses or subject == document.graph:
            continue
        if is_blank(value) and value not in document.map.nodes:
            continue
        if (value, span) not in described:
            yield Occurrence(document.location(span), value, Role.REFERENCE)
