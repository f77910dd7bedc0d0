"""Constraints that nothing can violate are told from the others without a query."""

import pytest
from turtle_document import document

from kinlint.engine.constraint import Constraint
from kinlint.engine.pruning import Presence
from kinlint.engine.store import Store
from kinlint.terms import RDF_TYPE
from kinlint.vocabulary import FACT, RDFS

EX = "https://example.org/arm#"
SUBCLASS = f"<{RDFS}subClassOf>"


def ex(name):
    return f"<{EX}{name}>"


def constraint(*premises, targets=()):
    return Constraint(
        owner="", shape="", component="", severity="", premises=premises, targets=targets
    )


@pytest.fixture
def presence():
    store = Store()
    store.load(
        [
            document(
                f"@prefix ex: <{EX}> . @prefix rdfs: <{RDFS}> .\n"
                "ex:Hinge rdfs:subClassOf ex:Joint . ex:Joint rdfs:subClassOf ex:Hinge .\n"
                "ex:elbow a ex:Hinge ; ex:name 'elbow' ."
            )
        ]
    )
    return Presence(store)


@pytest.mark.parametrize(
    "premise",
    [
        ("?this", ex("name"), "?name"),
        ("?this", ex("name"), '"another"'),
        ("?this", RDF_TYPE, ex("Hinge")),
        ("?k_c", f"{SUBCLASS}*", ex("Joint")),
        ("?this", f"{ex('lost')}*", "?name"),
        ("?this", f"{ex('lost')}|{ex('name')}", "?name"),
        ("?this", "?anything", "?name"),
    ],
)
def test_what_may_match(presence, premise):
    """A predicate that is there, a type or a subclass of it, and whatever is not that plain."""
    assert presence.may_violate(constraint(premise))


@pytest.mark.parametrize(
    "premise",
    [
        ("?this", ex("lost"), "?name"),
        ("?this", f"{ex('lost')}|{ex('gone')}", "?name"),
        ("?this", RDF_TYPE, ex("Joint")),
        ("?this", RDF_TYPE, ex("Link")),
        ("?k_c", f"{SUBCLASS}*", ex("Link")),
    ],
)
def test_what_cannot_match(presence, premise):
    """One premise that nothing matches is enough, whatever the others."""
    assert not presence.may_violate(constraint(("?this", ex("name"), "?name"), premise))


def test_one_way_to_be_a_target_is_enough(presence):
    """A target class holds of members of its subclasses too, and no way given means any node."""
    lost = ("?k_t", ex("lost"), "?this")

    assert presence.may_violate(constraint(targets=(lost, ("?this", RDF_TYPE, ex("Joint")))))
    assert presence.may_violate(constraint(targets=(("?this", ex("name"), "?k_t"), lost)))
    assert presence.may_violate(constraint(targets=(("?this", RDF_TYPE, "?k_t"), lost)))
    assert not presence.may_violate(constraint(targets=(lost, ("?this", RDF_TYPE, ex("Link")))))


def test_what_may_yet_come_may_match(presence):
    """Properties and classes that will be made, and whatever is computed."""
    coming = Presence(presence.store, {ex("lost"), ex("Link")})

    assert coming.may_violate(constraint(("?this", ex("lost"), "?name")))
    assert coming.may_violate(constraint(("?this", RDF_TYPE, ex("Link"))))
    assert coming.may_violate(constraint(("?this", f"<{FACT}mass>", "?mass")))
    assert not coming.may_violate(constraint(("?this", ex("gone"), "?name")))
