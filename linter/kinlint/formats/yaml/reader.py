"""Reads what a YAML file of ros2_control or MoveIt says of joints."""

from __future__ import annotations

from kinlint.addresses import child, document_iri, repeated_address, root_of
from kinlint.document import Document, NodeSpans, SourceMap
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.options import ReadOptions
from kinlint.formats.source_layer import SourceLayer, src
from kinlint.formats.yaml.format import YAML
from kinlint.formats.yaml.joint_entries import entries
from kinlint.terms import XSD, Term, Triple, iri, literal
from kinlint.text import SourceText, Span
from kinlint.vocabulary import ATTRIBUTE


def read(source: SourceText, _options: ReadOptions) -> Document:
    """Read the entries about joints; a file without any has no statements but about itself."""
    graph = document_iri(source.name)
    root = root_of(graph)
    layer = SourceLayer(graph, BlankNodes(source.name))
    layer.state_file(YAML.name, source.name, Span(0, len(source.text)))
    found = entries(source.name, source.text)
    stated: dict[Triple, Span] = {}
    nodes: dict[Term, NodeSpans] = {}
    if found:
        begin = Span(0, min(1, len(source.text)))
        stated[graph, _term("configuration"), root] = begin
        layer.triples[root, src("describedIn"), graph] = begin
        nodes[root] = NodeSpans(Span(0, len(source.text)))
    for each in found:
        element, order = child(root, each.tag, each.name), 1
        while element in nodes:
            order += 1
            element = iri(repeated_address(child(root, each.tag, each.name)[1:-1], order))
        nodes[element] = NodeSpans(each.span, each.span)
        stated[root, _term(each.tag), element] = each.span
        stated[element, iri(f"{ATTRIBUTE}name"), literal(each.name)] = each.span
        for number in each.numbers:
            value = literal(repr(number.value), f"{XSD}double")
            stated[element, iri(f"{ATTRIBUTE}{number.name}"), value] = number.span
    statements = (*stated, *layer.triples)
    places = SourceMap({**stated, **layer.triples}, {**nodes, **layer.nodes})
    return Document(source, graph, statements, places, format=YAML)


def _term(name: str) -> Term:
    return iri(f"{YAML.namespace}{name}")
