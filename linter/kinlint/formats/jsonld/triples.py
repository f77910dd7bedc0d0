"""Expanded JSON-LD as triples in the order of the text (JSON-LD 1.1 API, 8)."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from kinlint.document import NodeSpans
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.jsonld.expansion_observer import ExpansionObserver, Slot
from kinlint.formats.jsonld.rdf_literals import malformed, value_literal
from kinlint.formats.jsonld.traced_values import Expanded, Iri, Origin, value_span
from kinlint.terms import RDF, RDF_TYPE, Term, Triple, iri, literal
from kinlint.text import Span

FIRST, REST, NIL = iri(f"{RDF}first"), iri(f"{RDF}rest"), iri(f"{RDF}nil")

# Stands for the name of a graph that cannot be named: its triples are in no graph of a dataset.
_NAMELESS: Term = ""

_ABSOLUTE = re.compile(r"[A-Za-z][A-Za-z0-9+-.]*:[^\s]*$")


class Quads(list[tuple[Term, Term, Term, Term | None]]):
    """Triples with the name of their graph, None for the default graph."""


class Triples:
    """Collects what expanded documents state.

    `spans` holds each triple once, with the place of its value; `nodes` the places of all nodes
    that have a type or property. Graphs are flattened unless `quads` asks for them. The options
    of the specification: `direction` is `rdfDirection`, *generalized* `produceGeneralizedRdf`.
    """

    def __init__(
        self,
        blanks: BlankNodes,
        watch: ExpansionObserver | None = None,
        quads: Quads | None = None,
        direction: str | None = None,
        *,
        generalized: bool = False,
    ) -> None:
        self.spans: dict[Triple, Span] = {}
        self.nodes: dict[Term, NodeSpans] = {}
        self._blanks = blanks
        self._watch = watch
        self._quads = quads
        self._direction = direction
        self._generalized = generalized
        self._graph: Term | None = None
        self._tokens: dict[str, Term | None] = {}
        self._subjects: set[Term] = set()
        self._round: list[Term | None] = []

    def add(self, nodes: list[Any], around: Span) -> None:
        """State all that the expanded *nodes*, written within *around*, say."""
        outer, self._round = self._round, []
        for node in nodes:
            if "@value" not in node:
                self._node(node, getattr(node, "span", around))
        self._round = outer

    def named(self, origin: Origin) -> Term:
        """Return the node that an object describes or belongs to, be it only in name."""
        owner = origin.owner
        if owner.subject is None:
            owner.subject = self._term(owner.identifier) or self._blanks.fresh()
        return owner.subject

    def _emit(
        self, subject: Term | None, prop: Term | None, value: Term | None, span: Span
    ) -> None:
        if subject is None or prop is None or value is None:
            return
        self.spans.setdefault((subject, prop, value), span)
        self._subjects.add(subject)
        if self._quads is not None and self._graph != _NAMELESS:
            self._quads.append((subject, prop, value, self._graph))

    def _term(self, name: Any) -> Term | None:
        """Return the token of an expanded IRI or blank node; None if it is neither."""
        if not isinstance(name, str):
            return None
        if name not in self._tokens:
            token = None
            if name.startswith("_:"):
                token = self._blanks.named(name[2:])
            elif _ABSOLUTE.match(name) and not malformed(name):
                token = iri(name)
            self._tokens[str(name)] = token
        return self._tokens[name]

    def _predicate(self, name: str) -> Term | None:
        blank = name.startswith("_:") and not self._generalized
        return None if blank else self._term(name)

    def _see(self, name: Any, role: str, node: Term | None, slot: Slot | None = None) -> None:
        if self._watch is not None and isinstance(name, Iri):
            self._watch.seen(name, role, node, slot)

    def _again(
        self, subject: Term | None, slot: Slot, value: Term | None, span: Span, seen: set[Term]
    ) -> None:
        if value is None:
            return
        if value in seen and subject is not None and self._watch is not None:
            self._watch.note_repeated(subject, slot, value, span)
        seen.add(value)

    def _node(self, node: dict[str, Any], whole: Span) -> Term | None:
        """State a node and return its term."""
        name = node.get("@id")
        subject = self._term(name) if "@id" in node else self._blanks.fresh()
        identifier = name.span if isinstance(name, Iri) else None
        if isinstance(node, Expanded) and node.origin is not None and subject is not None:
            node.origin.subject = subject
        if len(node) > 1:
            self._see(name, "identifier", subject)
        self._round.append(subject)
        for prop, values in _in_order(node):
            if prop[:1] != "@":
                self._property(subject, prop, values, whole)
            else:
                self._keyword(prop, values, node, subject, whole)
        self._round.pop()
        if subject is None or subject in self.nodes or subject not in self._subjects:
            return subject
        if any(prop[:1] != "@" or prop == "@type" for prop in node):
            self.nodes[subject] = NodeSpans(whole, identifier)
        return subject

    def _keyword(
        self, keyword: str, values: Any, node: dict[str, Any], subject: Term | None, whole: Span
    ) -> None:
        if keyword == "@id":
            return
        name = node.get("@id")
        place = name.span if isinstance(name, Iri) else whole
        if keyword == "@type":
            self._types(subject, values, node, place)
        elif keyword == "@reverse":
            self._reversed(subject, values, place)
        elif keyword == "@graph":
            self._named_graph(subject, name, values, whole)
        elif keyword == "@included":
            self.add(values, whole)

    def _types(
        self, subject: Term | None, types: list[Any], node: dict[str, Any], place: Span
    ) -> None:
        slot, seen = Slot(RDF_TYPE, "@type", place), set[Term]()
        for name in types:
            if self._watch is not None and isinstance(name, Iri):
                self._watch.type(name, subject, getattr(node, "origin", None))
            span = name.span if isinstance(name, Iri) else place
            self._again(subject, slot, self._term(name), span, seen)
            self._emit(subject, RDF_TYPE, self._term(name), span)

    def _named_graph(self, subject: Term | None, name: Any, content: list[Any], at: Span) -> None:
        if self._watch is not None and isinstance(name, Iri) and subject is not None:
            self._watch.graph(name)
        outer, self._graph = self._graph, subject or _NAMELESS
        self.add(content, at)
        self._graph = outer

    def _property(self, subject: Term | None, prop: str, values: list[Any], at: Span) -> None:
        self._see(prop, "property", subject)
        slot, seen = self._slot(prop, value_span(prop) or at), set[Term]()
        for item in values:
            value, span = self._value(subject, slot, item)
            self._again(subject, slot, value, span, seen)
            self._emit(subject, slot.prop, value, span)

    def _slot(self, prop: str, stands: Span) -> Slot:
        written = prop.token if isinstance(prop, Iri) else prop
        return Slot(self._predicate(prop), str(written), stands)

    def _reversed(self, subject: Term | None, values: dict[str, Any], place: Span) -> None:
        for prop, nodes in values.items():
            self._see(prop, "property", subject)
            for node in nodes:
                whole = getattr(node, "span", None) or place
                slot = self._slot(prop, whole)
                other, span = self._value(subject, slot, node)
                self._emit(other, slot.prop, subject, place)
                if slot.prop is None or other is None:
                    continue
                self.nodes.setdefault(other, NodeSpans(whole, span if span != whole else None))

    def _value(self, subject: Term | None, slot: Slot, item: Any) -> tuple[Term | None, Span]:
        """State the value of a property; return its term and its place."""
        if "@list" in item:
            return self._list(subject, slot, item)
        if "@value" in item:
            return self._literal(subject, item, slot.stands)
        whole = getattr(item, "span", None) or slot.stands
        name = item.get("@id")
        place = name.span if isinstance(name, Iri) else whole
        if len(item) == 1 and "@id" in item:
            self._see(name, "value", subject, slot)
            named = self._term(name)
            if isinstance(item, Expanded) and item.origin is not None and named is not None:
                item.origin.subject = named
            return named, place
        node, depth = self._node(item, whole), len(self._round)
        if self._watch is not None and node is not None and depth > 1:
            start = place if isinstance(name, Iri) else Span(whole.start, whole.start + 1)
            outermost = self._round[0]
            if outermost is not None and item:
                self._watch.nested(node, slot, start, depth, outermost)
        return node, place

    def _literal(
        self, subject: Term | None, item: dict[str, Any], stands: Span
    ) -> tuple[Term | None, Span]:
        span = _value_token(item) or stands
        self._see(item.get("@type"), "datatype", subject)
        if self._direction == "compound-literal" and "@direction" in item:
            compound = self._blanks.fresh()
            for part, key in (("value", "@value"), ("direction", "@direction")):
                self._emit(compound, iri(RDF + part), literal(item[key]), span)
            if "@language" in item:
                self._emit(compound, iri(f"{RDF}language"), literal(item["@language"]), span)
            return compound, span
        value = value_literal(item, directed=self._direction == "i18n-datatype")
        if value is None and self._watch is not None:
            self._watch.value(item, subject, span)
        return value, span

    def _list(self, subject: Term | None, slot: Slot, item: dict[str, Any]) -> tuple[Term, Span]:
        elements = item["@list"]
        span = _list_span(item) or slot.stands
        if not elements:
            return NIL, span
        cells = [*(self._blanks.fresh() for _ in elements), NIL]
        held = subject is not None and slot.prop is not None
        for element, cell, following in zip(elements, cells, cells[1:], strict=False):
            value, place = self._value(subject, slot._replace(stands=span), element)
            if held:
                self._emit(cell, FIRST, value, place)
                self._emit(cell, REST, following, span)
        return cells[0], span


def _in_order(node: dict[str, Any]) -> Iterator[tuple[str, Any]]:
    """Yield the entries of a node as they stand in the text: expansion sorts them by name."""
    entries = [
        (prop.token.start if isinstance(prop, Iri) else -1, prop, values)
        for prop, values in node.items()
    ]
    entries.sort(key=_place)
    for _, prop, values in entries:
        yield prop, values


def _place(entry: tuple[int, str, Any]) -> int:
    return entry[0]


def _value_token(item: dict[str, Any]) -> Span | None:
    span: Span | None = getattr(item["@value"], "span", None)
    if span is not None or not isinstance(item, Expanded):
        return span
    return (value_span(item.origin.content) if item.origin else None) or item.span


def _list_span(item: dict[str, Any]) -> Span | None:
    if isinstance(item, Expanded):
        return (value_span(item.origin.content) if item.origin else None) or item.span
    elements = item["@list"]
    span: Span | None = getattr(elements, "span", None)
    if span is None and len(elements) == 1:
        return _value_token(elements[0]) if "@value" in elements[0] else None
    return span
