"""States an element of JSON with places, and tells what is worth telling of it."""

from __future__ import annotations

from typing import Any

from kinlint.document import NodeSpans
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.json_text.json_values import Array, Key, Object
from kinlint.formats.jsonld.compiled.term_table import Declined, Meaning, Shape, TermTable
from kinlint.formats.jsonld.compiled.walk import Walk
from kinlint.formats.jsonld.expansion_observer import Slot
from kinlint.formats.jsonld.losses import LossObserver
from kinlint.formats.jsonld.triples import FIRST, NIL, REST
from kinlint.terms import RDF_TYPE, Term, Triple
from kinlint.text import Span


class PlacedWalk(Walk):
    """Statements of one element and the nodes that it describes, with their places."""

    def __init__(self, blanks: BlankNodes, watch: LossObserver) -> None:
        super().__init__(blanks)
        self.spans: dict[Triple, Span] = {}
        """Statements with the places of the values."""
        self.nodes: dict[Term, NodeSpans] = {}
        """Nodes that it describes."""
        self._watch = watch

    def _shape(self, element: dict[str, Any], table: TermTable) -> Shape:
        return table.shape(tuple(element))

    def _types(self, subject: Term, classes: list[Term], key: str, value: Any) -> None:
        slot, seen = Slot(RDF_TYPE, "@type", _span(key)), set[Term]()
        for term, place in zip(classes, _items(key, value)[1], strict=True):
            self._add(subject, slot, term, place, seen)

    def _add(self, subject: Term, slot: Slot, term: Term, place: Span, seen: set[Term]) -> None:
        if term in seen:
            self._watch.note_repeated(subject, slot, term, place)
        seen.add(term)
        self.spans.setdefault((subject, slot.prop or "", term), place)

    def _property(self, subject: Term, meaning: Meaning, key: str, value: Any) -> None:
        slot, seen = Slot(meaning.predicate, str(key), _span(key)), set[Term]()
        if meaning.listed:
            head = self._listed(meaning, key, value)
            place = _span(next(iter(value))) if isinstance(value, dict) else slot.stands
            self._add(subject, slot, head, place, seen)
            return
        for each, place in zip(*_items(key, value), strict=True):
            self._add(subject, slot, *self._placed_value(meaning, key, each, place), seen)

    def _placed_value(
        self, meaning: Meaning, key: str, value: Any, place: Span
    ) -> tuple[Term, Span]:
        if not isinstance(value, dict):
            return self._value(meaning, key, value), place
        term, standing = self._object(meaning, key, value)
        return term, place if standing is None else _span(standing)

    def _list(self, meaning: Meaning, key: str, value: Any) -> Term:
        elements, places = _items(key, value)
        if not elements:
            return NIL
        span = _span(key)
        cells = [*(self.blanks.fresh() for _ in elements), NIL]
        for number, (each, place) in enumerate(zip(elements, places, strict=True)):
            term, at = self._placed_value(meaning, key, each, place)
            self.spans.setdefault((cells[number], FIRST, term), at)
            self.spans.setdefault((cells[number], REST, cells[number + 1]), span)
        return cells[0]

    def _describe(self, subject: Term, element: dict[str, Any], naming: str | None) -> None:
        if isinstance(element, Object) and subject not in self.nodes:
            self.nodes[subject] = NodeSpans(element.span, None if naming is None else _span(naming))

    def _nested(
        self, node: Term, meaning: Meaning, key: str, element: dict[str, Any], naming: str | None
    ) -> None:
        depth = len(self.around)
        if depth > 1 and isinstance(element, Object):
            start = Span(element.start, element.start + 1) if naming is None else _span(naming)
            slot = Slot(meaning.predicate, str(key), _span(key))
            self._watch.nested(node, slot, start, depth, self.around[0])


def _span(key: str) -> Span:
    """Return the place of the value of *key*."""
    if not isinstance(key, Key):
        raise Declined("a member without a place")
    return key.value_span


def _items(key: str, value: Any) -> tuple[list[Any], list[Span]]:
    """Return the values of a member, with their places."""
    if isinstance(value, Array):
        return value, [value.element_span(number) for number in range(len(value))]
    return [value], [_span(key)]
