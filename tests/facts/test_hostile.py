"""Models that nobody means: whatever they say, facts end and never fail."""

from __future__ import annotations

from typing import Any

import pytest
from computed import OF_MODELS, Node, computed, frame, pose, shift, store_of
from hypothesis import given, settings
from hypothesis import strategies as st

from kinlint.document import Document, SourceMap
from kinlint.engine.store import Store
from kinlint.facts.computation import facts
from kinlint.facts.predicate_index import PredicateIndex, numeric
from kinlint.formats.turtle.format import TURTLE
from kinlint.terms import RDF, XSD, iri, literal
from kinlint.text import SourceText

FIRST, REST, NIL = (iri(f"{RDF}{name}") for name in ("first", "rest", "nil"))
COSINE = "<https://comp-rob2b.github.io/metamodels/geometry/coordinates#direction-cosine-{}>"
CHAIN = "<https://comp-rob2b.github.io/metamodels/algorithm#trigger-chain>"


def loaded(*triples: tuple[str, str, str]) -> Store:
    text = SourceText("hostile.ttl", "")
    store = Store()
    store.load([Document(text, "<urn:hostile>", triples, SourceMap(), format=TURTLE)])
    return store


@pytest.mark.parametrize(
    "value",
    [
        "NaN",
        "INF",
        "-INF",
        "1_000.0",
        "",
        "one",
        {"@id": "ex:a"},
        [1, 2],
        {"@value": "1.0", "@language": "en"},
        {"@value": "1.0", "@type": "http://www.w3.org/2001/XMLSchema#string"},
        {"@value": "true", "@type": "http://www.w3.org/2001/XMLSchema#boolean"},
        None,
        {"@list": [1]},
        "1e999",
    ],
)
def test_what_is_no_number_gives_no_fact(value: Any) -> None:
    """Nor do its neighbours suffer."""
    found = computed(*pose("p", "a", "b", shift(1, 2, 3) | {"x": value})).of("ex:p-coord")

    assert found == {"y": 2, "z": 3}


@pytest.mark.parametrize(
    ("text", "number"),
    [("1.5", 1.5), ("1.5E-1", 0.15), ("-0", 0.0), ("+7", 7.0), ("0x10", None), ("1e999", None)],
)
def test_numbers_are_read_by_value(text: str, number: float | None) -> None:
    """Whatever their datatype, as long as it is one of numbers."""
    for datatype in ("double", "decimal", "integer", "float"):
        assert numeric(literal(text, f"{XSD}{datatype}")) == number
    assert numeric(literal(text)) is None


def test_lists_in_circles_are_no_lists() -> None:
    """Neither short ones of numbers nor long ones of operators."""
    one = literal("1", f"{XSD}double")
    circle = (("_:a", FIRST, one), ("_:a", REST, "_:b"), ("_:b", FIRST, one), ("_:b", REST, "_:a"))
    cosines = ((f"<urn:{axis}>", COSINE.format(axis), "_:a") for axis in "xyz")
    store = loaded(*circle, *cosines, ("<urn:s>", CHAIN, "_:a"))

    assert list(facts(store, OF_MODELS)) == []


@pytest.mark.parametrize(
    "cells",
    [
        (("_:a", FIRST, '"1"'),),
        (("_:a", REST, NIL),),
        (("_:a", FIRST, '"1"'), ("_:a", FIRST, '"2"'), ("_:a", REST, NIL)),
        (("_:a", FIRST, '"1"'), ("_:a", REST, NIL), ("_:a", REST, "_:a")),
        (("_:a", FIRST, '"1"'), ("_:a", REST, "_:missing")),
    ],
)
def test_broken_lists_have_no_items(cells: tuple[tuple[str, str, str], ...]) -> None:
    """A cell has one item and one rest."""
    assert PredicateIndex(loaded(*cells)).items("_:a") is None


def test_odd_identifiers_are_taken_as_they_are() -> None:
    """Facts of nodes with identifiers that are no IRIs, and of anonymous ones, come back."""
    node = {"@type": ["MassCoordinate", "MassScalar"], "unit": "KiloGM", "mass": 1}
    store = store_of(node | {"@id": "ex:a%zz|"}, node, {"@type": "Quantity", "unit": "ex:a b"})
    store.state(facts(store))

    assert len(list(store.facts())) >= 1
    assert all(store.holds(triple) for triple in facts(store))


def test_numbers_at_the_ends_of_a_double_do_no_harm() -> None:
    """What leaves the range is not stated."""
    huge = 1.7e308
    extreme = [
        *frame("a"),
        *frame("b"),
        *pose("p", "a", "b", shift(huge, huge, huge), shift(-huge, -huge, -huge)),
        *pose("q", "b", "a", shift(huge, 5e-324, huge) | {"unit": ["UNITLESS", "KiloM"]}),
        {"@id": "ex:i", "@type": ["RigidBodyInertiaCoordinate", "MassScalar", "MomentOfInertiaXYZ"]}
        | {"ixx": huge, "iyy": -huge, "izz": 5e-324, "mass": 5e-324},
    ]
    found = computed(*extreme)

    assert all(
        abs(value) < float("inf") for _, _, value in found.triples if isinstance(value, float)
    )


KEYS = ["of", "with-respect-to", "of-pose", "as-seen-by", "unit", "x", "mass", "ixx", "origin"]
KEYS += ["direction-cosine-x", "joints", "between-attachments", "simplices", "trigger-chain"]
KEYS += ["qx", "start", "end", "vector-x", "axes-sequence", "alpha", "first-moment-of-mass"]
TYPES = ["Pose", "Position", "PoseReference", "PoseCoordinate", "VectorXYZ", "DirectionCosineXYZ"]
TYPES += ["MassScalar", "MomentOfInertiaXYZ", "Schedule", "Quaternion", "EulerAngles", "Intrinsic"]
names = st.sampled_from(["ex:a", "ex:b", "ex:c", "M", "KiloGM"])
values = st.recursive(
    st.none() | st.booleans() | st.floats(allow_nan=False, allow_infinity=False) | names,
    lambda inner: st.lists(inner, max_size=4),
    max_leaves=6,
)
nodes = st.fixed_dictionaries(
    {"@id": names, "@type": st.lists(st.sampled_from(TYPES), max_size=5)},
    optional=dict.fromkeys(KEYS, values),
)


@pytest.mark.slow
@settings(max_examples=60)
@given(st.lists(nodes, max_size=5))
def test_any_model_has_facts(model: list[Node]) -> None:
    """Or none, but no error; and the same ones every time."""
    store = store_of(*model)
    found = list(facts(store))
    store.state(found)

    assert list(facts(store)) == found
