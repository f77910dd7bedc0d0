"""Of a lifting query, a run makes what it needs and leaves the rest."""

from __future__ import annotations

import pytest
from test_lifting import MODELS, model, named

from kinlint.engine.construct_template import Made, made_by, needed, trimmed
from kinlint.engine.lifting import lift, queries
from kinlint.sparql.ast import Group
from kinlint.sparql.parser import parse_construct
from kinlint.terms import RDF_TYPE, iri
from kinlint.vocabulary import KIN, QUDT, SRC, UNIT

PREFIXES = {"": "urn:x:", "kin": KIN, "qudt": QUDT, "src": SRC, "unit": UNIT}
TEMPLATE = """
    ?limit a kin:JointPositionLimit , kin:Limit ;
        qudt:unit unit:RAD ;
        kin:range (?lower ?upper) ;
        src:from ?element .
    ?joint a ?kind ;
        src:from ?element .
"""
FORMATS = ("urdf", "sdf")
KINDS = {
    each.term
    for form in FORMATS
    for query in queries(form)
    for each in query.made
    if each.predicate == RDF_TYPE
}


def template() -> tuple[Made, ...]:
    return made_by(parse_construct(f"CONSTRUCT {{ {TEMPLATE} }} WHERE {{}}", PREFIXES).template)


def group(text: str) -> Group:
    return parse_construct(f"CONSTRUCT {{}} WHERE {text}", PREFIXES).group


def test_a_template_is_taken_apart():
    """Into triples, of which each says what it would have to be asked for by."""
    limit, joint, element, origin = "?limit", "?joint", "?element", iri(f"{SRC}from")
    made = template()
    assert made == (
        (limit, RDF_TYPE, iri(f"{KIN}JointPositionLimit")),
        (limit, RDF_TYPE, iri(f"{KIN}Limit")),
        (limit, iri(f"{QUDT}unit"), iri(f"{UNIT}RAD")),
        (limit, iri(f"{KIN}range"), "( ?lower ?upper )"),
        (limit, origin, element),
        (joint, RDF_TYPE, "?kind"),
        (joint, origin, element),
    )
    assert made[0].term == iri(f"{KIN}JointPositionLimit")
    assert made[2].term == iri(f"{QUDT}unit")
    assert made[5].term is None
    assert made[3].items == ("?lower", "?upper")
    assert made[4].items is None
    assert made[3].variables == {"?limit", "?lower", "?upper"}


def test_what_is_asked_for_comes_with_a_class_and_its_origin():
    """A class that is worked out is there in any case."""
    made = template()
    joint = [made[5], made[6]]

    assert needed(made, ()) == joint
    assert needed(made, {iri(f"{QUDT}unit")}) == [made[0], made[2], made[4], *joint]
    assert needed(made, {"a"}) == [made[0], made[1], made[4], *joint]


@pytest.mark.parametrize(
    ("where", "left"),
    [
        ("{ ?a :p ?b . BIND (STR(?b) AS ?c) }", "{ ?a :p ?b . }"),
        ("{ ?a :p ?b . BIND (STR(?b) AS ?c) BIND (STR(?c) AS ?d) }", "{ ?a :p ?b . }"),
        ("{ ?a :p ?b . OPTIONAL { ?a :q ?c . FILTER (?c > 1) } }", "{ ?a :p ?b . }"),
        ("{ ?a :p ?b . OPTIONAL { ?a :q ?c } FILTER (!BOUND(?c)) }", None),
        ("{ ?a :p ?b . OPTIONAL { ?a :q ?x } OPTIONAL { ?b :q ?x } FILTER (?x > 1) }", None),
        ("{ ?a :p ?b . BIND (STR(?b) AS ?c) FILTER (?c != ?a) }", None),
        ("{ ?a :p ?b . BIND (STR(?b) AS ?used) }", None),
        ("{ ?a :p ?b . FILTER NOT EXISTS { ?b :q ?c } }", None),
        ("{ { ?a :p ?b BIND (1 AS ?c) } UNION { ?b :q ?a } }", "{ {?a :p ?b} UNION {?b :q ?a} }"),
    ],
)
def test_what_binds_nothing_that_is_looked_at_is_left_out(where, left):
    """And nothing that decides whether there is a solution."""
    assert trimmed(group(where), {"?a", "?used"}) == group(where if left is None else left)


@pytest.mark.slow
@pytest.mark.parametrize("form", FORMATS)
def test_less_is_lifted_the_same(form):
    """What is left, is as it is where all is lifted."""
    wanted = {each for query in queries(form) for each in query.makes}
    store = model(*MODELS)
    lift(store)
    everything = named(store)
    for term in sorted(wanted - KINDS):
        lift(store, {term}, {term})
        found = named(store)
        assert found <= everything
        assert {each for each in found if each[1] == term} == {
            each for each in everything if each[1] == term
        }
    assert any(predicate == RDF_TYPE for _, predicate, _ in everything)
