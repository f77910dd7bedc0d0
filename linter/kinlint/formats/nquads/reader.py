"""Reads N-Triples and N-Quads: one statement a line, and the place of each of its terms."""

from __future__ import annotations

import re

from kinlint.addresses import document_iri
from kinlint.document import Document, NodeSpans, SourceMap
from kinlint.formats import doubles
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.nquads.format import NQUADS, NTRIPLES
from kinlint.formats.options import ReadOptions
from kinlint.formats.oxigraph import triples
from kinlint.formats.source_layer import SourceLayer, terms
from kinlint.terms import Term, Triple
from kinlint.text import SourceText, Span

_TERM = r"""(?:<[^>]*>|_:[^\s<"]+|"(?:[^"\\]|\\.)*"(?:@[\w-]+|\^\^<[^>]*>)?)"""
_LINE = re.compile(
    rf"(?m)^[ \t]*({_TERM})[ \t]*({_TERM})[ \t]*({_TERM})[ \t]*({_TERM})?[ \t]*\.[ \t]*(?:#.*)?\r?$"
)


def read(source: SourceText, _options: ReadOptions) -> Document:
    """Read the statements of an N-Triples or N-Quads file, its named graphs flattened.

    Raises SourceError with line and column when it is neither.
    """
    from pyoxigraph import RdfFormat  # noqa: PLC0415  a native module, needed only here

    form = NTRIPLES if source.format == NTRIPLES else NQUADS
    blanks = BlankNodes(source.name)
    kind = RdfFormat.N_TRIPLES if form == NTRIPLES else RdfFormat.N_QUADS
    stated = list(triples(source, kind, None, blanks))
    lines = list(_LINE.finditer(source.text))
    exact = len(lines) == len(stated)

    graph = document_iri(source.name)
    layer = SourceLayer(graph, blanks)
    layer.state_file(form.name, source.name, Span(0, len(source.text)))
    spans: dict[Triple, Span] = {}
    nodes: dict[Term, NodeSpans] = {}
    for number, triple in enumerate(stated):
        line = lines[number] if exact else None
        value = Span(*line.span(3)) if line else Span(0, len(source.line(1)))
        if doubles.is_too_large(triple[2]):
            layer.state_lost_value(triple[0], triple[2], value, doubles.TOO_LARGE)
        else:
            spans.setdefault(triple, value)
        if triple[0] not in nodes:
            subject = Span(*line.span(1)) if line else value
            nodes[triple[0]] = NodeSpans(Span(*line.span()) if line else value, subject)
        if line and line[4] and not line[4].startswith("_:"):
            layer.state_graph(line[4], Span(*line.span(4)))
    layer.state_described(nodes)
    layer.state_terms(terms(spans))
    for triple, span in layer.triples.items():
        spans.setdefault(triple, span)
    places = SourceMap(spans, {**nodes, **layer.nodes})
    return Document(source, graph, tuple(spans), places, format=form)
