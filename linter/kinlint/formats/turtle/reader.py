"""Reads one Turtle file."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Sequence

from kinlint.addresses import document_iri
from kinlint.document import Document, NodeSpans, SourceMap
from kinlint.formats import doubles
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.options import ReadOptions
from kinlint.formats.oxigraph import triples
from kinlint.formats.source_layer import SourceLayer, terms
from kinlint.formats.turtle.format import TURTLE
from kinlint.formats.turtle.turtle_parser import Grammar, Statement
from kinlint.formats.turtle.turtle_tokens import Unread
from kinlint.terms import RDF, Term, Triple, is_blank, is_literal, literal, literal_value
from kinlint.text import SourceText, Span

WORD = re.compile(r"[^\s<>\"'#/:;,.()\[\]]+")
"""A local name, or a word of a literal."""


def read(source: SourceText, options: ReadOptions) -> Document:
    """Read a Turtle file.

    Raises SourceError with line and column when it is no Turtle.
    """
    from pyoxigraph import RdfFormat  # noqa: PLC0415  a native module, needed only here

    blanks = BlankNodes(source.name)
    truth = list(triples(source, RdfFormat.TURTLE, options.base, blanks))
    grammar = Grammar(source.text, options.base, BlankNodes(source.name))
    try:
        grammar.read()
    except Unread:
        grammar.statements = []
    statements: Sequence[Statement] = grammar.statements
    if _shape(statement[:3] for statement in statements) == _shape(truth):
        blanks = grammar.blanks
    else:
        statements = _placed_by_line(truth, source)
        grammar.nodes, grammar.declarations = {}, []
    return _document(source, statements, grammar, blanks)


def _document(
    source: SourceText, statements: Sequence[Statement], grammar: Grammar, blanks: BlankNodes
) -> Document:
    spans: dict[Triple, Span] = {}
    nodes: dict[Term, NodeSpans] = {}
    lists = {f"<{RDF}first>", f"<{RDF}rest>"}
    layer = SourceLayer(graph := document_iri(source.name), blanks)
    layer.state_file(TURTLE.name, source.name, Span(0, len(source.text)))
    for subject, predicate, value, places in statements:
        if doubles.is_too_large(value):
            layer.state_lost_value(subject, value, places[2], doubles.TOO_LARGE)
        else:
            spans.setdefault((subject, predicate, value), places[2])
        if predicate not in lists and subject not in nodes:
            nodes[subject] = grammar.nodes.get(subject) or NodeSpans(places[0], places[0])
    layer.state_described(nodes)
    layer.state_terms(terms(spans))
    for prefix, namespace, span in grammar.declarations:
        details = ("term", literal(prefix)), ("namespace", literal(namespace))
        layer.add_node("TermDefinition", span, *details)
    for triple, span in layer.triples.items():
        spans.setdefault(triple, span)
    origins = SourceMap(spans, {**nodes, **layer.nodes})
    return Document(source, graph, tuple(spans), origins, grammar.prefixes, format=TURTLE)


def _shape(found: Iterable[tuple[Term, Term, Term]]) -> Counter[tuple[Term, ...]]:
    """Return triples without the names of blank nodes, which two readers choose differently."""
    return Counter(
        tuple("_:" if is_blank(term) else term for term in triple) for triple in set(found)
    )


def _placed_by_line(truth: Sequence[Triple], source: SourceText) -> list[Statement]:
    """Return the triples, placed at the first word of the text that their value ends with.

    Those of other values are placed at the first line.
    """
    first = Span(0, len(source.line(1)))
    words = {match[0]: Span(*match.span()) for match in reversed([*WORD.finditer(source.text)])}
    statements = []
    for triple in truth:
        value = literal_value(triple[2]) if is_literal(triple[2]) else triple[2]
        ends = [] if is_blank(value) else WORD.findall(value)
        span = words.get(ends[-1], first) if ends else first
        statements.append(Statement(*triple, (span, span, span)))
    return statements
