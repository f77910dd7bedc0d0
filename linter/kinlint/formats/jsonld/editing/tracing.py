"""Traces a text on demand: the contexts at its objects, and every place of what it states."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from functools import cached_property, partial
from typing import Any

from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.json_text.json_outline import NotOutlined, Unplaced, outline
from kinlint.formats.json_text.json_parser import parse
from kinlint.formats.json_text.json_values import Array, Object, ParsedJson
from kinlint.formats.jsonld.active_context import Context
from kinlint.formats.jsonld.compiled.element_compiler import ElementCompiler
from kinlint.formats.jsonld.context_cache import ContextCache
from kinlint.formats.jsonld.editing.traced_expansion import Tracing, Tracks
from kinlint.formats.jsonld.local_contexts import LocalContexts
from kinlint.formats.jsonld.losses import LossObserver
from kinlint.formats.jsonld.reader import undisturbed
from kinlint.formats.options import ReadOptions
from kinlint.terms import Term, Triple
from kinlint.text import SourceText, Span


class TracedElement:
    """An element of the outermost graph, or all that is outside of it; traced when asked for."""

    def __init__(
        self, triples: Collection[Triple], span: Span, trace: Tracks | Callable[[], Tracks]
    ) -> None:
        self.triples = triples
        """Triples that it states, in the order of the text."""
        self.span = span
        """Its place."""
        if isinstance(trace, Tracks):
            self.tracks = trace
        else:
            self._trace = trace

    @property
    def lazy(self) -> bool:
        """Tell whether it is not traced yet."""
        return "tracks" not in vars(self)

    @cached_property
    def tracks(self) -> Tracks:
        """Its triples with all of their places."""
        return self._trace()


class OutlinedArray(Array):
    """The outermost graph, whose elements get the places in them when they are asked for."""

    __slots__ = ()

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return [self[each] for each in range(*index.indices(len(self)))]
        found = super().__getitem__(index)
        if type(found) is Unplaced:
            found = self[index] = found.placed()[0]
        return found

    def __iter__(self) -> Iterator[Any]:
        return (self[index] for index in range(len(self)))

    def element_span(self, index: int) -> Span:
        """Return the span of element *index*."""
        found = super().__getitem__(index)
        return found.span if type(found) is Unplaced else super().element_span(index)


class Trace:
    """A reading of *source* in which elements of the outermost graph are traced on demand.

    What PyLD has to expand is traced at once. Blank nodes are named as the reader does. Raises what
    the reader raises; a text that was read raises nothing.
    """

    def __init__(self, source: SourceText, options: ReadOptions) -> None:
        self.parsed = _parsed(source)
        """The JSON text."""
        memory = ContextCache.from_options(options, options.contexts.release)
        self.processor = Tracing(memory, options.base, LocalContexts(source, options))
        """Processor that expands it."""
        self.subjects: dict[int, Term] = {}
        """The nodes that objects describe, by the identity of the objects."""
        self.elements: list[TracedElement] = []
        """The elements of the outermost graph in their order, and last what is outside of them."""
        self._blanks = BlankNodes(source.name)
        self._compiler = ElementCompiler(self.processor)
        self._hull = self._tracks = Tracks(self._blanks, self.subjects)
        self._placed: dict[int, Object] = {}
        self._graph = OutlinedArray(0)
        with undisturbed():
            self._expand()

    @property
    def labels(self) -> Mapping[Term, str]:
        """Labels of blank nodes, as they are written."""
        return self._blanks.labels

    def _expand(self) -> None:
        parsed, processor, hull = self.parsed, self.processor, self._hull
        kept = [(array, list(array)) for array in _outermost(parsed.value)]
        processor.origins = hull.origins
        processor.on_node = self._add
        processor.on_unplaced = self._take
        hull.add(processor.expand_document(parsed), parsed.span)
        self.elements.append(TracedElement(hull.spans, parsed.span, hull))
        processor.tracing = False
        # The processor takes the nodes of the outermost graph out of their array.
        for array, elements in kept:
            array[:] = [self._placed.get(id(element), element) for element in elements]
        self._outline(parsed.value)

    def _outline(self, root: Any) -> None:
        """Put an array that places its elements into *root* where there is one of `Unplaced`."""
        for key, value in root.items() if isinstance(root, Object) else ():
            if isinstance(value, Array) and any(type(each) is Unplaced for each in value):
                self._graph = OutlinedArray(value.start)
                self._graph.end = value.end
                self._graph += value
                root[key] = self._graph
                return

    def _add(self, node: Any) -> None:
        self._tracks.add([node], self.parsed.span)
        self._tracks, self.processor.origins = self._hull, self._hull.origins

    def _take(self, element: Unplaced, outer: Context, key: str) -> Object | None:
        """State *element*; return it with its places if that takes PyLD."""
        before, number = self._blanks.count, len(self.elements)
        group = self._compiler.state(element, outer, key, self._blanks, LossObserver())
        if group is not None:
            trace = partial(self._trace, number, before)
            self.elements.append(TracedElement(list(group.triples), element.span, trace))
            return None
        placed = self._placed[id(element)] = element.placed()[0]
        self._begin(tracks := Tracks(self._blanks, self.subjects))
        self.elements.append(TracedElement(tracks.spans, element.span, tracks))
        return placed

    def _begin(self, tracks: Tracks) -> None:
        self._tracks, self.processor.origins = tracks, tracks.origins

    def _trace(self, number: int, before: int) -> Tracks:
        """Trace an element that was stated after *before* blank nodes."""
        tracks = Tracks(self._blanks.since(before), self.subjects)
        self._begin(tracks)
        self.processor.trace_element(self._graph[number])
        return tracks


def _parsed(source: SourceText) -> ParsedJson:
    try:
        return outline(source)
    except NotOutlined:
        return parse(source)


def _outermost(value: Any) -> Iterator[Array]:
    """Yield the arrays that stand in the outermost object, or in one of several."""
    for node in value if isinstance(value, Array) else [value]:
        if isinstance(node, Object):
            yield from (array for array in node.values() if isinstance(array, Array))
