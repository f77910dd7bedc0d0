"""Reads one XML file of a robot."""

from __future__ import annotations

from collections.abc import Mapping

from kinlint.addresses import document_iri
from kinlint.document import Document, SourceMap
from kinlint.errors import SourceError
from kinlint.file_format import Format
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.options import ReadOptions
from kinlint.formats.source_layer import SourceLayer
from kinlint.formats.urdf.format import URDF
from kinlint.formats.xml.document_statements import (
    describe,
    state_early_uses,
    state_flaws,
    state_spacing,
)
from kinlint.formats.xml.element_types import ElementType
from kinlint.formats.xml.elements import Elements
from kinlint.formats.xml.expat_parsing import parse
from kinlint.formats.xml.references import names, resolve_references
from kinlint.formats.xml.schema import schema
from kinlint.formats.xml.span_lookup import ElementPlaces, ElementSpans, TripleSpans
from kinlint.garbage import uncollected
from kinlint.text import SourceText, Span


def read(
    source: SourceText,
    _options: ReadOptions,
    roots: Mapping[str, ElementType] | None = None,
) -> Document:
    """Read the statements of a robot in XML, and its deviations from its format.

    A text that is not well-formed states what its usual readers make of it, and what is wrong; if
    they make nothing of it, then only that.

    The types of root elements are those of *roots*, by tag, and else those of the format.

    Raises SourceError for a document type definition, and for what no robot is as large as.
    """
    if source.format is None or source.format.schema is None:
        raise SourceError(source.name, "not a robot in XML that kinlint reads")
    with uncollected():
        return _read(source, source.format, roots)


def _read(source: SourceText, form: Format, roots: Mapping[str, ElementType] | None) -> Document:
    graph, table = document_iri(source.name), schema(form.name)
    parsed = parse(source, lambda: Elements(graph, table, roots))
    elements = parsed.elements if parsed.fatal is None else Elements(graph, table)
    places = ElementPlaces(
        source.text, parsed.offset, elements.index, elements.starts, elements.ends
    )
    layer = SourceLayer(graph, BlankNodes(source.name))
    layer.state_file(form.name, source.name, Span(0, len(source.text)))
    nodes = list(elements.index)
    if nodes:
        describe(layer, elements.scopes, nodes[0], places)
    state_flaws(layer, source, parsed, nodes)
    elements.remarks.state(layer, places, nodes)
    if form == URDF:
        state_spacing(layer, places, nodes, elements.statements)
        state_early_uses(layer, places, elements)
    parsed.comments.state(layer, elements, parsed.offset)
    statements = elements.statements
    leading = dict(
        resolve_references(names(statements, table), table, elements.index)
        if table.flat and not table.nested
        else ()
    )
    statements += leading
    statements += layer.triples
    spans = TripleSpans(places, statements, layer.triples, leading)
    described = ElementSpans(places, layer.nodes)
    return Document(source, graph, statements, SourceMap(spans, described), format=form)
