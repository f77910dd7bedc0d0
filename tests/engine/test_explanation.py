from __future__ import annotations

from pathlib import Path

import pytest
from turtle_document import PREFIXES, document, ex

from kinlint.engine.axioms import Axiom
from kinlint.engine.closure import close
from kinlint.engine.constraint import Constraint
from kinlint.engine.explanation import Step, because, explain, premises_of
from kinlint.engine.ontology import compile_axioms
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.terms import RDF_TYPE, XSD, Term, Triple, literal

ONTOLOGY = """
    :on owl:inverseOf :simplices .
    :joins owl:propertyChainAxiom ( :attachment :on ) .
    :Revolute rdfs:subClassOf :Joint .
    :near a owl:SymmetricProperty, owl:TransitiveProperty .
    :Single owl:equivalentClass [ owl:onProperty :freedom ; owl:hasValue 1.0e0 ] .
"""
MODEL = """
    :arm :simplices :tip . :elbow a :Revolute ; :attachment :tip, [] ; :freedom 1.00e0 .
    :a :near :b . :b :near :c . :c :near :d .
"""
JOINS: Triple = (ex("elbow"), ex("joins"), ex("arm"))


@pytest.fixture
def axioms(tmp_path: Path) -> tuple[Axiom, ...]:
    file = tmp_path / "ontology.ttl"
    file.write_text(PREFIXES + ONTOLOGY, "utf-8")
    return compile_axioms([file])


@pytest.fixture
def store(axioms: tuple[Axiom, ...]) -> Store:
    store = Store()
    store.load([document(MODEL)])
    close(store, axioms)
    return store


def test_a_proof_leads_down_to_what_is_asserted(store, axioms):
    """Each inferred step is followed by its premises, one level deeper."""
    proof = explain(store, axioms, JOINS)

    assert proof == (
        Step(JOINS, "attachment, then on makes joins", 0),
        Step((ex("elbow"), ex("attachment"), ex("tip")), "", 1),
        Step((ex("tip"), ex("on"), ex("arm")), "on is the inverse of simplices", 1),
        Step((ex("arm"), ex("simplices"), ex("tip")), "", 2),
    )


def test_every_inferred_triple_has_a_proof_from_asserted_ones(store, axioms):
    """No proof rests on itself, though near leads back and forth."""
    for triple in store.inferred():
        proof = explain(store, axioms, triple)

        assert proof[0].triple == triple
        assert len(proof) > 1
        for at, step in enumerate(proof):
            premises = proof[at + 1 : at + 2]
            assert bool(step.axiom) == store.is_inferred(step.triple)
            assert bool(step.axiom) == (bool(premises) and premises[0].depth == step.depth + 1)


def test_the_shallowest_proof_is_given(store, axioms):
    """A symmetric relation is not explained by a detour."""
    proof = explain(store, axioms, (ex("b"), ex("near"), ex("a")))

    assert [step.depth for step in proof] == [0, 1]


def test_what_is_asserted_needs_no_proof(store, axioms):
    """It stands for itself, in any spelling."""
    asserted = (ex("elbow"), ex("freedom"), literal("1.000e0", f"{XSD}double"))

    assert explain(store, axioms, asserted) == (
        Step((*asserted[:2], literal("1", f"{XSD}double"))),
    )


def test_what_does_not_hold_has_no_proof(store, axioms):
    """There is nothing to explain."""
    assert explain(store, axioms, (ex("arm"), ex("joins"), ex("arm"))) == ()


def violation(focus: Term, *premises: Triple, **bindings: Term) -> tuple[Constraint, Result]:
    constraint = Constraint(
        owner="https://example.org/rule",
        shape=ex("rule"),
        component="",
        severity="",
        premises=premises,
    )
    return constraint, Result(constraint, focus, bindings=bindings)


def test_premises_are_the_triples_that_the_query_matched(store):
    """Variables without a binding are found together."""
    found = premises_of(
        store,
        *violation(
            ex("elbow"),
            ("?this", RDF_TYPE, ex("Joint")),
            ("?this", ex("attachment"), "?end"),
            ("?end", ex("on"), "?value"),
            value=ex("arm"),
        ),
    )

    assert found == (
        ((ex("elbow"), RDF_TYPE, ex("Joint")), True),
        ((ex("elbow"), ex("attachment"), ex("tip")), False),
        ((ex("tip"), ex("on"), ex("arm")), True),
    )


def test_premises_may_name_blank_nodes(store):
    """A blank value is told apart from others."""
    (blank,) = [o for s, p, o in next(iter(store.documents.values())).statements if o[:2] == "_:"]
    found = premises_of(
        store, *violation(ex("elbow"), ("?this", ex("attachment"), "?value"), value=blank)
    )

    assert found == (((ex("elbow"), ex("attachment"), blank), False),)


def test_premises_that_do_not_hold_together_are_given_one_by_one(store):
    """A pattern under OPTIONAL or a computed value hides only itself."""
    found = premises_of(
        store,
        *violation(
            ex("elbow"),
            ("?this", RDF_TYPE, ex("Revolute")),
            ("?this", ex("freedom"), "?value"),
            ("?value", ex("on"), "?other"),
            value=literal("7"),
        ),
    )

    assert found == (((ex("elbow"), RDF_TYPE, ex("Revolute")), False),)


def test_a_result_rests_on_its_premises_without_class_trees(store, axioms):
    """Only where the class is what the result tells is it shown how the class follows."""
    matched = ("?this", ex("freedom"), "?n"), ("?this", RDF_TYPE, ex("Joint"))
    steps = because(store, axioms, *violation(ex("elbow"), *matched))
    assert [(step.depth, step.axiom) for step in steps] == [(0, "")]

    told = violation(ex("elbow"), *matched[:1], ("?this", RDF_TYPE, "?value"), value=ex("Joint"))
    steps = because(store, axioms, *told)
    assert [(step.depth, step.axiom) for step in steps] == [
        (0, ""),
        (0, "every Revolute is a Joint"),
        (1, ""),
    ]
