"""Reads which parts of a robot a YAML file of ROS names, and what it says of them."""

from __future__ import annotations

from kinlint.addresses import child, document_iri, repeated_address, root_of
from kinlint.document import Document, NodeSpans, SourceMap
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.options import ReadOptions
from kinlint.formats.source_layer import SourceLayer, src
from kinlint.formats.yaml.comments import state_comments
from kinlint.formats.yaml.format import YAML
from kinlint.formats.yaml.named_entries import entries
from kinlint.formats.yaml.ros_keys import FRAME, OUTSIDE
from kinlint.formats.yaml.yaml_text import compose
from kinlint.terms import XSD, Term, Triple, iri, literal
from kinlint.text import SourceText, Span
from kinlint.vocabulary import ATTRIBUTE


def read(source: SourceText, _options: ReadOptions) -> Document:
    """Read the names of parts; a file without any has no statements but about itself."""
    graph = document_iri(source.name)
    root = root_of(graph)
    layer = SourceLayer(graph, BlankNodes(source.name))
    layer.state_file(YAML.name, source.name, Span(0, len(source.text)))
    tops = compose(source.name, source.text)
    said = (each for top in tops for each in entries(top) if _may_be_of_robot(each.tag, each.name))
    # What an alias repeats is said once.
    found = sorted(dict.fromkeys(said), key=lambda each: (each.span.start, each.tag))
    stated: dict[Triple, Span] = {}
    nodes: dict[Term, NodeSpans] = {}
    if found:
        begin = Span(0, min(1, len(source.text)))
        stated[graph, _term("configuration"), root] = begin
        layer.triples[root, src("describedIn"), graph] = begin
        nodes[root] = NodeSpans(Span(0, len(source.text)))
    orders: dict[Term, int] = {}
    for each in found:
        first = child(root, each.tag, each.name)
        order = orders[first] = orders.get(first, 0) + 1
        element = iri(repeated_address(first[1:-1], order)) if order > 1 else first
        nodes[element] = NodeSpans(each.span, each.span)
        stated[root, _term(each.tag), element] = each.span
        stated[element, iri(f"{ATTRIBUTE}name"), literal(each.name)] = each.span
        if each.group >= 0:
            layer.triples[element, src("memberOf"), _list(root, each.group)] = each.span
        for name, value in each.told:
            told = _list(root, value) if isinstance(value, int) else literal(value)
            layer.triples[element, src(name), told] = each.span
        for key, span in each.parameters:
            layer.triples[element, src("parameter"), literal(key)] = span
        for number in each.numbers:
            size = literal(repr(number.value), f"{XSD}double")
            stated[element, iri(f"{ATTRIBUTE}{number.name}"), size] = number.span
    state_comments(source.text, tops, layer)
    statements = (*stated, *layer.triples)
    places = SourceMap({**stated, **layer.triples}, {**nodes, **layer.nodes})
    return Document(source, graph, statements, places, format=YAML)


def _may_be_of_robot(tag: str, name: str) -> bool:
    """Tell whether *name* is none of a frame that usually others publish."""
    return tag != FRAME or ("/" not in name and name not in OUTSIDE)


def _list(root: Term, offset: int) -> Term:
    """Return the name of the list or table that begins at *offset*."""
    return child(root, "list", str(offset))


def _term(name: str) -> Term:
    return iri(f"{YAML.namespace}{name}")
