from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from turtle_document import PREFIXES, document, ex, triples

from kinlint import resources
from kinlint.engine.axioms import Axiom
from kinlint.engine.closure import close
from kinlint.engine.ontology import compile_axioms
from kinlint.engine.reference.owl import owlrl_closure
from kinlint.engine.store import Store
from kinlint.errors import RuleInvalid
from kinlint.terms import Triple

ONTOLOGY = sorted((resources.data("shapes") / "ontology").glob("*.ttl"))


def written(folder: Path, turtle: str) -> list[Path]:
    file = folder / "ontology.ttl"
    file.write_text(PREFIXES + turtle, "utf-8")
    return [file]


def closed(model: str, ontology: list[Path]) -> set[Triple]:
    store = Store()
    store.load([document(model)])
    store.load_vocabulary(ontology)
    return inferred(store, compile_axioms(ontology))


def inferred(store: Store, axioms: Sequence[Axiom]) -> set[Triple]:
    """What *axioms* conclude, each once."""
    close(store, axioms)
    found = list(store.inferred())
    assert len(found) == len(set(found))
    return set(found)


CASES = {
    "subclass": (
        ":Revolute rdfs:subClassOf :Joint . :Joint rdfs:subClassOf :Entity .",
        ":j a :Revolute .",
        ":j a :Joint, :Entity .",
    ),
    "equivalent class": (
        ":Hinge owl:equivalentClass :Revolute .",
        ":a a :Hinge . :b a :Revolute .",
        ":a a :Revolute . :b a :Hinge .",
    ),
    "subproperty": (":of-pose rdfs:subPropertyOf :of .", ":a :of-pose :b .", ":a :of :b ."),
    "equivalent property": (
        ":of owl:equivalentProperty :about .",
        ":a :of :b . :c :about :d .",
        ":a :about :b . :c :of :d .",
    ),
    "domain": (":joins rdfs:domain :Joint .", ":a :joins :b .", ":a a :Joint ."),
    "range": (":start rdfs:range :Point .", ":a :start :b .", ":b a :Point ."),
    "inverse": (
        ":part owl:inverseOf :whole .",
        ":a :whole :b . :c :part :d .",
        ":b :part :a . :d :whole :c .",
    ),
    "symmetric": (":near a owl:SymmetricProperty .", ":a :near :b .", ":b :near :a ."),
    "transitive": (
        ":in a owl:TransitiveProperty .",
        ":a :in :b . :b :in :c . :c :in :d . :d :in :e .",
        ":a :in :c, :d, :e . :b :in :d, :e . :c :in :e .",
    ),
    "chain": (
        ":body owl:propertyChainAxiom ( :frame :origin :of ) .",
        ":a :frame :b . :b :origin :c . :c :of :d .",
        ":a :body :d .",
    ),
    "chain over an inverse": (
        ":sibling owl:propertyChainAxiom ( :in [ owl:inverseOf :in ] ) .",
        ":a :in :c . :b :in :c .",
        ":a :sibling :b, :a . :b :sibling :a, :b .",
    ),
    "chain that continues itself": (
        ":tail owl:propertyChainAxiom ( :tail :next ) . :next rdfs:subPropertyOf :tail .",
        ":l :next :m . :m :next :n . :n :next :o .",
        ":l :tail :m, :n, :o . :m :tail :n, :o . :n :tail :o .",
    ),
    "value of a class": (
        ":Revolute rdfs:subClassOf [ owl:onProperty :freedom ; owl:hasValue 1 ] .",
        ":j a :Revolute .",
        ":j :freedom 1 .",
    ),
    "class of a value": (
        ":Single owl:equivalentClass [ owl:onProperty :freedom ; owl:hasValue 01 ] .",
        ":j :freedom 1 . :k a :Single . :m :freedom 2 .",
        ":j a :Single . :k :freedom 1 .",
    ),
    "some values": (
        ":Joined owl:equivalentClass [ owl:onProperty :by ; owl:someValuesFrom :Joint ] .",
        ":a :by :j . :j a :Joint . :b :by :k . :c a :Joined .",
        ":a a :Joined .",
    ),
    "some value at all": (
        "[ owl:onProperty :by ; owl:someValuesFrom owl:Thing ] rdfs:subClassOf :Joined .",
        ":a :by :j .",
        ":a a :Joined .",
    ),
    "all values": (
        ":Chain rdfs:subClassOf [ owl:onProperty :joints ; owl:allValuesFrom :Joint ] .",
        ":c a :Chain ; :joints :j, :k .",
        ":j a :Joint . :k a :Joint .",
    ),
    "intersection": (
        ":Unit owl:intersectionOf ( :Bound :Long ) .",
        ":a a :Bound, :Long . :b a :Unit . :c a :Long .",
        ":a a :Unit . :b a :Bound, :Long .",
    ),
    "union": (
        ":Coord owl:equivalentClass [ owl:unionOf ( :Pose :Position ) ] .",
        ":a a :Pose . :b a :Position . :c a :Coord .",
        ":a a :Coord . :b a :Coord .",
    ),
    "nested": (
        """:Held owl:equivalentClass [ owl:intersectionOf ( :Body
             [ owl:onProperty [ owl:inverseOf :joins ] ; owl:someValuesFrom
               [ owl:unionOf ( :Fixed [ owl:onProperty :freedom ; owl:hasValue 0 ] ) ] ] ) ] .""",
        """:a a :Body . :j :joins :a ; :freedom 0 . :b a :Body . :k :joins :b .
           :m :joins :c ; a :Fixed .""",
        ":a a :Held .",
    ),
    "class of nothing": (
        "[ owl:intersectionOf ( :Fixed :Driven ) ] rdfs:subClassOf owl:Nothing .",
        ":j a :Fixed, :Driven . :k a :Fixed .",
        ":j a owl:Nothing .",
    ),
    "nothing of datatypes": (
        ":x rdfs:range xsd:double . :y rdfs:range :Point . :C rdfs:subClassOf owl:Thing .",
        ":a :x 1.0e0 ; :y 2.0e0 . :c a :C .",
        "",
    ),
    "nothing of disjointness": (
        ":A owl:disjointWith :B . [] a owl:AllDisjointClasses ; owl:members ( :A :B ) .",
        ":a a :A .",
        "",
    ),
    "several at once": (
        """:by owl:inverseOf :joins . :near a owl:SymmetricProperty, owl:TransitiveProperty ;
           owl:propertyChainAxiom ( :by :joins ) .""",
        ":j :joins :a, :b . :k :joins :b, :c .",
        """:a :by :j . :b :by :j, :k . :c :by :k .
           :a :near :a, :b, :c . :b :near :a, :b, :c . :c :near :a, :b, :c .""",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_what_an_axiom_concludes_is_inferred_and_nothing_else(name, tmp_path):
    """Each kind of axiom means what OWL 2 RL says, and owlrl says the same."""
    axioms, model, expected = CASES[name]
    ontology = written(tmp_path, axioms)

    assert closed(model, ontology) == set(triples(expected))
    assert owlrl_closure(triples(model), ontology) == set(triples(expected))


NODES = st.sampled_from([":a", ":b", ":c", ":d", "_:e"])
TYPES = st.sampled_from([":Revolute", ":Joint", ":Body", ":Held", ":Fixed"])
ARCS = st.sampled_from([":joins", ":by", ":near", ":in", ":part", ":freedom"])
EVERYTHING = """
    :Revolute rdfs:subClassOf :Joint .
    :Fixed rdfs:subClassOf :Joint, [ owl:onProperty :in ; owl:hasValue :d ] .
    :by owl:inverseOf :joins .
    :near a owl:SymmetricProperty ; owl:propertyChainAxiom ( :by :joins ) .
    :in a owl:TransitiveProperty ; owl:propertyChainAxiom ( :near :in ) .
    :part rdfs:subPropertyOf :in .
    :joins rdfs:domain :Joint ; rdfs:range :Body .
    :Held owl:equivalentClass [ owl:onProperty :by ; owl:someValuesFrom :Fixed ] .
    :Body rdfs:subClassOf [ owl:onProperty :by ; owl:allValuesFrom :Joint ] .
"""


@pytest.mark.slow
@settings(max_examples=25)
@given(
    st.lists(st.tuples(NODES, TYPES), max_size=4),
    st.lists(st.tuples(NODES, ARCS, NODES), max_size=8),
)
def test_the_closure_is_that_of_owlrl(tmp_path_factory, typed, related):
    """However the axioms meet, the oracle finds the same."""
    ontology = written(tmp_path_factory.getbasetemp(), EVERYTHING)
    types = [f"{node} a {kind} ." for node, kind in typed]
    arcs = [f"{start} {arc} {end} ." for start, arc, end in related]
    model = " ".join([*types, *arcs])

    assert closed(model, ontology) == owlrl_closure(triples(model), ontology)


def test_asserted_triples_are_not_inferred_again(tmp_path):
    """What a file says is never called derived, whichever file says it."""
    ontology = written(tmp_path, ":A rdfs:subClassOf :B . :x a :B .")
    store = Store()
    store.load([document(":a a :A .", "one"), document(":a a :B . :x a :A .", "two")])
    store.load_vocabulary(ontology)

    assert len(inferred(store, compile_axioms(ontology))) == 0


def test_closing_again_forgets_what_no_longer_follows(tmp_path):
    """A store can be edited and closed over and over."""
    ontology = written(tmp_path, ":A rdfs:subClassOf :B .")
    axioms = compile_axioms(ontology)
    store = Store()
    store.load([document(":a a :A .")])
    assert len(inferred(store, axioms)) == 1

    store.load([document(":b a :C .")])

    assert len(inferred(store, axioms)) == 0
    assert len(inferred(store, axioms)) == 0


def test_no_axioms_infer_nothing():
    """A user may lint without an ontology."""
    store = Store()
    store.load([document(":a a :A .")])

    assert len(inferred(store, ())) == 0


LABELS = {
    "subclass": "every Revolute is a Joint",
    "subproperty": "of-pose implies of",
    "domain": "whatever has joins is a Joint",
    "range": "every value of start is a Point",
    "inverse": "part is the inverse of whole",
    "symmetric": "near is symmetric",
    "transitive": "in is transitive",
    "chain": "frame, then origin, then of makes body",
    "chain over an inverse": "in, then inverse of in makes sibling",
    "value of a class": "every Revolute has 1 as freedom",
    "class of a value": "whatever has 1 as freedom is a Single",
    "some values": "whatever has a Joint as by is a Joined",
    "some value at all": "whatever has by is a Joined",
    "all values": "whatever a Chain has as joints is a Joint",
    "intersection": "whatever is a Bound and is a Long is a Unit",
    "class of nothing": "whatever is a Fixed and is a Driven cannot be",
    "nested": (
        "whatever is a Body and has something that has 0 as freedom as inverse of joins is a Held"
    ),
}


@pytest.mark.parametrize("name", LABELS)
def test_axioms_say_in_words_what_they_mean(name, tmp_path):
    """An explanation reads as a sentence."""
    labels = [axiom.label for axiom in compile_axioms(written(tmp_path, CASES[name][0]))]

    assert LABELS[name] in labels


@pytest.mark.parametrize("name", CASES)
def test_axioms_survive_json(name, tmp_path):
    """A cached catalogue is the catalogue."""
    axioms = compile_axioms(written(tmp_path, CASES[name][0]))

    assert tuple(Axiom.from_json(json.loads(json.dumps(a.to_json()))) for a in axioms) == axioms


@pytest.mark.parametrize(
    "chain",
    [
        ":p owl:propertyChainAxiom ( :q :p :q ) .",
        ":p owl:propertyChainAxiom ( :p :q :p ) .",
        ":p owl:propertyChainAxiom ( :q :r ) . :q rdfs:subPropertyOf :r . :r owl:inverseOf :p .",
        ":p owl:propertyChainAxiom ( :q :r ) . :q owl:propertyChainAxiom ( :r :p ) .",
    ],
)
def test_chains_that_feed_themselves_from_inside_are_refused(chain, tmp_path):
    """OWL 2 asks for an order of properties; without one a closure explodes."""
    with pytest.raises(RuleInvalid, match="property chain that makes"):
        compile_axioms(written(tmp_path, chain))


def test_a_broken_ontology_is_named_with_its_line(tmp_path):
    """Whoever extends the ontology sees where."""
    with pytest.raises(RuleInvalid, match=r"ontology\.ttl:\d+: "):
        compile_axioms(written(tmp_path, ":a :b"))


ARM = """
    @prefix geom: <https://comp-rob2b.github.io/metamodels/geometry/structural-entities#> .
    @prefix kc: <https://comp-rob2b.github.io/metamodels/kinematic-chain/structural-entities#> .
    @prefix coord: <https://comp-rob2b.github.io/metamodels/geometry/coordinates#> .
    :upper a geom:SimplicialComplex ; geom:simplices :tip, :tip-o .
    :lower a geom:SimplicialComplex ; geom:simplices :root .
    :tip a geom:Frame ; geom:origin :tip-o ; geom:vector-x :tip-x .
    :tip-x a geom:BoundVector ; geom:start :tip-o .
    :elbow a kc:RevoluteJoint ; kc:between-attachments :tip, :root .
    :c a coord:PoseCoordinate ; coord:of-pose :pose ; coord:as-seen-by :root ; coord:x 0.10e0 .
"""


@pytest.mark.slow
def test_our_ontology_closes_as_owlrl_does():
    """The shipped axioms are all of a kind that is compiled."""
    inferred = closed(ARM, ONTOLOGY)
    joins = "<https://w3id.org/kinlint/kinematics#joins-body>"

    assert {(ex("elbow"), joins, ex("upper")), (ex("elbow"), joins, ex("lower"))} <= inferred
    assert inferred == owlrl_closure(triples(ARM), ONTOLOGY)
