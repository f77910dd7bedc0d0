"""Places of triples in a JSON-LD text: the object and the key of each."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import chain
from typing import Any, NamedTuple

from kinlint.formats.json_text.json_values import Key, Object
from kinlint.formats.jsonld.editing.text_path import Seat, TextTree
from kinlint.formats.jsonld.editing.traced_expansion import ContextScope, Tracks
from kinlint.formats.jsonld.editing.tracing import Trace, TracedElement
from kinlint.terms import RDF_TYPE, Term, Triple, iri, iri_value
from kinlint.text import Span

_WRAPPERS = frozenset({"@list", "@set"})
_CONTENT = frozenset({"@id", "@value", "@list"})


class Place(NamedTuple):
    """A place where the value of a triple is written."""

    owner: Object
    """The object that has it."""
    key: Key
    """The key of the member that it belongs to."""
    item: Seat
    """The value itself."""

    @property
    def member(self) -> Seat:
        """All values under the key."""
        return Seat(self.owner, self.key)


class TriplePlaces:
    """The way from triples and nodes to the tokens of a text."""

    def __init__(self, trace: Trace) -> None:
        self.trace = trace
        self.tree = TextTree(trace.parsed.value)
        self._elements = trace.elements
        self._starts = [element.span.start for element in self._elements[:-1]]

    @cached_property
    def by_subject(self) -> dict[Term, list[Triple]]:
        """The triples of each node, in the order of the text."""
        found: dict[Term, list[Triple]] = {}
        for triple in self._stated:
            found.setdefault(triple[0], []).append(triple)
        return found

    @cached_property
    def by_value(self) -> dict[Term, list[Triple]]:
        """The triples that point to each node."""
        found: dict[Term, list[Triple]] = {}
        for triple in self._stated:
            if triple[2][0] != '"':
                found.setdefault(triple[2], []).append(triple)
        return found

    @cached_property
    def _stated(self) -> dict[Triple, None]:
        """The triples of the text, each once."""
        return dict.fromkeys(chain.from_iterable(element.triples for element in self._elements))

    @cached_property
    def _describing(self) -> dict[Term, list[TracedElement]]:
        """The elements that state something of a node."""
        found: dict[Term, list[TracedElement]] = {}
        for element in self._elements:
            nodes = dict.fromkeys(triple[0] for triple in element.triples)
            for node in nodes if element.lazy else {**nodes, **element.tracks.objects}:
                found.setdefault(node, []).append(element)
        return found

    @cached_property
    def _mentioning(self) -> dict[Term, list[TracedElement]]:
        """The elements in which a node is a value, or named without a statement."""
        found: dict[Term, list[TracedElement]] = {}
        for element in self._elements:
            nodes = {triple[2] for triple in element.triples if triple[2][0] != '"'}
            if not element.lazy:
                nodes |= {node for node, _ in _named(element.tracks)}
            for node in nodes:
                found.setdefault(node, []).append(element)
        return found

    def _silent(self, node: Term) -> list[Object]:
        """Return the objects that have *node* as identifier and say nothing."""
        return [
            element
            for mentioning in self._mentioning.get(node, ())
            for name, element in _named(mentioning.tracks)
            if name == node and id(element) not in self.trace.subjects
        ]

    @cached_property
    def graph(self) -> Place | None:
        """The `@graph` of the outermost object."""
        root = self.tree.root
        key = self.key_of(root, "@graph") if isinstance(root, Object) else None
        return Place(root, key, Seat(root, key)) if key is not None else None

    def within(self, span: Span) -> Sequence[Triple]:
        """Return the triples whose values are written in *span*."""
        first = max(bisect_right(self._starts, span.start) - 1, 0)
        last = bisect_left(self._starts, span.end)
        found: list[tuple[int, Triple]] = []
        for element in (*self._elements[first:last], self._elements[-1]):
            placed = element.tracks.by_start
            found += placed[_first(placed, span.start) : _first(placed, span.end)]
        return [triple for _, triple in sorted(found)]

    def spans(self, triple: Triple) -> list[Span]:
        """Return the spans of the value of *triple*."""
        found: dict[Span, None] = {}
        for element in self._describing.get(triple[0], ()):
            if triple in element.triples:
                tracks = element.tracks
                found |= dict.fromkeys([tracks.spans[triple], *tracks.again.get(triple, ())])
        return list(found)

    def places(self, triple: Triple) -> list[Place | None]:
        """Return each place of *triple*.

        None for one that is in a map, or no value under a key for its property.
        """
        return [self._place(triple, span) for span in self.spans(triple)]

    def objects(self, node: Term) -> list[Object]:
        """Return the objects that describe *node*, those with types first, or else name it."""
        describing = self._describing.get(node, ())
        found = [each for element in describing for each in element.tracks.objects.get(node, ())]
        return sorted(
            found or self._silent(node), key=lambda each: self.key_of(each, "@type") is None
        )

    def subject(self, element: Object) -> Term | None:
        """Return the node that *element* describes or names."""
        self._trace(element)
        return self.trace.subjects.get(id(element))

    def scope(self, element: Object) -> ContextScope | None:
        """Return the contexts at *element*; None if it is a map or lost."""
        self._trace(element)
        return self.trace.processor.scopes.get(id(element))

    def _trace(self, element: Object) -> None:
        """Trace the element of the outermost graph in which *element* stands, if it is in one."""
        number = bisect_right(self._starts, element.start) - 1
        if number >= 0:
            self._elements[number].tracks  # noqa: B018

    def meaning(self, element: Object, key: str) -> str | None:
        """Return the IRI that *key* of *element* expands to."""
        scope = self.scope(element)
        if scope is None:
            return None
        found: Any = self.trace.processor._expand_iri(scope.keys, str(key), vocab=True)  # noqa: SLF001
        return found if isinstance(found, str) else None

    def is_reverse(self, element: Object, key: str) -> bool:
        """Tell whether *key* of *element* is a reverse property."""
        scope = self.scope(element)
        mapping = scope.keys["mappings"].get(str(key)) if scope else None
        return bool(mapping and mapping["reverse"])

    def key_of(self, element: Object, meaning: str) -> Key | None:
        """Return a key of *element* that expands to *meaning*."""
        return next(self.keys_of(element, meaning), None)

    def keys_of(self, element: Object, meaning: str) -> Iterator[Key]:
        """Yield the keys of *element* that expand to *meaning* and point away from it."""
        for key in element:
            if self.meaning(element, key) == meaning and not self.is_reverse(element, key):
                assert isinstance(key, Key)
                yield key

    def seat(self, span: Span) -> Seat | None:
        """Return the value for which the token at *span* stands: of an `@id`, all of its object."""
        seat = self.tree.seat_at(span.start)
        if seat is None or not isinstance(seat.holder, Object) or not isinstance(seat.at, Key):
            return seat
        if self.meaning(seat.holder, seat.at) in _CONTENT:
            return self.tree.seat(seat.holder)
        return seat

    def _place(self, triple: Triple, span: Span) -> Place | None:
        seat = item = self.seat(span)
        while seat is not None:
            holder, at = seat
            if isinstance(holder, Object) and isinstance(at, Key):
                if self.scope(holder) is None:
                    return None
                if self.meaning(holder, at) not in _WRAPPERS:
                    break
            seat = self.tree.seat(holder)
        if seat is None or item is None or not isinstance(seat.at, Key):
            return None
        owner, prop = seat.holder, "@type" if triple[1] == RDF_TYPE else iri_value(triple[1])
        assert isinstance(owner, Object)
        fits = self.meaning(owner, seat.at) == prop and not self.is_reverse(owner, seat.at)
        return Place(owner, seat.at, item) if fits and self._describes(owner, triple[0]) else None

    def _describes(self, owner: Object, node: Term) -> bool:
        """Tell whether *owner* is an object of *node*, or nested in one without being a node."""
        while (subject := self.subject(owner)) is None:
            seat = self.tree.seat(owner)
            if seat is None or not isinstance(seat.holder, Object):
                return False
            owner = seat.holder
        return subject == node


def _named(tracks: Tracks) -> Iterator[tuple[Term, Object]]:
    """Yield the objects that have an identifier, with the node that it means."""
    for origin in tracks.origins.values():
        if origin.identifier is not None:
            yield iri(origin.identifier), origin.element


def _first(placed: Sequence[tuple[int, Triple]], offset: int) -> int:
    """Return the number of the first triple that is *placed* at *offset* or behind it."""
    return bisect_left(placed, offset, key=lambda each: each[0])
