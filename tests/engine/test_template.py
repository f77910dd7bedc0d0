"""Of a lifting query, a run makes what it needs and leaves the rest."""

from __future__ import annotations

import pytest
from test_lifting import MODELS, model, named

from kinlint.engine.lifting import lift, queries
from kinlint.engine.template import needed, parsed, trimmed
from kinlint.terms import RDF_TYPE, iri
from kinlint.vocabulary import KIN, QUDT, SRC

PREFIXES = {"kin": KIN, "qudt": QUDT, "src": SRC, "unit": "http://qudt.org/vocab/unit/"}
TEMPLATE = """
    ?limit a kin:JointPositionLimit , kin:Limit ;
        qudt:unit unit:RAD ;
        kin:range (?lower ?upper) ;
        src:from ?element .
    ?joint a ?kind ;
        src:from ?element .
"""
KINDS = {each.term for query in queries() for each in query.made if each.predicate == "a"}


def test_a_template_is_taken_apart():
    """Into triples, of which each says what it would have to be asked for by."""
    assert [(s, p, o) for s, p, o, _ in parsed(TEMPLATE, PREFIXES)] == [
        ("?limit", "a", "kin:JointPositionLimit"),
        ("?limit", "a", "kin:Limit"),
        ("?limit", "qudt:unit", "unit:RAD"),
        ("?limit", "kin:range", "( ?lower ?upper )"),
        ("?limit", "src:from", "?element"),
        ("?joint", "a", "?kind"),
        ("?joint", "src:from", "?element"),
    ]
    terms = [each.term for each in parsed(TEMPLATE, PREFIXES)]
    assert terms[0] == iri(f"{KIN}JointPositionLimit")
    assert terms[2] == iri(f"{QUDT}unit")
    assert terms[5] is None


def test_what_is_asked_for_comes_with_a_class_and_its_origin():
    """A class that is worked out is there in any case."""
    made = list(parsed(TEMPLATE, PREFIXES))
    joint = [made[5], made[6]]

    assert needed(made, ()) == joint
    assert needed(made, {iri(f"{QUDT}unit")}) == [made[0], made[2], made[4], *joint]
    assert needed(made, {"a"}) == [made[0], made[1], made[4], *joint]


@pytest.mark.parametrize(
    ("where", "left"),
    [
        ("{ ?a :p ?b . BIND (STR(?b) AS ?c) }", "{ ?a :p ?b .  }"),
        ("{ ?a :p ?b . BIND (STR(?b) AS ?c) BIND (STR(?c) AS ?d) }", "{ ?a :p ?b .   }"),
        ("{ ?a :p ?b . OPTIONAL { ?a :q ?c . FILTER (?c > 1) } }", "{ ?a :p ?b .  }"),
        ("{ ?a :p ?b . OPTIONAL { ?a :q ?c } FILTER (!BOUND(?c)) }", None),
        ("{ ?a :p ?b . OPTIONAL { ?a :q ?x } OPTIONAL { ?b :q ?x } FILTER (?x > 1) }", None),
        ("{ ?a :p ?b . BIND (STR(?b) AS ?c) FILTER (?c != ?a) }", None),
        ("{ ?a :p ?b . BIND (STR(?b) AS ?used) }", None),
        ("{ ?a :p ?b . FILTER NOT EXISTS { ?b :q ?c } }", None),
    ],
)
def test_what_binds_nothing_that_is_looked_at_is_left_out(where, left):
    """And nothing that decides whether there is a solution."""
    assert trimmed(where, {"?a", "?used"}) == (where if left is None else left)


@pytest.mark.parametrize("form", ["urdf", "sdf"])
def test_less_is_lifted_the_same(form):
    """What is left, is as it is where all is lifted."""
    wanted = {each for query in queries() for each in query.makes if query.format == form}
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
