"""Finds the places of what results speak of."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from urllib.parse import unquote

from kinlint.anonymous import AnonymousNodes
from kinlint.display import Display
from kinlint.document import TREES, Document, document_of
from kinlint.engine.axioms import Axiom
from kinlint.engine.constraint import PLAIN, Constraint
from kinlint.engine.explanation import explain
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.terms import RDF_TYPE, Term, iri, is_blank, is_iri, is_literal, literal, literal_value
from kinlint.text import Location, Span
from kinlint.vocabulary import SRC

FROM = iri(f"{SRC}from")
OWN = iri(f"{SRC}ownNamespace")


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
            if document.format in TREES:
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
        for each in (node, *self.origins(node)):
            document = self._described(each)
            if document is not None:
                return document.location(document.map.nodes[each].best)
        return None

    def _described(self, node: Term) -> Document | None:
        """The document that describes *node* first."""
        owner = self.store.documents.get(document_of(node))
        if owner is not None and node in owner.map.nodes:
            return owner
        found = self.homes.get(node) or self._anonymous_homes.get(node)
        return found[0] if found else None

    @cached_property
    def _anonymous_homes(self) -> Mapping[Term, list[Document]]:
        """The files of elements that lost something, by the nodes that stand for the loss."""
        return {
            node: [document]
            for document in self.documents
            if document.format in TREES
            for node in document.map.nodes
            if is_blank(node)
        }

    def origins(self, node: Term) -> Sequence[Term]:
        """The elements that *node* was lifted from."""
        if not is_iri(node) or document_of(node) not in self.store.documents:
            return ()
        return tuple(self.store.values(node, FROM))

    def _written(self, element: Term, value: Term) -> tuple[Location, Term] | None:
        """Where *element*, or one right below it, has what *value* was made of, and as what."""
        address = f"{element[:-1]}/"
        below = [each for _, each in self.store.said(element) if each.startswith(address)]
        for spelled in (value,) if is_literal(value) else _names(value):
            for each in (element, *below):
                if (found := self.triple(each, None, spelled)) is not None:
                    return found
        return None

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
            for element in self.origins(subject):
                if (found := self._written(element, value)) is not None:
                    return found
        return None

    def of(self, result: Result, axioms: Sequence[Axiom]) -> Location:
        """The smallest place that shows *result*: a triple, its node, a mention of it, or a file.

        They are those of `?at`, if the rule says so, or else of the focus node. A triple that
        follows by *axioms* is shown by the first one written that it follows from.
        """
        at = result.bindings.get("at", result.focus)
        if result.path is not None and result.value is not None:
            triple = at, result.path, result.value
            proof = explain(self.store, axioms, triple) if self.store.is_inferred(triple) else ()
            for subject, predicate, value in (triple, *(step.triple for step in proof)):
                if (said := self.triple(subject, predicate, value)) is not None:
                    return said[0]
        place = self.node(at) or self.node(result.focus) or self._mentions.get(at)
        return place or self.documents[0].location(Span(0, 0))

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
            own = tuple(literal_value(o) for _, p, o in document.statements if p == OWN)
            self._displays[document.graph] = Display(document.prefixes, own)
        return self._displays[document.graph]

    @cached_property
    def _displays(self) -> dict[Term, Display]:
        return {}


def _names(node: Term) -> Iterator[Term]:
    """The names in the address of what was lifted, the last one first, as files spell them."""
    steps = node[:-1].partition("#")[2].split("/")
    for step in reversed(steps):
        yield literal(unquote(step))
