"""Reads a stage of USD: its root layer, the layers that this leads to, and what they come to."""

from __future__ import annotations

from kinlint.addresses import document_iri, root_of
from kinlint.document import Document, NodeSpans, SourceMap
from kinlint.files.pathglob import absolute
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.options import ReadOptions
from kinlint.formats.source_layer import SourceLayer, src
from kinlint.formats.usd.format import USD
from kinlint.formats.usd.layer_opinions import opinions_of
from kinlint.formats.usd.layer_statements import LayerStatements
from kinlint.formats.usd.mesh_counts import state_mesh_counts
from kinlint.formats.usd.physics_statements import PhysicsStatements
from kinlint.formats.usd.prim_composition import Composer
from kinlint.formats.usd.prim_diagnostics import state_deviations
from kinlint.formats.usd.stage import Stage
from kinlint.formats.usd.stage_layers import Layer, Layers
from kinlint.formats.usd.stage_statements import StageStatements
from kinlint.formats.usd.suppressions import state_suppressions
from kinlint.formats.usd.target_diagnostics import state_dangling
from kinlint.formats.usd.transform_diagnostics import state_unread_operations
from kinlint.formats.usd.usda_parser import parse
from kinlint.formats.usd.usda_scanner import MalformedLayer
from kinlint.formats.xml.added_statements import with_statements
from kinlint.formats.xml.included_statements import with_includes
from kinlint.garbage import uncollected
from kinlint.terms import XSD, Triple, iri, literal
from kinlint.text import SourceText, Span
from kinlint.vocabulary import USD as NAMESPACE

STAGE = iri(f"{NAMESPACE}stage")


def read(source: SourceText, options: ReadOptions) -> Document:
    """Read the statements of a stage; a root layer that is not well-formed states only that.

    Raises SourceError for what no scene is as large as.
    """
    with uncollected():
        try:
            root = read_layer(source)
        except MalformedLayer as error:
            return _unread(source, error)
        return _read(root, options)


def _read(root: Layer, options: ReadOptions) -> Document:
    layers = Layers(root, options, read_layer)
    composer = Composer(layers)
    about = StageStatements(Stage(composer), layers, root.document.graph)
    about.state()
    PhysicsStatements(about).state()
    others = ((each.include or "", each.document) for each in layers.found.values())
    whole = with_includes(root.document, others, STAGE)
    return _with_stage(whole, about, composer)


def read_layer(source: SourceText) -> Layer:
    """Return the layer that *source* is.

    Raises MalformedLayer where it is not well-formed, and SourceError for one that is too large.
    """
    root = parse(source)
    graph = document_iri(source.name)
    layer = SourceLayer(graph, BlankNodes(source.name))
    layer.state_file(USD.name, source.name, Span(0, len(source.text)))
    said = LayerStatements(source, graph, layer)
    said.state(root)
    opinions = opinions_of(root)
    state_deviations(root, said.node_of, opinions, layer)
    state_dangling(root, said.node_of, opinions, layer)
    state_mesh_counts(source.text, root, said.node_of, layer)
    state_suppressions(source.text, root, layer)
    state_unread_operations(root, said.node_of, opinions, layer)
    place = said.nodes[root_of(graph)].best
    layer.triples[root_of(graph), src("describedIn"), graph] = place
    for space in (f"{graph[1:-1]}#/", f"{graph[1:-1]}#"):
        layer.triples[graph, src("ownNamespace"), literal(space)] = place
    statements = (*said.triples, *layer.triples)
    places = SourceMap({**said.triples, **layer.triples}, {**said.nodes, **layer.nodes})
    document = Document(source, graph, statements, places, format=USD)
    path = absolute(source.name)
    if path.suffix.lower() == ".usdz":
        path /= "root"
    return Layer(path, root, document, said.node_of, said.item_of)


def _unread(source: SourceText, error: MalformedLayer) -> Document:
    """Return the document that states only where *source* is not well-formed."""
    graph = document_iri(source.name)
    layer = SourceLayer(graph, BlankNodes(source.name))
    layer.state_file(USD.name, source.name, Span(0, len(source.text)))
    unread = ("unread", literal("true", f"{XSD}boolean"))
    reason = ("reason", literal(error.reason))
    layer.add_node("MalformedText", error.span, ("node", graph), reason, unread)
    places = SourceMap(layer.triples, layer.nodes)
    return Document(source, graph, tuple(layer.triples), places, format=USD)


def _with_stage(whole: Document, about: StageStatements, composer: Composer) -> Document:
    """Return *whole* with what its prims come to, and with the layers that are not read."""
    layer = SourceLayer(whole.graph, BlankNodes(f"{whole.source.name}#stage"))
    places = whole.map.nodes
    for node, source in about.said.made_of.items():
        if node not in places and source in places:
            layer.nodes[node] = NodeSpans(places[source].whole, places[source].identifier)
    stage = ("ofStage", root_of(whole.graph))
    for each in composer.layers.unread:
        said = ("node", each.item), ("written", literal(each.written)), stage
        span = places[each.item].best
        layer.add_node("UnresolvedInclude", span, *said, ("reason", literal(each.reason)))
    for at, value in composer.absent:
        span = places[at.item(value)].best
        written = literal(whole.location(span).source[value.span])
        layer.add_node("AbsentPrim", span, ("node", at.item(value)), ("written", written))
    for at, value in composer.cycles:
        node = at.item(value)
        span = places[node].best
        written = literal(whole.location(span).source[value.span])
        reason = ("reason", literal("it leads back to where it stands"))
        layer.add_node("CircularInclude", span, ("node", node), ("written", written), reason)
    triples: dict[Triple, Span | None] = dict.fromkeys(about.said.triples)
    for triple, written_ in about.written.items():
        triples[triple] = whole.map.triples.get(written_)
    return with_statements(whole, layer, triples)
