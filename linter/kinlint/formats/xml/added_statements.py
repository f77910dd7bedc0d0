"""Adds statements to a document, each at a place of its own or where its subject is written."""

from __future__ import annotations

from collections import ChainMap
from collections.abc import Iterable, Iterator, Mapping
from typing import cast

from kinlint.document import Document, NodeSpans, SourceMap
from kinlint.formats.source_layer import SourceLayer
from kinlint.light_dataclasses import replace
from kinlint.terms import Term, Triple, literal
from kinlint.text import Span

NO_TRIPLES: Mapping[Triple, Span | None] = {}
NOT_DERIVED: Mapping[Triple, Triple | None] = {}


class _Triples(Mapping[Triple, Span]):
    """The places of triples; those without one of their own are where their subject is."""

    def __init__(
        self,
        written: Mapping[Triple, Span],
        added: Mapping[Triple, Span | None],
        nodes: Mapping[Term, NodeSpans],
        derived: Mapping[Triple, Triple | None],
    ) -> None:
        self.written, self.added, self.nodes, self.derived = written, added, nodes, derived

    def __getitem__(self, triple: Triple) -> Span:
        if triple in self.added:
            return self.added[triple] or self.nodes[triple[0]].best
        if triple in self.derived:
            of = self.derived[triple]
            return (of and self.written.get(of)) or self.nodes[triple[0]].best
        return self.written[triple]

    def __iter__(self) -> Iterator[Triple]:
        yield from self.written
        yield from self.derived
        yield from (each for each in self.added if each not in self.derived)

    def __len__(self) -> int:
        return sum(1 for _ in self)


def with_statements(
    document: Document,
    layer: SourceLayer,
    triples: Mapping[Triple, Span | None] = NO_TRIPLES,
    derived: Mapping[Triple, Triple | None] = NOT_DERIVED,
) -> Document:
    """Return *document* with the statements of *layer*, and *triples* that follow from its own.

    So do those *derived*, each of which is where the statement is that it is derived from. Those
    without a place are where their subject is.
    """
    if not layer.triples and not triples and not derived:
        return document
    added: dict[Triple, Span | None] = {**triples, **layer.triples}
    nodes = ChainMap(layer.nodes, cast("dict[Term, NodeSpans]", document.map.nodes))
    places = SourceMap(_Triples(document.map.triples, added, nodes, derived), nodes)
    more = {**derived, **added} if derived else added
    return replace(document, statements=[*document.statements, *more], map=places)


def value_span(document: Document, node: Term, ways: Iterable[Term], written: str) -> Span:
    """Return the span of *written* as value of *node* by one of the properties *ways*.

    Else that of *node*.
    """
    term = literal(written)
    for way in ways:
        found = document.map.triples.get((node, way, term))
        if found is not None:
            return found
    spans = document.map.nodes.get(node)
    return spans.best if spans else Span(0, 0)
