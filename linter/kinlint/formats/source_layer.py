"""States what a file is, which nodes it describes, and what of it the graph does not say."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from functools import lru_cache

from kinlint.document import NodeSpans
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import (
    RDF_TYPE,
    XSD,
    Term,
    Triple,
    iri,
    iri_value,
    is_iri,
    literal,
    literal_value,
)
from kinlint.text import Span
from kinlint.vocabulary import DOCUMENT_BASE, SRC

_SEPARATOR = re.compile("[#/]")
URN_PARTS = 3
"""Colons in a URN whose maker has a namespace of its own: urn:example:arm:tip, not urn:uuid:7."""


@lru_cache(maxsize=1024)
def src(name: str) -> Term:
    """Return the token of a name in the source vocabulary."""
    return iri(SRC + name)


DESCRIBED = src("describedIn")
"""Property from a node to the document that describes it."""


@dataclass
class SourceLayer:
    """The statements about one document, with the places of the nodes they speak of."""

    document: Term
    """Document that the statements are about."""
    blanks: BlankNodes
    """Source of names for blank nodes."""
    triples: dict[Triple, Span] = field(default_factory=dict)
    """Statements with their places."""
    nodes: dict[Term, NodeSpans] = field(default_factory=dict)
    """Places of the nodes."""
    _graphs: set[Term] = field(default_factory=set)

    def state_file(self, form: str, name: str, whole: Span) -> None:
        """State the document itself."""
        self.nodes[self.document] = NodeSpans(whole)
        place = Span(whole.start, min(whole.start + 1, whole.end))
        for prop, value in (
            (RDF_TYPE, src("Document")),
            (src("format"), literal(form)),
            (src("name"), literal(name)),
        ):
            self.triples[self.document, prop, value] = place

    def state_described(self, nodes: Mapping[Term, NodeSpans]) -> None:
        """State the nodes that the document describes, and the namespaces of those with IRIs."""
        for node, spans in nodes.items():
            self.triples[node, DESCRIBED, self.document] = spans.best
        self.state_namespaces(namespaces(nodes))

    def state_namespaces(self, found: Mapping[str, Span]) -> None:
        """State the namespaces in which the document describes nodes."""
        for namespace, span in found.items():
            self.triples[self.document, src("ownNamespace"), literal(namespace)] = span

    def state_terms(self, found: Mapping[Term, Span]) -> None:
        """State the properties and classes that the document uses."""
        used = src("usesTerm")
        for term, span in found.items():
            self.triples[self.document, used, term] = span

    def state_lost_value(self, node: Term, value: Term, span: Span, reason: str) -> None:
        """State that *value* at *span*, a value of *node*, is no literal, for this *reason*."""
        texts = ("written", literal(literal_value(value))), ("reason", literal(reason))
        self.add_node("LostValue", span, ("node", node), *texts)

    def state_graph(self, name: Term, span: Span) -> None:
        """State, once for each, that the document puts statements into the graph *name*."""
        if name not in self._graphs:
            self._graphs.add(name)
            self.add_node("NamedGraph", span, ("name", name))

    def state_context_use(self, use: Term, span: Span) -> None:
        """State that the document names a context."""
        self.triples[self.document, src("usesContext"), use] = span

    def add_node(self, kind: str, span: Span, *details: tuple[str, Term | None]) -> Term:
        """Add a blank node of *kind* at *span*, with those of its *details* that are known."""
        node = self.blanks.fresh()
        self.nodes[node] = NodeSpans(span, span)
        self.triples[node, RDF_TYPE, src(kind)] = span
        self.triples[node, src("document"), self.document] = span
        self.triples[node, src("offset"), literal(str(span.start), f"{XSD}integer")] = span
        for name, value in details:
            if value is not None:
                self.triples[node, src(name), value] = span
        return node


def namespaces(nodes: Mapping[Term, NodeSpans]) -> dict[str, Span]:
    """Return the namespaces of *nodes*, each with the place of the first node in it."""
    return {name: nodes[node].best for name, node in first_nodes(nodes).items()}


def first_nodes(nodes: Iterable[Term]) -> dict[str, Term]:
    """Return the namespaces of those of *nodes* that have IRIs, each with the first node in it.

    The sentinel base is no namespace of anybody.
    """
    found: dict[str, Term] = {}
    last = " "
    for node in nodes:
        if node.startswith(last) and not _SEPARATOR.search(node, len(last)):
            continue
        if is_iri(node):
            name = iri_value(node)
            namespace = name[: _namespace_end(name)]
            last = f"<{namespace}" if namespace[-1:] in ("#", "/") else " "
            if namespace not in found and namespace and not namespace.startswith(DOCUMENT_BASE):
                found[namespace] = node
    return found


def terms(stated: Mapping[Triple, Span]) -> dict[Term, Span]:
    """Return the properties and classes in *stated*, each where it comes first."""
    return {term: stated[triple] for term, triple in first_statements(stated).items()}


def first_statements(stated: Iterable[Triple]) -> dict[Term, Triple]:
    """Return the properties and classes in *stated*, each with the first statement about it."""
    first: dict[Term, Triple] = {}
    for triple in stated:
        term = triple[2] if triple[1] == RDF_TYPE else triple[1]
        if term not in first:
            first[term] = triple
    return {term: triple for term, triple in first.items() if is_iri(term)}


def _namespace_end(name: str) -> int:
    """Return the offset of the last part of *name*; of a URN, if it has more than one."""
    end = max(name.rfind("#"), name.rfind("/")) + 1
    return end if end or name.count(":") < URN_PARTS else name.rfind(":") + 1
