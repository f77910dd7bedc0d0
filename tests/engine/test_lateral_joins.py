"""LATERAL where it means what the query says, and nowhere else."""

from __future__ import annotations

import pyoxigraph as ox
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from kinlint.engine.compiler.query_rewrite import rewritten_for_oxigraph
from kinlint.sparql.ast import render
from kinlint.sparql.parser import parse
from kinlint.sparql.tokens import tokens

STORE = ox.Store()
STORE.update(
    """PREFIX : <urn:x:> INSERT DATA {
        :a :p 1, 2 ; :q 1 ; :r :b ; :s 2 . :b :p 2 ; :q 3 ; :r :c . :c :q 2 ; :s 1 }"""
)


def solutions(query: str) -> list[str]:
    found = STORE.query(query)
    assert isinstance(found, ox.QuerySolutions)
    return sorted(map(str, found))


def check(text: str) -> str:
    select = parse(tokens(text, {"": "urn:x:"}))
    rewritten = render(rewritten_for_oxigraph(select, frozenset({"?this"})))
    assert solutions(rewritten) == solutions(render(select))
    return rewritten


@pytest.mark.parametrize(
    "text",
    [
        "?a :p ?y OPTIONAL { ?a :s ?x } ?b :q ?x",
        "?a :p ?y OPTIONAL { ?a :s ?x } { ?b :q ?x } UNION { ?b :p ?x }",
        "?a :p ?y BIND (?y AS ?v) ?b :q ?v",
        "?a :r ?v OPTIONAL { ?v :s ?w } ?v :r* ?u",
        "{ ?a :p ?y } UNION { ?a :q ?z } ?b :q ?y",
        "{ SELECT ?a (COUNT (*) AS ?n) { ?a :p ?y } GROUP BY ?a } ?b :q ?n",
        "?a :p ?x . { ?b :q ?y BIND (?y + 1 AS ?z) FILTER (?z > 2) } UNION { ?b :s ?x }",
        "?a :p ?x . { ?a :q ?y FILTER NOT EXISTS { ?y :p ?a } } UNION { ?a :s ?x }",
        "?a :p ?x . { ?b :q ?y { ?b :r ?x } } UNION { ?b :s ?x }",
        "VALUES ?x { 1 UNDEF } ?a :p ?x",
    ],
)
def test_what_waits_for_what_is_bound_finds_the_same(text: str) -> None:
    """Patterns after anything, and branches that look at nothing but what they match."""
    assert "LATERAL" in check(f"SELECT * {{ {text} }}")


@pytest.mark.parametrize(
    "text",
    [
        "?a :p ?x . { ?a :q ?y FILTER (BOUND (?x)) } UNION { ?a :s ?x }",
        "?a :p ?x . { ?a :q ?y FILTER NOT EXISTS { ?a :p ?x } } UNION { ?a :s ?x }",
        "?a :p ?x . { ?a :q ?y BIND (?y AS ?x) } UNION { ?a :s ?x }",
        "?a :p ?y . { BIND (?y AS ?z) ?a :q ?y } UNION { ?a :s ?w }",
        "?a :p ?x . { ?b :q ?y BIND (?y + ?x AS ?z) } UNION { ?b :s ?x }",
        "?a :p ?x . { ?b :q ?x OPTIONAL { ?b :s ?y } } UNION { ?b :s ?x }",
        "?a :p ?x OPTIONAL { { ?b :q ?x } UNION { ?b :s ?x } FILTER (?a = ?b) }",
        "?a :p ?x MINUS { { ?b :q ?x } UNION { ?b :s ?x } ?c :q ?x }",
        "?a :p ?x . { SELECT ?x (COUNT (*) AS ?n) { ?b :q ?x } GROUP BY ?x }",
        "?a :p ?x . { ?a :q ?y MINUS { ?a :s ?x } } UNION { ?a :s ?y }",
    ],
)
def test_what_would_see_what_is_bound_outside_does_not(text: str) -> None:
    """Groups are evaluated from nothing: their filters and BIND know only what is inside."""
    assert "LATERAL { { ?" not in check(f"SELECT * {{ {text} }}")


def test_blocks_that_share_a_blank_node_stay_together() -> None:
    """A blank node of a query cannot stand in two groups."""
    text = check("SELECT * { ?a :p ?y BIND (1 AS ?k) ?a :r _:b FILTER (?y > 0) _:b :q ?x }")
    assert "{" not in text.partition("{")[2]


VARIABLES = st.sampled_from(["?a", "?b", "?x", "?y"])
PATTERNS = st.builds(
    lambda s, p, o: f"{s} {p} {o} .",
    VARIABLES,
    st.sampled_from([":p", ":q", ":r", ":s", "(:p|:q)", ":r*"]),
    VARIABLES,
)
FILTERS = st.builds(
    lambda form, a, b: form.format(a, b),
    st.sampled_from(
        [
            *("FILTER (BOUND ({0}))", "FILTER (!BOUND ({0}) || {0} = {1})", "FILTER ({0} > 1)"),
            *("FILTER NOT EXISTS {{ {0} :q {1} }}", "FILTER EXISTS {{ {0} :r {1} }}"),
        ]
    ),
    VARIABLES,
    VARIABLES,
)
FLAT = st.lists(st.one_of(PATTERNS, FILTERS), min_size=1, max_size=3).map(" ".join)


@st.composite
def groups(draw: st.DrawFn) -> str:
    """A group of SPARQL; each BIND names a variable of its own or one of another group."""
    parts: list[str] = [draw(PATTERNS)]
    for _ in range(draw(st.integers(1, 3))):
        one, other = draw(FLAT), draw(FLAT)
        value, name = draw(VARIABLES), draw(st.sampled_from(["?v", "?w"]))
        bind = f"BIND ({value} AS {name})"
        parts.append(
            draw(
                st.sampled_from(
                    [
                        *(one, f"OPTIONAL {{ {one} }}", f"{{ {one} }} UNION {{ {other} }}"),
                        *(f"MINUS {{ {one} }}", f"{{ SELECT DISTINCT {value} {{ {one} }} }}"),
                        *(f"{{ {one} {bind} }} UNION {{ {bind} {other} }}", f"{{ {one} {bind} }}"),
                        f"OPTIONAL {{ {{ {one} }} UNION {{ {other} }} {draw(FILTERS)} }}",
                        f"VALUES {value} {{ 1 2 UNDEF }}",
                    ]
                )
            )
        )
    return " ".join(parts)


@pytest.mark.slow
@settings(max_examples=300)
@given(groups())
def test_no_rewriting_changes_a_solution(text: str) -> None:
    """Whatever stands in the group, as often as it stands there."""
    select = parse(tokens(f"SELECT DISTINCT * {{ {text} }}", {"": "urn:x:"}))
    rewritten = render(rewritten_for_oxigraph(select, frozenset({"?this"})))

    assert solutions(rewritten) == solutions(render(select))
