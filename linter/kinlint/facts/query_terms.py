"""The terms that SPARQL queries of shapes use, by the prefixes that they declare."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.facts.fact_statements import fact
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.sparql.tokens import NotSparql, prefixed, prologue
from kinlint.terms import Term, Triple, iri, literal_value
from kinlint.vocabulary import SH

SELECT = iri(f"{SH}select")


def query_terms(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield for each node with a query the terms in it, in alphabetical order."""
    for node, queries in scan.table(SELECT).items():
        for query in queries:
            yield from ((node, fact("query-term"), term) for term in _terms(literal_value(query)))


def _terms(query: str) -> list[Term]:
    """Return the terms in *query*; none if it is not SPARQL."""
    try:
        return sorted(prefixed(query, prologue(query)))
    except NotSparql:
        return []
