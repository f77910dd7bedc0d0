"""Places of triples in a JSON-LD text: the object and the key of each."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any, NamedTuple

from kinlint.formats.json_text.json_values import Key, Object
from kinlint.formats.jsonld.editing.text_path import Seat, TextTree
from kinlint.formats.jsonld.editing.tracing import ContextScope, Trace
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
        self._subjects = trace.tracks.subjects

    @cached_property
    def by_subject(self) -> dict[Term, list[Triple]]:
        """The triples of each node, in the order of the text."""
        found: dict[Term, list[Triple]] = {}
        for triple in self.trace.tracks.spans:
            found.setdefault(triple[0], []).append(triple)
        return found

    @cached_property
    def by_value(self) -> dict[Term, list[Triple]]:
        """The triples that point to each node."""
        found: dict[Term, list[Triple]] = {}
        for triple in self.trace.tracks.spans:
            if triple[2][0] != '"':
                found.setdefault(triple[2], []).append(triple)
        return found

    @cached_property
    def _by_start(self) -> tuple[list[int], list[Triple]]:
        tracks = self.trace.tracks
        starts = [(span.start, triple) for triple, span in tracks.spans.items()]
        starts += [(span.start, triple) for triple, spans in tracks.again.items() for span in spans]
        starts.sort()
        return [start for start, _ in starts], [triple for _, triple in starts]

    @cached_property
    def _silent(self) -> dict[Term, list[Object]]:
        """The objects that have an identifier and say nothing."""
        found: dict[Term, list[Object]] = {}
        for origin in self.trace.processor.origins.values():
            if origin.identifier is not None and id(origin.element) not in self._subjects:
                found.setdefault(iri(origin.identifier), []).append(origin.element)
        return found

    @cached_property
    def graph(self) -> Place | None:
        """The `@graph` of the outermost object."""
        root = self.tree.root
        key = self.key_of(root, "@graph") if isinstance(root, Object) else None
        return Place(root, key, Seat(root, key)) if key is not None else None

    def within(self, span: Span) -> Sequence[Triple]:
        """Return the triples whose values are written in *span*."""
        starts, triples = self._by_start
        return triples[bisect_left(starts, span.start) : bisect_left(starts, span.end)]

    def spans(self, triple: Triple) -> list[Span]:
        """Return the spans of the value of *triple*."""
        tracks = self.trace.tracks
        if triple not in tracks.spans:
            return []
        return list(dict.fromkeys([tracks.spans[triple], *tracks.again.get(triple, ())]))

    def places(self, triple: Triple) -> list[Place | None]:
        """Return each place of *triple*.

        None for one that is in a map, or no value under a key for its property.
        """
        return [self._place(triple, span) for span in self.spans(triple)]

    def objects(self, node: Term) -> list[Object]:
        """Return the objects that describe *node*, those with types first, or else name it."""
        found = self.trace.tracks.objects.get(node) or self._silent.get(node, [])
        return sorted(found, key=lambda each: self.key_of(each, "@type") is None)

    def subject(self, element: Object) -> Term | None:
        """Return the node that *element* describes or names."""
        return self._subjects.get(id(element))

    def scope(self, element: Object) -> ContextScope | None:
        """Return the contexts at *element*; None if it is a map or lost."""
        return self.trace.processor.scopes.get(id(element))

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
