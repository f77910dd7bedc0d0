"""The in-memory Oxigraph store: what is asserted and what is inferred, queried as one graph."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, TypeAlias

import pyoxigraph as ox

from kinlint.engine.literal_spelling import Spellings, component
from kinlint.engine.vocabulary_files import load_turtle
from kinlint.terms import RDF_TYPE, Term, Triple, iri_value, literal
from kinlint.vocabulary import FACTS_GRAPH, INFERRED_GRAPH, KINLINT, LIFTED_GRAPH

if TYPE_CHECKING:
    from kinlint.document import Document

ASSERTED_GRAPH: Term = f"<{KINLINT}asserted>"
"""The named graph that holds what documents and vocabulary say."""

Function: TypeAlias = Callable[..., ox.Literal | None]
"""A function of SPARQL: from terms to a literal, None where it is not defined."""

CHUNK = 20_000
"""Statements per batch: larger ones are no faster and need more memory."""


def token(term: ox.NamedNode | ox.BlankNode | ox.Literal | ox.Triple) -> Term:
    """Return the N-Triples token of a term of the store, spelled as `kinlint.terms` spells it."""
    text = str(term)
    if "\\u" in text and isinstance(term, ox.Literal):
        return literal(term.value, term.datatype.value, term.language or "")
    return text


@lru_cache(maxsize=4096)
def statement(triple: Triple) -> ox.Quad:
    """Return a triple of tokens as terms of the store, in its default graph.

    Raises `ValueError` for tokens that no RDF store accepts, such as a malformed language tag.
    """
    text = "{} {} {} .".format(*triple).encode("utf-8", "surrogatepass")
    try:
        quad: ox.Quad = next(ox.parse(text, ox.RdfFormat.N_TRIPLES, lenient=True))
    except (SyntaxError, StopIteration) as error:
        raise ValueError(str(error)) from error
    return quad


def rank(solution: Mapping[str, Term]) -> tuple[tuple[str, Term], ...]:
    """Return the sort key of solutions of one query: stores have no order that lasts."""
    return tuple(sorted(solution.items()))


def _address(term: Term) -> tuple[str, Term]:
    """Return a sort key by place: an element comes before those within it."""
    return term[:-1], term


class Store:
    """All statements of the documents of a run and the vocabulary, with what follows from both.

    There are four named graphs, asserted, lifted, inferred and computed, which share no triple. One
    for each document would not do: Oxigraph's union of graphs repeats a triple that two of them
    hold, and with it solutions and counts.

    Blank node labels of documents are kept, so documents must not share them. Literals come back in
    Oxigraph's spelling, which for typed ones may differ from the document's: `written` finds the
    way back.
    """

    def __init__(self) -> None:
        self.oxigraph = ox.Store()
        self.documents: dict[Term, Document] = {}
        self.vocabulary: list[Path] = []
        self._spellings = Spellings(self.documents)

    def load(self, documents: Iterable[Document]) -> tuple[Triple, ...]:
        """Add *documents*; one of a graph that is already there replaces what it said.

        Returns the statements that no RDF store accepts; they are left out.
        """
        added: dict[Term, Document] = {}
        for document in documents:
            added.pop(document.graph, None)
            added[document.graph] = document
        for document in added.values():
            if document.graph in self.documents:
                self.clear(document)
        self.documents.update(added)
        self._spellings = Spellings(self.documents)
        refused: list[Triple] = []
        statements = [triple for document in added.values() for triple in document.statements]
        for start in range(0, len(statements), CHUNK):
            refused += self._extend(statements[start : start + CHUNK], ASSERTED_GRAPH)
        return tuple(refused)

    def _extend(self, statements: Sequence[Triple], name: Term) -> Sequence[Triple]:
        """Add *statements* to graph *name*; from text, over twice as fast as from terms."""
        named = [f"{s} {p} {o} .\n" for s, p, o in statements if s[0] != "_" != o[0]]
        graph = ox.NamedNode(iri_value(name))
        try:
            text = "".join(named).encode()
            self.oxigraph.load(text, ox.RdfFormat.N_TRIPLES, to_graph=graph, lenient=True)
            if len(named) < len(statements):
                # `load` is fastest, but renames blank nodes.
                blank = [f"{s} {p} {o} {name} .\n" for s, p, o in statements if "_" in (s[0], o[0])]
                text = "".join(blank).encode()
                self.oxigraph.extend(ox.parse(text, ox.RdfFormat.N_QUADS, lenient=True))
        except (SyntaxError, UnicodeEncodeError, MemoryError):
            if len(statements) == 1:
                return statements
            half = len(statements) // 2
            return [*self._extend(statements[:half], name), *self._extend(statements[half:], name)]
        return ()

    def load_vocabulary(self, files: Iterable[Path]) -> None:
        """Add Turtle *files* that no finding points to, each with blank nodes of its own."""
        graph = ox.NamedNode(iri_value(ASSERTED_GRAPH))
        for file in files:
            load_turtle(self.oxigraph, file, graph)
            self.vocabulary.append(file)

    def clear(self, document: Document) -> None:
        """Remove the statements of *document*, and with them all that was inferred."""
        self.documents.pop(document.graph, None)
        documents, vocabulary = tuple(self.documents.values()), tuple(self.vocabulary)
        self.oxigraph = ox.Store()
        for kept in (self.documents, self.vocabulary):
            kept.clear()
        self.load(documents)
        self.load_vocabulary(vocabulary)

    def restate(self, documents: Iterable[Document]) -> None:
        """Take *documents* for those of the same graphs, of which all that they say is loaded."""
        self.documents.update((document.graph, document) for document in documents)
        self._spellings = Spellings(self.documents)

    def query(
        self,
        text: str,
        substitutions: Mapping[str, Term] | None = None,
        functions: Mapping[ox.NamedNode, Function] | None = None,
    ) -> ox.QuerySolutions | ox.QueryBoolean | ox.QueryTriples:
        """Return the answer of the store to a query over the union of all graphs.

        *substitutions* gives terms to variables (named without `?`), which the query must project,
        before evaluation. This is not SHACL's pre-binding: `BOUND`, sub-selects and aggregates see
        it differently. *functions* are there beside those of SPARQL.
        """
        return self.oxigraph.query(
            text,
            use_default_graph_as_union=True,
            substitutions=_bound(substitutions) if substitutions else None,
            custom_functions=dict(functions) if functions else None,
        )

    def rows(
        self,
        text: str,
        substitutions: Mapping[str, Term] | None = None,
        functions: Mapping[ox.NamedNode, Function] | None = None,
    ) -> Iterator[dict[str, Term]]:
        """Yield the solutions of a SELECT, each with the tokens of its bound variables."""
        solutions = self.query(text, substitutions, functions)
        assert isinstance(solutions, ox.QuerySolutions)
        names = [variable.value for variable in solutions.variables]
        for solution in solutions:
            yield {
                name: token(term)
                for name, term in zip(names, solution, strict=True)
                if term is not None
            }

    def state(self, facts: Iterable[Triple]) -> None:
        """Add what was computed, in place of what was before."""
        self.oxigraph.clear_graph(ox.NamedNode(iri_value(FACTS_GRAPH)))
        self._extend(tuple(facts), FACTS_GRAPH)

    def lifted(self) -> Iterator[Triple]:
        """Yield the triples that lifting queries made."""
        return self._statements(LIFTED_GRAPH)

    def facts(self) -> Iterator[Triple]:
        """Yield the computed triples."""
        return self._statements(FACTS_GRAPH)

    def inferred(self) -> Iterator[Triple]:
        """Yield the inferred triples."""
        return self._statements(INFERRED_GRAPH)

    def infers(self, predicate: Term | None, value: Term | None = None) -> bool:
        """Tell whether something of *predicate* was inferred; None is any.

        Of types, only whether *value* was, if it is given.
        """
        kind = ox.NamedNode(iri_value(value)) if value and predicate == RDF_TYPE else None
        property_ = ox.NamedNode(iri_value(predicate)) if predicate else None
        graph = ox.NamedNode(iri_value(INFERRED_GRAPH))
        return any(True for _ in self.oxigraph.quads_for_pattern(None, property_, kind, graph))

    def _statements(self, name: Term) -> Iterator[Triple]:
        graph = ox.NamedNode(iri_value(name))
        for quad in self.oxigraph.quads_for_pattern(None, None, None, graph):
            yield token(quad.subject), token(quad.predicate), token(quad.object)

    def subjects(self, predicate: Term, value: Term | None = None) -> Iterator[Term]:
        """Yield the subjects of *predicate*, with *value* if one is given, in any graph."""
        quad = statement(("<any:>", predicate, value or "<any:>"))
        given = quad.object if value else None
        for found in self.oxigraph.quads_for_pattern(None, quad.predicate, given, None):
            yield token(found.subject)

    def values(self, subject: Term, predicate: Term) -> Iterator[Term]:
        """Yield the values of *predicate* in all graphs, sorted."""
        given = statement((subject, predicate, "<any:>"))
        quads = self.oxigraph.quads_for_pattern(given.subject, given.predicate, None, None)
        yield from sorted((token(quad.object) for quad in quads), key=_address)

    def leading_to(
        self, node: Term, graph: ox.NamedNode | None = None
    ) -> Iterator[tuple[Term, Term]]:
        """Yield the subjects and the properties of which *node* is a value, in *graph* or any."""
        given = statement(("<any:>", RDF_TYPE, node)).object
        for quad in self.oxigraph.quads_for_pattern(None, None, given, graph):
            yield token(quad.subject), token(quad.predicate)

    def predicate_objects(self, subject: Term) -> Iterator[tuple[Term, Term]]:
        """Yield the asserted properties and values of *subject*, sorted by property."""
        yield from self._said(subject, ASSERTED_GRAPH)

    def described(self, subject: Term) -> Iterator[tuple[Term, Term]]:
        """Yield the asserted and lifted properties and values of *subject*, by property."""
        for name in (ASSERTED_GRAPH, LIFTED_GRAPH):
            yield from self._said(subject, name)

    def _said(self, subject: Term, name: Term) -> list[tuple[Term, Term]]:
        node = statement((subject, RDF_TYPE, "<any:>")).subject
        quads = self.oxigraph.quads_for_pattern(node, None, None, ox.NamedNode(iri_value(name)))
        said = ((token(quad.predicate), token(quad.object)) for quad in quads)
        return sorted(said, key=lambda pair: (pair[0], *_address(pair[1])))

    def holds(self, triple: Triple) -> bool:
        """Tell whether *triple* is asserted or inferred."""
        return self._graph(triple) is not None

    def says(self, triple: Triple) -> bool:
        """Tell whether *triple* is asserted, or was made of what is."""
        return self._graph(triple) in (ASSERTED_GRAPH, LIFTED_GRAPH)

    def is_lifted(self, triple: Triple) -> bool:
        """Tell whether *triple* was lifted from an XML format."""
        return self._graph(triple) == LIFTED_GRAPH

    def is_inferred(self, triple: Triple) -> bool:
        """Tell whether *triple* was inferred, which what is asserted never is."""
        return self._graph(triple) == INFERRED_GRAPH

    def _graph(self, triple: Triple) -> Term | None:
        try:
            quad = statement(triple)
        except ValueError:
            return None
        found = self.oxigraph.quads_for_pattern(quad.subject, quad.predicate, quad.object, None)
        return next((str(each.graph_name) for each in found), None)

    def written(
        self, subject: Term, predicate: Term | None, value: Term
    ) -> Iterator[tuple[Document, Triple]]:
        """Yield the documents that say *subject* *predicate* *value*, each with its own spelling.

        The triples are keys of `document.map.triples`. No *predicate* means any. Triples that were
        inferred or stand in the vocabulary are written nowhere.
        """
        for each in (predicate,) if predicate else self._between(subject, value):
            yield from self._spellings.written((subject, each, value))

    def _between(self, subject: Term, value: Term) -> list[Term]:
        """Return the properties that *subject* has *value* for."""
        try:
            quad = statement((subject, "<any:>", value))
        except ValueError:
            return []
        found = self.oxigraph.quads_for_pattern(quad.subject, None, quad.object, None)
        return sorted((str(each.predicate) for each in found), key=component)


def _bound(
    substitutions: Mapping[str, Term],
) -> dict[ox.Variable, ox.NamedNode | ox.BlankNode | ox.Literal | ox.Triple]:
    return {
        ox.Variable(name): statement(("<any:>", "<any:>", term)).object
        for name, term in substitutions.items()
    }
