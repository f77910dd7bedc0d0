"""Finds the places of what results speak of."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from operator import itemgetter
from urllib.parse import unquote

from kinlint.addresses import document_of
from kinlint.document import FROM, Document, NodeSpans
from kinlint.engine.axioms import Axiom
from kinlint.engine.constraint import PLAIN, Constraint
from kinlint.engine.explanation import explain
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.findings.blank_node_names import AnonymousNodes
from kinlint.term_format import Display
from kinlint.terms import (
    RDF_TYPE,
    Term,
    Triple,
    iri,
    is_blank,
    is_iri,
    is_literal,
    literal,
    literal_value,
)
from kinlint.text import Location, Span
from kinlint.vocabulary import QUDT, SRC

ANGLES = ("alpha", "beta", "gamma")
OWN = iri(f"{SRC}ownNamespace")
TEXT = iri(f"{SRC}text")
UNIT = iri(f"{QUDT}unit")
COMPONENTS = {name: str(1 + i % 3) for i, name in enumerate(("x", "y", "z", *ANGLES))}
"""Which number of a vector is the value of a property."""


@dataclass(frozen=True)
class Locator:
    """The documents of a run, and the store that knows which of them says what."""

    documents: Sequence[Document]
    store: Store

    @cached_property
    def homes(self) -> Mapping[Term, list[Document]]:
        """The documents that describe each node, those that say what it is first."""
        homes: dict[Term, list[Document]] = {}
        for document in self.documents:
            if document.format.is_tree:
                continue
            for node in document.map.nodes:
                homes.setdefault(node, []).append(document)
        shared = {node: found for node, found in homes.items() if len(found) > 1}
        if shared:
            typed = {
                (d.graph, s) for d in self.documents for s, p, _ in d.statements if p == RDF_TYPE
            }
            for node, found in shared.items():
                found.sort(key=lambda document, node=node: (document.graph, node) not in typed)  # type: ignore[misc]
        return homes

    def node(self, node: Term) -> Location | None:
        """Where *node* is described; what was lifted, where the element is that it is from."""
        found = self._spans(node)
        return found[0].location(found[1].best) if found is not None else None

    def whole(self, node: Term) -> Location | None:
        """All of the description of *node* that `node` points to."""
        found = self._spans(node)
        return found[0].location(found[1].whole) if found is not None else None

    def _spans(self, node: Term) -> tuple[Document, NodeSpans] | None:
        for each in (node, *self.origins(node)):
            document = self._described(each)
            if document is not None:
                return document, document.map.nodes[each]
        return None

    def _described(self, node: Term) -> Document | None:
        """The document that describes *node* first."""
        owner = self.store.documents.get(document_of(node))
        if owner is not None and node in owner.map.nodes:
            return owner
        if len(self.documents) == 1:
            (only,) = self.documents
            known = not only.format.is_tree or is_blank(node)
            return only if known and node in only.map.nodes else None
        found = self.homes.get(node) or self._anonymous_homes.get(node)
        return found[0] if found else None

    @cached_property
    def _anonymous_homes(self) -> Mapping[Term, list[Document]]:
        """The files of elements that lost something, by the nodes that stand for the loss."""
        return {
            node: [document]
            for document in self.documents
            if document.format.is_tree
            for node in document.map.nodes
            if is_blank(node)
        }

    def origins(self, node: Term) -> Sequence[Term]:
        """The elements that *node* was lifted from."""
        if not is_iri(node) or document_of(node) not in self.store.documents:
            return ()
        return tuple(self.store.values(node, FROM))

    def _written(
        self, elements: Iterable[Term], predicate: Term, value: Term
    ) -> tuple[Location, Term] | None:
        """Where one of *elements*, or one right below, has what *value* was made of, and as what.

        Of several places with the same number it is the one that *predicate* is called after.
        """
        asked = [each for element in elements for each in (element, *self._below(element))]
        for spelled in (value,) if is_literal(value) else _names(value):
            places = [
                (_likeness(predicate, each, triple[1]), document.location(span), triple[1])
                for each in asked
                for document, triple in self.store.written(each, None, spelled)
                if (span := document.map.triples.get(triple)) is not None
            ]
            if places:
                _, place, written = max(places, key=itemgetter(0))
                return place, written
        return None

    def _below(self, element: Term) -> Iterator[Term]:
        """The elements right below *element*."""
        address = f"{element[:-1]}/"
        return (each for _, each in self.store.said(element) if each.startswith(address))

    def triple(
        self, subject: Term, predicate: Term | None, value: Term
    ) -> tuple[Location, Term] | None:
        """Where *value* is written as a value of *subject*, and of which predicate.

        No *predicate* means any.
        """
        for document, triple in self.store.written(subject, predicate, value):
            if (span := document.map.triples.get(triple)) is not None:
                return document.location(span), triple[1]
        if predicate is not None:
            return self._written(self.origins(subject), predicate, value)
        return None

    def premise(self, triple: Triple) -> Location | None:
        """Where *triple* is written, or what it was lifted from; a unit that it implies nowhere."""
        subject, predicate, value = triple
        if (said := self.triple(subject, predicate, value)) is not None:
            return said[0]
        implied = predicate == UNIT or not self.origins(subject)
        return None if implied else self.node(subject)

    def of(self, result: Result, axioms: Sequence[Axiom]) -> Location:
        """The smallest place that shows *result*: a triple, its node, a mention of it, or a file.

        They are those of `?at`, if the rule says so, or else of the focus node. A triple that
        follows by *axioms* is shown by the first one written that it follows from. In files of
        elements, `?spot` may say of which attribute the value shows it.
        """
        at = result.bindings.get("at", result.focus)
        if result.path is not None and result.value is not None:
            triple = at, result.path, result.value
            proof = explain(self.store, axioms, triple) if self.store.is_inferred(triple) else ()
            for subject, predicate, value in (triple, *(step.triple for step in proof)):
                if (said := self.triple(subject, predicate, value)) is not None:
                    return said[0]
        if (spot := result.bindings.get("spot")) is not None and (shown := self._spot(at, spot)):
            return shown
        place = self.node(at) or self.node(result.focus) or self._mentions.get(at)
        return place or self.documents[0].location(Span(0, 0))

    def _spot(self, node: Term, attribute: Term) -> Location | None:
        """Where the value of *attribute* is written, with all its numbers, in the element *node*.

        That is the element itself or the one it was lifted from. Where an element has no such
        attribute, it is the text of its child of that name, or its own.
        """
        name = _local_name(attribute)
        for element in (node, *self.origins(node)):
            if (found := self._numbers(element, attribute)) is not None:
                return found
            children = (
                each
                for way, each in self.store.said(element)
                if is_iri(each) and _local_name(way) == name
            )
            for each in (*children, element):
                if (found := self._numbers(each, TEXT)) is not None:
                    return found
        return None

    def _numbers(self, element: Term, property_: Term) -> Location | None:
        """From the first to the last of the values that *element* has for *property_*."""
        stem = f"{property_[:-1]}-"
        found = [
            said[0]
            for way, value in self.store.said(element)
            if (way == property_ or (way.startswith(stem) and way[len(stem) : -1].isdecimal()))
            and (said := self.triple(element, way, value)) is not None
        ]
        if not found or any(each.source is not found[0].source for each in found):
            return None
        start, end = min(each.span.start for each in found), max(each.span.end for each in found)
        return replace(found[0], span=Span(start, end))

    @cached_property
    def _mentions(self) -> Mapping[Term, Location]:
        """The first place of each term that is a value, for what no file describes."""
        found: dict[Term, Location] = {}
        for document in self.documents:
            for (_, _, value), span in document.map.triples.items():
                found.setdefault(value, document.location(span))
        return found

    def may_be_inferred(self, constraint: Constraint) -> bool:
        """Whether something that *constraint* matches may have been inferred."""
        if constraint not in self._judged:
            self._judged[constraint] = any(
                self.store.infers(p if PLAIN.fullmatch(p) else None, o if is_iri(o) else None)
                for _, p, o in (*constraint.premises, *constraint.targets)
            )
        return self._judged[constraint]

    @cached_property
    def _judged(self) -> dict[Constraint, bool]:
        return {}

    def about(self, focus: Term) -> Term:
        """The entity concerned: what a statement of the source layer speaks of, or *focus*."""
        if not is_blank(focus):
            return focus
        return self._about.get(focus, focus)

    @cached_property
    def _about(self) -> Mapping[Term, Term]:
        return {node: about for each in self.documents for node, about in each.about.items()}

    def anonymous(self, node: Term, location: Location) -> Term:
        """A label for a blank node that survives edits of other nodes."""
        document = self._by_source.get(id(location.source))
        if document is None:
            return node
        if document.graph not in self._anonymous:
            self._anonymous[document.graph] = AnonymousNodes(document)
        return self._anonymous[document.graph].label(node)

    @cached_property
    def _anonymous(self) -> dict[Term, AnonymousNodes]:
        return {}

    @cached_property
    def _by_source(self) -> Mapping[int, Document]:
        """The documents by the identity of each text that they are made of."""
        return {id(text): each for each in reversed(self.documents) for text in each.sources}

    def display(self, location: Location) -> Display:
        """How the file of *location* abbreviates."""
        document = self._by_source.get(id(location.source))
        if document is None:
            return Display()
        if document.graph not in self._displays:
            own = tuple(literal_value(o) for _, _, o in document.saying(OWN))
            self._displays[document.graph] = Display(document.prefixes, own, document.map.nodes)
        return self._displays[document.graph]

    @cached_property
    def _displays(self) -> dict[Term, Display]:
        return {}


def _likeness(predicate: Term, element: Term, written: Term) -> int:
    """How much a property that was lifted is like what may have been written for it."""
    wanted, attribute = _local_name(predicate), _local_name(written)
    if wanted in (attribute, element[:-1].rpartition("/")[2]):
        return 2
    return int(COMPONENTS.get(wanted, "") == attribute.rpartition("-")[2])


def _names(node: Term) -> Iterator[Term]:
    """The names in the address of what was lifted, the last one first, as files spell them."""
    steps = node[:-1].partition("#")[2].split("/")
    for step in reversed(steps):
        yield literal(unquote(step))


def _local_name(property_: Term) -> str:
    return property_[:-1].rpartition("#")[2]
