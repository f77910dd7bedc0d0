"""The default engine and pySHACL agree on random graphs."""

from __future__ import annotations

from collections import Counter

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from small_graphs import shapes, simple_groups, triples
from w3c import normal

from kinlint.document import Document, SourceMap
from kinlint.engine.compiler.shapes_compiler import compile_shapes
from kinlint.engine.evaluate import check
from kinlint.engine.reference.shacl import check_store
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.formats.turtle.format import TURTLE
from kinlint.terms import Triple
from kinlint.text import SourceText

PREFIXES = """
    @prefix sh: <http://www.w3.org/ns/shacl#> .
    @prefix xsd: <http://www.w3.org/2001/XMLSchema#> .
"""


def loaded(graph: tuple[Triple, ...]) -> Store:
    store = Store()
    store.load(
        [Document(SourceText("random", ""), "<urn:data>", graph, SourceMap(), format=TURTLE)]
    )
    return store


def told(results: list[Result]) -> Counter[tuple[str | None, ...]]:
    return Counter(
        (
            each.constraint.shape,
            each.constraint.component.rpartition("#")[2],
            normal(each.focus),
            each.path,
            each.value and normal(each.value),
        )
        for each in results
    )


@pytest.mark.slow
@settings(max_examples=120)
@given(triples, shapes)
def test_core_shapes_have_the_same_results(graph: tuple[Triple, ...], shape: str) -> None:
    """Every component, nested in each other, over every kind of path.

    But for sh:lessThan: pySHACL orders IRIs and gives up on blank nodes.
    """
    files = [("shapes.ttl", PREFIXES + shape)]
    store, constraints = loaded(graph), compile_shapes(files)
    assert all(each.deferred is None for each in constraints)
    assert told([*check(store, constraints)]) == told(check_store(store, files))


@pytest.mark.slow
@settings(max_examples=80)
@given(triples, simple_groups, simple_groups)
def test_sparql_constraints_have_the_same_results(
    graph: tuple[Triple, ...], outer: str, body: str
) -> None:
    """Each once, as pySHACL gives them.

    Sub-selects and UNION are left out: rdflib lets variables into the one that are not
    projected, and keeps from the other those that EXISTS substitutes.
    """
    query = f"SELECT ?this (?x AS ?value) WHERE {{ {outer} FILTER NOT EXISTS {body} }}"
    constraint = f'sh:sparql [ sh:select """{query}""" ]'
    files = [
        (
            "s.ttl",
            f"{PREFIXES} <urn:s> a sh:NodeShape ; sh:targetSubjectsOf <urn:p> ; {constraint} .",
        )
    ]
    store, constraints = loaded(graph), compile_shapes(files)
    assume(not constraints[0].deferred)
    assert {*told([*check(store, constraints)])} == {*told(check_store(store, files))}


@pytest.mark.slow
@settings(max_examples=100)
@given(triples, shapes, st.sampled_from(["<urn:a>", "<urn:b>", "_:d"]))
def test_one_focus_node_has_its_share_of_all_results(
    graph: tuple[Triple, ...], shape: str, focus: str
) -> None:
    """Whether a query can name the node or not."""
    store = loaded(graph)
    constraints = compile_shapes([("shapes.ttl", PREFIXES + shape)])
    found = []
    for each in constraints:
        rows = store.rows(each.select)
        found += [row for row in rows if row["root"] == focus]
    single = [result.bindings for result in check(store, constraints, focus)]
    assert Counter(map(str, single)) == Counter(
        str({name: term for name, term in row.items() if name != "root"}) for row in found
    )
