"""A constraint starts from the nodes that can violate it, and finds the same."""

from __future__ import annotations

import pytest
from test_required_terms import compiled
from turtle_document import document, ex

from kinlint.engine.evaluate import check
from kinlint.engine.store import Store

TARGETS = "sh:targetSubjectsOf :p , :q ; sh:targetObjectsOf :r ; sh:targetClass :C"
MODEL = """
    :a :p 1 ; :q 2 ; :s 3 . :b :q 1 . :c :r :d . :d :p 5 ; :s 5 . :e a :C ; :s 1 . :f :s 9 .
    :g a :D ; :p 1 , 2 , 3 . :D rdfs:subClassOf :C . :h a :D .
"""


def found(where: str, head: str = "$this", tail: str = "") -> tuple[str, set[str]]:
    """The query that is made of *where*, and what it finds."""
    (constraint,) = compiled(f"SELECT {head} WHERE {{ {where} }} {tail}", TARGETS)
    store = Store()
    store.load([document(MODEL)])
    return constraint.select, {each.focus for each in check(store, [constraint])}


@pytest.mark.parametrize(
    ("where", "foci"),
    [
        ("$this :p ?x", "adg"),
        ("$this :p|:q ?x . FILTER (?x < 2)", "abg"),
        ("?any :r $this . OPTIONAL { $this :s ?x } FILTER (BOUND(?x))", "d"),
        ("$this a :C", "e"),
        ("$this :q ?x . ?x ^:p ?y", "ab"),
    ],
)
def test_no_target_is_looked_for_where_the_query_finds_it(where, foci):
    """Its own patterns bind the focus node, and make it one."""
    select, known = found(where)

    assert select.count("SELECT DISTINCT ?this") == 1
    assert known == set(map(ex, foci))


@pytest.mark.parametrize(
    ("where", "foci"),
    [
        ("$this :p ?x . { $this :q ?y } UNION { $this :s ?y }", "ad"),
        (
            "$this :p ?x . { SELECT $this (COUNT(*) AS ?n) { $this :p ?z } GROUP BY $this }",
            "adg",
        ),
        ("FILTER NOT EXISTS { $this :s ?x } $this :q ?y .", "b"),
    ],
)
def test_other_queries_are_asked_of_each_node_that_can_violate_them(where, foci):
    """One way to be a target is looked for, not all."""
    select, known = found(where)

    assert "UNION" not in select.partition("LATERAL")[0]
    assert known == set(map(ex, foci))


@pytest.mark.parametrize(
    ("where", "foci"), [("$this :s ?x", "ade"), ("?x :p $this", ""), ("$this ?any ?x", "abdegh")]
)
def test_all_targets_are_looked_for_where_it_takes_more_to_be_one(where, foci):
    """A node with a property need not be a target."""
    select, known = found(where)

    assert "UNION" in select.partition("LATERAL")[0]
    assert known == set(map(ex, foci))


def test_what_is_counted_is_counted_of_each():
    """A group of its own for every focus node."""
    counted = "HAVING (COUNT(?x) > 2)"

    assert found("$this :p ?x", tail=f"GROUP BY $this {counted}")[1] == {ex("g")}
    assert found("$this :p ?x", "$this (COUNT(?x) AS ?n)", f"GROUP BY $this {counted}")[1] == {
        ex("g")
    }
