"""What the dialect rewrites means what the author wrote."""

from __future__ import annotations

import pyoxigraph as ox
import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from small_graphs import groups, triples

from kinlint.engine.compiler.query_rewrite import rewritten_for_oxigraph
from kinlint.sparql.ast import render
from kinlint.sparql.parser import parse
from kinlint.sparql.tokens import tokens
from kinlint.terms import Triple

THIS = frozenset({"?this"})
JOINTS = "{ SELECT ?this (MIN(STR(?j)) AS ?s) WHERE { ?this <urn:p> ?j } GROUP BY ?this }"
PATHS = ["(<urn:q>/^<urn:q>)*", "<urn:q>*", "(<urn:q>|<urn:r>)+", "^<urn:r>*", "<urn:p>/<urn:q>*"]


def rewritten(query: str) -> str:
    return render(rewritten_for_oxigraph(parse(tokens(query, {"": "urn:"})), THIS))


def solutions(graph: tuple[Triple, ...], query: str) -> list[str]:
    store = ox.Store()
    text = "".join(" ".join(triple) + " .\n" for triple in graph)
    store.extend(ox.parse(text.encode(), ox.RdfFormat.N_TRIPLES))
    targets = "{ SELECT DISTINCT ?this WHERE { ?this ?k_p ?k_o } }"
    try:
        found = store.query(f"SELECT * WHERE {{ {targets} LATERAL {{ {query} }} }}")
    except SyntaxError:
        assume(False)  # noqa: FBT003
        raise
    return sorted(str([str(term) for term in row]) for row in found)


@pytest.mark.slow
@settings(
    max_examples=300,
    suppress_health_check=[HealthCheck.filter_too_much],
)
@given(triples, groups, groups)
def test_rewritten_exists_has_the_same_solutions(
    graph: tuple[Triple, ...], outer: str, body: str
) -> None:
    """Nested EXISTS, OPTIONAL, UNION, sub-selects, aggregates, BIND and blank nodes included."""
    query = f"SELECT ?this ?x WHERE {{ {outer} FILTER NOT EXISTS {body} }}"
    expected = solutions(graph, query)
    assert solutions(graph, rewritten(query)) == expected


@pytest.mark.slow
@settings(max_examples=200)
@given(triples, st.sampled_from(PATHS), st.booleans())
def test_reach_from_a_computed_anchor_has_the_same_solutions(
    graph: tuple[Triple, ...],
    path: str,
    forward: bool,  # noqa: FBT001
) -> None:
    """Also where the anchor is a blank node, for which IRI(STR(…)) has no value."""
    ends = f"?first {path} ?value" if forward else f"?value {path} ?first"
    query = (
        f"SELECT ?this ?value WHERE {{ ?this <urn:p> ?value . {JOINTS} "
        f"BIND(IRI(?s) AS ?first) FILTER NOT EXISTS {{ {ends} }} FILTER(isIRI(?this)) }}"
    )
    assert solutions(graph, rewritten(query)) == solutions(graph, query)


@pytest.mark.slow
@settings(max_examples=200)
@given(triples, st.sampled_from(PATHS), groups)
def test_reach_from_the_focus_node_has_the_same_solutions(
    graph: tuple[Triple, ...], path: str, other: str
) -> None:
    """With a second filter that only depends on the focus node, and so is judged first."""
    query = (
        f"SELECT ?this ?value WHERE {{ ?this <urn:p> ?value . "
        f"FILTER NOT EXISTS {{ ?this {path} ?value }} FILTER NOT EXISTS {other} }}"
    )
    assert solutions(graph, rewritten(query)) == solutions(graph, query)


@pytest.mark.parametrize(
    ("query", "parts"),
    [
        (
            "SELECT ?this { FILTER NOT EXISTS { ?f :o ?x . ?p :w ?f . ?this :of ?p } }",
            "{ { ?this <urn:of> ?p } LATERAL { ?p <urn:w> ?f } LATERAL { ?f <urn:o> ?x } }",
        ),
        (
            "SELECT ?this { FILTER EXISTS { ?this :p/^:q/(:r|:s) ?x } }",
            "LATERAL { ?k_1001 <urn:q> ?k_1000 } LATERAL { ?k_1001 <urn:r> | <urn:s> ?x } }",
        ),
        (
            "SELECT ?this { FILTER EXISTS { ?x :q ?y . FILTER (?x > 1) ?this :p ?x } }",
            "{ { ?this <urn:p> ?x } LATERAL { FILTER ( ?x > 1 ) } LATERAL { ?x <urn:q> ?y } }",
        ),
        (
            "SELECT ?this { FILTER EXISTS { ?this :p [ :q 'a'@en, 1.5 ] . } }",
            "LATERAL { ?k_1000 <urn:q> 'a'@en } LATERAL { ?k_1000 <urn:q> 1.5 } }",
        ),
        (
            "SELECT ?this { ?this :p ?v FILTER NOT EXISTS { ?this :q* ?v } }",
            "{ ?this <urn:p> ?v MINUS { ?this <urn:q> * ?v } }",
        ),
        (
            "SELECT ?this { ?this :p ?v FILTER NOT EXISTS { ?this :q ?o } }",
            "LIMIT 1 } LATERAL { FILTER NOT EXISTS { ?this <urn:q> ?o } } LATERAL { ?this",
        ),
    ],
)
def test_every_pattern_starts_from_what_is_bound(query: str, parts: str) -> None:
    """Sequence paths are taken apart, filters come as soon as they can."""
    assert parts in rewritten(query)


@pytest.mark.parametrize(
    "query",
    [
        "SELECT ?this WHERE { FILTER NOT EXISTS { ?x <urn:p> ?y . ?y <urn:q> ?z } }",
        "SELECT ?this WHERE { FILTER NOT EXISTS { ?this <urn:p> ?y OPTIONAL { ?y <urn:q> ?z } } }",
        "SELECT ?this WHERE { FILTER NOT EXISTS { ?this <urn:p> ?y } }",
        "SELECT ?this WHERE { ?this <urn:p> ?a , ?b FILTER NOT EXISTS { ?a <urn:r> * ?b } }",
    ],
)
def test_what_gains_nothing_stays_as_it_is(query: str) -> None:
    """Bodies that share nothing with what is outside, or hold more than patterns and filters."""
    assert " ".join(rewritten(query).split()) == query
