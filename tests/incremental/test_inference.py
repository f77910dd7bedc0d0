"""What is inferred step by step is what follows from all that is stated then."""

from __future__ import annotations

import random

import pytest

from kinlint.document import Document, SourceMap
from kinlint.engine.axioms import Axiom, names_its_terms
from kinlint.engine.closure import close
from kinlint.engine.store import ASSERTED_GRAPH, Store
from kinlint.engine.strata import stratified
from kinlint.formats.turtle.format import TURTLE
from kinlint.incremental.change import Changes, to_quads
from kinlint.incremental.inference import Inference
from kinlint.terms import RDF_TYPE, Triple
from kinlint.text import SourceText


def axiom(head: Triple, *body: Triple) -> Axiom:
    return Axiom("because", body, head)


AXIOMS = stratified(
    [
        axiom(("?y", "<p:inverse>", "?x"), ("?x", "<p:part>", "?y")),
        axiom(("?x", "<p:within>", "?y"), ("?x", "<p:inverse>", "?y")),
        axiom(("?x", "<p:within>", "?z"), ("?x", "<p:within>", "?y"), ("?y", "<p:within>", "?z")),
        axiom(("?x", RDF_TYPE, "<c:Whole>"), ("?x", "<p:part>", "?y")),
        axiom(("?x", RDF_TYPE, "<c:Thing>"), ("?x", RDF_TYPE, "<c:Whole>")),
        axiom(("?x", "<p:peer>", "?y"), ("?y", "<p:peer>", "?x")),
    ]
)
POSSIBLE = [
    *((f"<n:{a}>", "<p:part>", f"<n:{b}>") for a in range(5) for b in range(5)),
    *((f"<n:{a}>", "<p:peer>", f"<n:{b}>") for a in range(3) for b in range(3)),
    *((f"<n:{a}>", RDF_TYPE, "<c:Thing>") for a in range(4)),
    *((f"<n:{a}>", "<p:within>", f"<n:{b}>") for a in range(3) for b in range(3)),
    ("<n:1>", "<p:part>", '"text"'),
]


def closed(statements: set[Triple]) -> set[Triple]:
    store = Store()
    source = SourceText("x", "")
    store.load([Document(source, "<g:>", tuple(sorted(statements)), SourceMap(), format=TURTLE)])
    close(store, AXIOMS)
    return set(store.inferred())


@pytest.mark.parametrize("seed", range(12))
def test_statements_come_and_go(seed):
    """Also where things follow in circles, and where what was inferred comes to be stated."""
    dice = random.Random(seed)  # noqa: S311  no secret
    store, said = Store(), set[Triple]()
    inference = Inference(store, AXIOMS)
    for _ in range(40):
        picked = set(dice.sample(POSSIBLE, dice.choice([1, 1, 2, 6])))
        changes = Changes(store)
        changes.apply(
            to_quads(picked & said, ASSERTED_GRAPH), to_quads(picked - said, ASSERTED_GRAPH)
        )
        said ^= picked

        inference.follow(changes)

        assert set(store.inferred()) == closed(said)
        before = set(store.inferred())
        inference.follow(changes)
        assert set(store.inferred()) == before


def test_axioms_of_any_property_are_not_followed():
    """What says nothing of which property it is about has to be closed anew."""
    assert names_its_terms(AXIOMS)
    assert not names_its_terms([axiom(("?x", "?p", "?y"), ("?y", "?p", "?x"))])
    assert not names_its_terms([axiom(("?x", RDF_TYPE, "?c"), ("?x", "<p:of>", "?c"))])
