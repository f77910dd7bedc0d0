"""Reads one JSON-LD file: parse, expand, state."""

from __future__ import annotations

import sys
import warnings
from collections import Counter
from collections.abc import Iterator, Mapping
from contextlib import contextmanager

from kinlint.addresses import document_iri
from kinlint.document import Document, SourceMap
from kinlint.errors import SourceError
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.json_text.json_outline import NotOutlined, outline
from kinlint.formats.json_text.json_parser import parse
from kinlint.formats.json_text.json_values import Object, ParsedJson
from kinlint.formats.jsonld.active_context import FAULTS, complaint
from kinlint.formats.jsonld.compiled.compiled_graph import CompiledGraph
from kinlint.formats.jsonld.compiled.lazy_places import (
    LazyNodeSpans,
    LazyTripleSpans,
    first_uses,
    statements,
)
from kinlint.formats.jsonld.context_cache import ContextCache
from kinlint.formats.jsonld.expander import Processor
from kinlint.formats.jsonld.format import JSONLD
from kinlint.formats.jsonld.local_contexts import LocalContexts
from kinlint.formats.jsonld.loss_report import (
    LossReport,
    state_losses,
    state_uses,
)
from kinlint.formats.jsonld.losses import LossObserver
from kinlint.formats.jsonld.pyld import JsonLdError
from kinlint.formats.jsonld.release_comparison import ReleaseComparison
from kinlint.formats.jsonld.triples import Triples
from kinlint.formats.options import ReadOptions
from kinlint.formats.source_layer import SourceLayer, namespaces
from kinlint.garbage import uncollected
from kinlint.text import SourceText, Span

_RECURSION = 20_000
UNDIVIDED = "no object with a context and a graph of objects"
"""Reason for which PyLD expands all of a file."""


def read(source: SourceText, options: ReadOptions, *, compiled: bool = True) -> Document:
    """Read a JSON-LD file with its losses; if not *compiled*, PyLD expands all of it.

    Raises SourceError when it is no JSON, or breaks the rules of JSON-LD outside of a context.
    """
    with uncollected():
        if compiled:
            try:
                return _read_outlined(source, options)
            except (NotOutlined, SourceError):
                pass  # With places from the start, so that it is told where it is wrong.
        with undisturbed():
            return _read(source, options, parse(source))


def expanded_by_pyld(source: SourceText, options: ReadOptions) -> Mapping[str, int]:
    """Count the elements of *source* that PyLD expands instead of the compiled walk, by reason.

    One reason stands for the whole file where that is not divided. Empty for what cannot be read.
    """
    declined = Counter[str]()
    try:
        with uncollected():
            _read_outlined(source, options, declined)
    except NotOutlined:
        return {UNDIVIDED: 1}
    except SourceError:
        return {}
    return declined


def _read_outlined(
    source: SourceText, options: ReadOptions, declined: Counter[str] | None = None
) -> Document:
    outlined = outline(source)
    if not isinstance(outlined.value, Object) or "@context" not in outlined.value:
        raise NotOutlined
    with undisturbed():
        return _read(source, options, outlined, declined)


def _read(
    source: SourceText,
    options: ReadOptions,
    parsed: ParsedJson,
    declined: Counter[str] | None = None,
) -> Document:
    if not isinstance(parsed.value, (dict, list)):
        place = source.position(parsed.span.start)
        cause = "not JSON-LD: neither an object nor an array"
        raise SourceError(source.name, cause, place.line, place.column)
    _check_contexts(parsed, source)
    local = LocalContexts(source, options)
    memory = ContextCache.from_options(options, options.contexts.release)
    processor = Processor(memory, options.base, local)
    name, blanks, watch = document_iri(source.name), BlankNodes(source.name), LossObserver()
    triples = Triples(blanks, watch)
    graph = CompiledGraph(processor, blanks, triples, watch, parsed.repeats)
    processor.on_node = lambda node: triples.add([node], parsed.span)
    processor.on_unplaced = graph.take
    _state(triples, processor, parsed, source)
    graph.finish()
    if declined is not None:
        declined.update(graph.declined)

    nodes = LazyNodeSpans(graph.groups)
    layer = SourceLayer(name, blanks)
    layer.state_file(JSONLD.name, source.name, Span(0, len(source.text)))
    file, described = tuple(layer.triples), tuple(nodes)
    layer.state_namespaces(namespaces(nodes))
    layer.state_terms(
        {
            term: graph.groups[number].spans[triple]
            for term, (number, triple) in first_uses(graph.groups).items()
        }
    )
    record = processor.record
    uses = ((token.span, str(token)) for token in record.uses.values())
    state_uses(layer, uses, options.contexts.release)
    report = LossReport(record, watch, triples, ReleaseComparison(options, local))
    losses = report.losses(parsed.repeats, processor.repeated)
    if processor.contextless:
        losses = [*report.missing_context(parsed.span, processor.misnamed), *losses]
    state_losses(layer, losses)

    nodes.add_layer(layer)
    said = statements(graph.groups, file, described, layer)
    places = SourceMap(LazyTripleSpans(said, graph.groups, layer, nodes), nodes)
    return Document(source, name, said, places, record.prefixes, format=JSONLD, pieces=local.pieces)


def _check_contexts(parsed: ParsedJson, source: SourceText) -> None:
    """Refuse a file whose outermost `@context` is a number, or true, or false."""
    outermost = parsed.value if isinstance(parsed.value, list) else [parsed.value]
    for node in outermost:
        if not isinstance(node, Object) or not isinstance(node.get("@context"), (int, float)):
            continue
        if (key := node.key("@context")) is not None:
            place = source.position(key.value_start)
            cause = "not JSON-LD: a context must be an object, an IRI, an array of these or null"
            raise SourceError(source.name, cause, place.line, place.column)


def _state(triples: Triples, processor: Processor, parsed: ParsedJson, source: SourceText) -> None:
    """State what the file says; some of what PyLD lets pass cannot be stated."""
    try:
        triples.add(processor.expand_document(parsed), parsed.span)
    except FAULTS as fault:
        place = source.position(_blamed(fault, processor, parsed))
        raise SourceError(source.name, _cause(fault), place.line, place.column) from fault


def _blamed(fault: BaseException, processor: Processor, parsed: ParsedJson) -> int:
    """Return the offset of the value that PyLD refuses, or of the object it was at."""
    details = getattr(fault, "details", None) or {}
    start = getattr(details.get("value"), "start", None)
    if start is None:
        start = processor.trail[-1].element.start if processor.trail else parsed.span.start
    return int(start)


def _cause(fault: BaseException) -> str:
    if isinstance(fault, RecursionError):
        return "nested too deep to be read"
    if not isinstance(fault, JsonLdError):
        return "not JSON-LD: this object cannot be expanded"
    return f"not JSON-LD: {complaint(fault)}"


@contextmanager
def undisturbed() -> Iterator[None]:
    """Allow deep recursion, silence PyLD's warnings and suspend garbage collection."""
    limit = sys.getrecursionlimit()
    sys.setrecursionlimit(max(limit, _RECURSION))
    try:
        with uncollected(), warnings.catch_warnings():
            warnings.simplefilter("ignore", SyntaxWarning)
            yield
    finally:
        sys.setrecursionlimit(limit)
