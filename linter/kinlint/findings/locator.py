"""Finds the places of what results speak of."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import NamedTuple

from kinlint.addresses import document_of
from kinlint.document import FROM, Document, NodeSpans
from kinlint.engine.axioms import Axiom
from kinlint.engine.constraint import Constraint, predicates
from kinlint.engine.explanation import explain
from kinlint.engine.provenance import Provenance, Trace
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.findings.blank_node_names import AnonymousNodes
from kinlint.formats.xml.schema import kinds
from kinlint.light_dataclasses import dataclass, replace
from kinlint.term_format import TermFormatter
from kinlint.terms import (
    RDF_TYPE,
    Term,
    Triple,
    iri,
    is_blank,
    is_iri,
    literal_value,
)
from kinlint.text import Location, Span
from kinlint.vocabulary import QUDT, SRC

OWN = iri(f"{SRC}ownNamespace")
UNIT = iri(f"{QUDT}unit")
COMPONENT = re.compile(r"-\d+>$")
"""End of the properties that have one of several numbers: `at:xyz-1`."""


class Source(NamedTuple):
    """A place where a value, or something that it was computed from, is written."""

    location: Location
    """The place."""
    triple: Triple
    """The triple of a document that is written there; the first of several numbers."""


@dataclass(frozen=True)
class Locator:
    """The documents of a run, and the store that knows which of them says what."""

    documents: Sequence[Document]
    """Documents of the run."""
    store: Store
    """Store that tells which document contains a triple."""

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
        """Return the place where *node* is described, or for a lifted one, its element."""
        found = self._spans(node)
        return found[0].location(found[1].best) if found is not None else None

    def whole(self, node: Term) -> Location | None:
        """Return all of the description of *node* that `node` points to."""
        found = self._spans(node)
        return found[0].location(found[1].whole) if found is not None else None

    def _spans(self, node: Term) -> tuple[Document, NodeSpans] | None:
        for each in (node, *self.origins(node)):
            document = self._described(each)
            if document is not None:
                return document, document.map.nodes[each]
        return None

    def _described(self, node: Term) -> Document | None:
        """Return the document that describes *node* first."""
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
        """Return the elements that *node* was lifted from."""
        if not is_iri(node) or document_of(node) not in self.store.documents:
            return ()
        return tuple(self.store.values(node, FROM))

    @cached_property
    def provenance(self) -> Provenance:
        """The origins of what was lifted."""
        return Provenance(self.store)

    def sources(self, subject: Term, predicate: Term | None, value: Term) -> Sequence[Source]:
        """Return where *value* is written as a value of *subject*, or all that it follows from.

        No *predicate* means any, of what documents state.
        """
        for document, triple in self.store.written(subject, predicate, value):
            if (span := document.map.triples.get(triple)) is not None:
                return (Source(document.location(span), triple),)
        if predicate is None:
            return ()
        return self._places(self.provenance.trace((subject, predicate, value)))

    def _places(self, trace: Trace) -> Sequence[Source]:
        """Return where *trace* leads to.

        What one element says is one place, from the first to the last of its values.
        """
        found: dict[tuple[Term, Term], list[Source]] = {}
        for document, triple in trace.written:
            if (span := document.map.triples.get(triple)) is not None:
                place = Source(document.location(span), triple)
                found.setdefault((document.graph, triple[0]), []).append(place)
        return [
            Source(_around([each.location for each in group]), group[0].triple)
            for group in found.values()
        ]

    def premise(self, triple: Triple) -> Location | None:
        """Return the place of *triple*, or of what it was lifted from; None for implied units."""
        if found := self.sources(*triple):
            return found[0].location
        subject, predicate, _ = triple
        implied = predicate == UNIT or not self.origins(subject)
        return None if implied else self.node(subject)

    def result_location(self, result: Result, axioms: Sequence[Axiom]) -> Location:
        """Return the smallest place that shows *result*: a triple, a node, a mention, or a file.

        These are of `?at`, if the rule says so, or else of the focus node.
        """
        if found := self.result_sources(result, axioms):
            return found[0].location
        at = result.bindings.get("at", result.focus)
        place = self.node(at) or self.node(result.focus) or self._mentions.get(at)
        return place or self.documents[0].location(Span(0, 0))

    def result_sources(self, result: Result, axioms: Sequence[Axiom]) -> Sequence[Source]:
        """Return where the value that shows *result* is written, or all that it follows from.

        A triple that follows by *axioms* is shown by the first one written that it follows from.
        In files of elements, `?spot` may say of which attribute the value shows it. The element of
        the node itself comes before those of others.
        """
        at = result.bindings.get("at", result.focus)
        if result.path is not None and result.value is not None:
            triple = at, result.path, result.value
            proof = explain(self.store, axioms, triple) if self.store.is_inferred(triple) else ()
            for each in (triple, *(step.triple for step in proof)):
                if found := self.sources(*each):
                    return found
        spot = result.bindings.get("spot")
        return self._spot(at, spot) if spot is not None else ()

    def _spot(self, node: Term, property_: Term) -> Sequence[Source]:
        """Return where the values of *property_* that *node* has are written.

        Of an attribute or a text with several numbers that is all of them.
        """
        if document_of(node) not in self.store.documents:
            return ()
        if own := self._numbers(node, property_):
            return (own,)
        trace = self.provenance.property(node, property_)
        spelled = [(triple[0], COMPONENT.sub(">", triple[1])) for _, triple in trace.written]
        found = (self._numbers(element, way) for element, way in dict.fromkeys(spelled))
        return [each for each in found if each is not None]

    def _numbers(self, element: Term, property_: Term) -> Source | None:
        """Return the place from the first to the last value that *element* has for *property_*."""
        found = [
            source
            for way, value in self.store.predicate_objects(element)
            if COMPONENT.sub(">", way) == property_
            for source in self.sources(element, way, value)[:1]
        ]
        places = [each.location for each in found]
        return Source(_around(places), found[0].triple) if found else None

    @cached_property
    def _mentions(self) -> Mapping[Term, Location]:
        """The first place of each term that is a value, for what no file describes."""
        found: dict[Term, Location] = {}
        for document in self.documents:
            for (_, _, value), span in document.map.triples.items():
                found.setdefault(value, document.location(span))
        return found

    def may_be_inferred(self, constraint: Constraint) -> bool:
        """Tell whether something that *constraint* matches may have been inferred."""
        if constraint not in self._judged:
            self._judged[constraint] = any(
                self.store.infers(predicate, value if is_iri(value) else None)
                for _, path, value in (*constraint.premises, *constraint.targets)
                for predicate in predicates(path)
            )
        return self._judged[constraint]

    @cached_property
    def _judged(self) -> dict[Constraint, bool]:
        return {}

    def described(self, focus: Term) -> Term:
        """Return the entity that a statement of the source layer describes, or else *focus*."""
        if not is_blank(focus):
            return focus
        return self._about.get(focus, focus)

    @cached_property
    def _about(self) -> Mapping[Term, Term]:
        return {node: about for each in self.documents for node, about in each.about.items()}

    def anonymous(self, node: Term, location: Location) -> Term:
        """Return a label for a blank node that survives edits of other nodes."""
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

    def document(self, location: Location) -> Document | None:
        """Return the document that the text of *location* is a part of."""
        return self._by_source.get(id(location.source))

    def display(self, location: Location) -> TermFormatter:
        """Return the formatter of terms with the prefixes of the file of *location*."""
        document = self.document(location)
        if document is None:
            return TermFormatter(kinds=self.kinds)
        if document.graph not in self._displays:
            own = tuple(literal_value(o) for _, _, o in document.saying(OWN))
            self._displays[document.graph] = TermFormatter(
                document.prefixes, own, document.map.nodes, self.kinds
            )
        return self._displays[document.graph]

    @cached_property
    def kinds(self) -> frozenset[str]:
        """The tags of elements that are spoken of by name alone."""
        forms = {each.format.lifted_as: each.format for each in self.documents}
        return frozenset().union(*map(kinds, forms.values()))

    @cached_property
    def _displays(self) -> dict[Term, TermFormatter]:
        return {}


def _around(places: Sequence[Location]) -> Location:
    """Return the place from the first to the last of *places* that are in the text of the first."""
    first = places[0]
    spans = [each.span for each in places if each.source is first.source]
    return replace(
        first, span=Span(min(each.start for each in spans), max(each.end for each in spans))
    )
