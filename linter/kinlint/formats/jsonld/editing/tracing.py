"""Reads a text once more and keeps what the reader had no need to: contexts, and every place."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.json_text.json_parser import parse
from kinlint.formats.json_text.json_values import Array, Object, ParsedJson
from kinlint.formats.jsonld.active_context import Context
from kinlint.formats.jsonld.context_cache import ContextCache
from kinlint.formats.jsonld.expander import Processor
from kinlint.formats.jsonld.local_contexts import LocalContexts
from kinlint.formats.jsonld.pyld import frozendict
from kinlint.formats.jsonld.reader import undisturbed
from kinlint.formats.jsonld.traced_values import Expanded, Origin
from kinlint.formats.jsonld.triples import Triples
from kinlint.formats.options import ReadOptions
from kinlint.terms import Term, Triple
from kinlint.text import SourceText, Span


class ContextScope(NamedTuple):
    """The contexts at an object: around it, for its keys, and for the names of its types."""

    outer: Context
    """Context around the object."""
    keys: Context
    """Context that gives its keys their meaning."""
    types: Context
    """Context that gives the names of its types their meaning."""


class Tracing(Processor):
    """Expansion that notes scope and origin of each object, by its identity, while `tracing`."""

    def __init__(self, memory: ContextCache, base: str, local: LocalContexts) -> None:
        super().__init__(memory, base, local)
        self.scopes: dict[int, ContextScope] = {}
        self.origins: dict[int, Origin] = {}
        self.tracing = True
        self._inverse: dict[int, tuple[Context, Any]] = {}

    def _prepare_nested_context(self, active_ctx: Context, element: Any, options: Any) -> Any:
        prepared = super()._prepare_nested_context(active_ctx, element, options)
        if self.tracing and isinstance(element, Object):
            self.scopes[id(element)] = ContextScope(active_ctx, prepared[0], prepared[2])
            self.origins[id(element)] = self.trail[-1]
        return prepared

    def _get_inverse_context(self, active_ctx: Context) -> Any:
        """Return the inverse context, uncached.

        PyLD's key may be shared by different contexts here.
        """
        known = self._inverse.get(id(active_ctx))
        if known is None:
            own = frozendict({**active_ctx, "_uuid": f"kinlint {id(self)} {id(active_ctx)}"})
            known = self._inverse[id(active_ctx)] = (
                active_ctx,
                super()._get_inverse_context(own),
            )
        return known[1]


class Tracks(Triples):
    """Triples that also keep where they are repeated, and which objects describe a node."""

    def __init__(self, blanks: BlankNodes) -> None:
        super().__init__(blanks)
        self.again: dict[Triple, list[Span]] = {}
        self.objects: dict[Term, list[Object]] = {}
        self.subjects: dict[int, Term] = {}

    def _emit(
        self, subject: Term | None, prop: Term | None, value: Term | None, span: Span
    ) -> None:
        if subject is not None and prop is not None and value is not None:
            triple = subject, prop, value
            if triple in self.spans:
                self.again.setdefault(triple, []).append(span)
        super()._emit(subject, prop, value, span)

    def _node(self, node: dict[str, Any], whole: Span) -> Term | None:
        subject = super()._node(node, whole)
        origin: Origin | None = node.origin if isinstance(node, Expanded) else None
        if subject is not None and origin is not None:
            self.subjects[id(origin.element)] = subject
            if any(prop != "@id" for prop in node):
                self.objects.setdefault(subject, []).append(origin.element)
        return subject


class Trace(NamedTuple):
    """A traced reading of a text: its JSON, the processor that expanded it, and the triples."""

    parsed: ParsedJson
    """The JSON text."""
    processor: Tracing
    """Processor that expanded it."""
    tracks: Tracks
    labels: Mapping[Term, str]
    """Labels of blank nodes, as they are written."""


def trace(source: SourceText, options: ReadOptions) -> Trace:
    """Read *source* with a trace, naming blank nodes as the reader does.

    Raises what the reader raises; a text that was read raises nothing.
    """
    with undisturbed():
        parsed = parse(source)
        kept = [(array, list(array)) for array in _outermost(parsed.value)]
        memory = ContextCache.from_options(options, options.contexts.release)
        processor = Tracing(memory, options.base, LocalContexts(source, options))
        blanks = BlankNodes(source.name)
        tracks = Tracks(blanks)
        processor.on_node = lambda node: tracks.add([node], parsed.span)
        tracks.add(processor.expand_document(parsed), parsed.span)
        processor.tracing = False
        # The processor takes the nodes of the outermost graph out of their array.
        for array, elements in kept:
            array[:] = elements
    return Trace(parsed, processor, tracks, blanks.labels)


def _outermost(value: Any) -> Iterator[Array]:
    """Yield the arrays that stand in the outermost object, or in one of several."""
    for node in value if isinstance(value, Array) else [value]:
        if isinstance(node, Object):
            yield from (array for array in node.values() if isinstance(array, Array))
