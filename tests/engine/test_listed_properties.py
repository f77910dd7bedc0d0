"""Properties that a condition lists are looked up one by one; nothing else changes."""

from __future__ import annotations

import pyoxigraph as ox
import pytest

from kinlint.engine.compiler.listed_properties import with_listed_properties
from kinlint.sparql.ast import render
from kinlint.sparql.parser import parse
from kinlint.sparql.tokens import tokens

STORE = ox.Store()
STORE.update(
    """PREFIX : <urn:x:> INSERT DATA {
        :a :p 1, 2 ; :q 1 ; :r :b . :b :p 2 ; :q 3 ; :r :c . :c :q 2 ; :s 1 }"""
)


def solutions(query: str) -> list[str]:
    found = STORE.query(query)
    assert isinstance(found, ox.QuerySolutions)
    return sorted(map(str, found))


def rewritten(group: str) -> str:
    select = parse(tokens(f"SELECT * WHERE {{ {group} }}", {"": "urn:x:"}))
    text = render(with_listed_properties(select))
    assert solutions(text) == solutions(render(select))
    return text


@pytest.mark.parametrize(
    "group",
    [
        "?s ?p ?o . FILTER (?p IN (:p, :q))",
        "?s ?p ?o . FILTER (?p in (:p, :q, :p))",
        "?s ?p ?o ; :q ?n . FILTER (?p IN (:p) && (?n = 1 || ?n = 3))",
        "{ ?s ?p ?o . FILTER (?p IN (:p, :q)) } UNION { ?s :s ?o }",
        "?s :q ?n . OPTIONAL { ?s ?p ?o . FILTER (?p IN (:p, :s)) }",
        "{ SELECT ?s (COUNT(*) AS ?n) WHERE { ?s ?p ?o . FILTER (?p IN (:p, :q)) } GROUP BY ?s }",
    ],
)
def test_listed(group: str) -> None:
    assert "VALUES ?p {" in rewritten(group)


@pytest.mark.parametrize(
    "group",
    [
        "?s ?p ?o . FILTER (?p NOT IN (:p, :q))",
        "?s ?p ?o . FILTER (!(?p IN (:p, :q)))",
        "?s ?p ?o . FILTER (?p IN (:p) || ?o = 3)",
        "?s ?p ?o . FILTER (?p IN (:p) && ?o = 1 || ?o = 3)",
        "?s ?p ?o . FILTER (?o IN (:b, :c))",
        "?s ?p ?o ; :q ?n . FILTER (?p IN (?o, :p))",
        "?s :p ?o . BIND (:q AS ?p) FILTER (?p IN (:p, :q))",
        "?s ?q ?p . FILTER (?p IN (:b, :c))",
        "?s :q ?n . FILTER EXISTS { ?s ?p ?o . FILTER (?p IN (:p, :s)) }",
    ],
)
def test_not_listed(group: str) -> None:
    assert "VALUES" not in rewritten(group)
