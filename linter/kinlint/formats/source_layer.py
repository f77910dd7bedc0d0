"""States what a file is, which nodes it describes, and what of it the graph does not say."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from kinlint.document import NodeSpans
from kinlint.formats.naming import BlankNodes
from kinlint.terms import RDF_TYPE, XSD, Term, Triple, iri, iri_value, is_iri, literal
from kinlint.text import Span
from kinlint.vocabulary import DOCUMENT_BASE, SRC

URN_PARTS = 3
"""Colons in a URN whose maker has a namespace of its own: urn:example:arm:tip, not urn:uuid:7."""


def src(name: str) -> Term:
    """The token of a name in the source vocabulary."""
    return iri(SRC + name)


@dataclass
class SourceLayer:
    """The statements about one document, with the places of the nodes they speak of."""

    document: Term
    blanks: BlankNodes
    triples: dict[Triple, Span] = field(default_factory=dict)
    nodes: dict[Term, NodeSpans] = field(default_factory=dict)
    _graphs: set[Term] = field(default_factory=set)

    def file(self, form: str, name: str, whole: Span) -> None:
        """The document itself."""
        self.nodes[self.document] = NodeSpans(whole)
        place = Span(whole.start, min(whole.start + 1, whole.end))
        for prop, value in (
            (RDF_TYPE, src("Document")),
            (src("format"), literal(form)),
            (src("name"), literal(name)),
        ):
            self.triples[self.document, prop, value] = place

    def described(self, nodes: Mapping[Term, NodeSpans]) -> None:
        """The nodes that the document describes, and the namespaces of those with IRIs.

        The sentinel base is no namespace of anybody.
        """
        own: dict[str, Span] = {}
        described = src("describedIn")
        for node, spans in nodes.items():
            self.triples[node, described, self.document] = spans.best
            if is_iri(node):
                name = iri_value(node)
                own.setdefault(name[: _namespace_end(name)], spans.best)
        for namespace, span in own.items():
            if namespace and not namespace.startswith(DOCUMENT_BASE):
                self.triples[self.document, src("ownNamespace"), literal(namespace)] = span

    def uses_terms(self, stated: Mapping[Triple, Span]) -> None:
        """The properties and classes in *stated*, each where it comes first."""
        terms: dict[Term, Span] = {}
        for (_, prop, value), span in stated.items():
            terms.setdefault(value if prop == RDF_TYPE else prop, span)
        used = src("usesTerm")
        for term, span in terms.items():
            if is_iri(term):
                self.triples[self.document, used, term] = span

    def graph(self, name: Term, span: Span) -> None:
        """The document puts statements into the graph *name*; said once for each."""
        if name not in self._graphs:
            self._graphs.add(name)
            self.about("NamedGraph", span, ("name", name))

    def uses(self, use: Term, span: Span) -> None:
        """The document names a context."""
        self.triples[self.document, src("usesContext"), use] = span

    def about(self, kind: str, span: Span, *details: tuple[str, Term | None]) -> Term:
        """A new blank node of *kind* at *span*, with those of its *details* that are known."""
        node = self.blanks.fresh()
        self.nodes[node] = NodeSpans(span, span)
        self.triples[node, RDF_TYPE, src(kind)] = span
        self.triples[node, src("document"), self.document] = span
        self.triples[node, src("offset"), literal(str(span.start), f"{XSD}integer")] = span
        for name, value in details:
            if value is not None:
                self.triples[node, src(name), value] = span
        return node


def _namespace_end(name: str) -> int:
    """Where the last part of *name* begins; of a URN, if it has more than one."""
    end = max(name.rfind("#"), name.rfind("/")) + 1
    return end if end or name.count(":") < URN_PARTS else name.rfind(":") + 1
