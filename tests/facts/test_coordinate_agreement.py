"""Coordinates of one relation, compared after change of unit and frame."""

from __future__ import annotations

import math
from typing import Any

import pytest
from computed import QUARTER, STRAIGHT, Node, computed, pose, shift, turn


def compared(*nodes: Node) -> list[dict[str, Any]]:
    found = computed(*nodes)
    return [found.of(node) for node in found.nodes("agreement")]


def test_units_and_frames_are_changed_before_comparing() -> None:
    """A pose in mm, in m, and as the frame that it is of sees the vector, are the same pose."""
    facts = compared(
        *pose(
            "p",
            "one",
            "base",
            QUARTER | shift(1000, 0, 0) | {"unit": ["UNITLESS", "MilliM"]},
            QUARTER | shift(1, 0, 0),
            shift(0, -1, 0) | {"as-seen-by": "ex:one"},
        )
    )

    assert facts == [
        {
            "of": "ex:p",
            "first": "ex:p-coord",
            "second": "ex:p-coord1",
            "distance": 0,
            "magnitude": 1,
            "angle": 0,
        },
        {
            "of": "ex:p",
            "first": "ex:p-coord",
            "second": "ex:p-coord2",
            "distance": 0,
            "magnitude": 1,
        },
    ]


def test_disagreement_is_measured() -> None:
    """In metres and radians."""
    (found,) = compared(
        *pose("p", "a", "b", STRAIGHT | shift(0, 3, 4), QUARTER | shift(0.3, 3, 4.4))
    )

    assert found["distance"] == pytest.approx(0.5)
    assert found["angle"] == pytest.approx(math.pi / 2)
    assert found["magnitude"] == pytest.approx(math.hypot(0.3, 3, 4.4))


def test_frames_of_unknown_orientation_leave_the_norm() -> None:
    """A vector is as long as another, whoever sees it."""
    (found,) = compared(
        *pose("p", "a", "b", shift(0, 3, 4), shift(6, 0, 0) | {"as-seen-by": "ex:camera"})
    )

    assert found["compared"] == "norm"
    assert found["distance"] == 1
    assert found["magnitude"] == 6


def test_the_first_that_states_a_quantity_is_compared() -> None:
    """Coordinates split over two nodes complement each other and need not agree."""
    assert not compared(*pose("p", "a", "b", STRAIGHT, shift(1, 2, 3)))
    facts = compared(*pose("p", "a", "b", STRAIGHT, shift(1, 2, 3), QUARTER | shift(1, 2, 3)))

    assert [(found["first"], found.get("angle"), found.get("distance")) for found in facts] == [
        ("ex:p-coord1", None, 0),
        ("ex:p-coord", pytest.approx(math.pi / 2), None),
    ]


def test_a_relation_that_states_numbers_is_compared_with_its_coordinates() -> None:
    """As where relation and coordinates are one node."""
    (relation, coordinates) = pose("p", "a", "b", shift(1, 2, 4))
    relation |= {"@type": ["Pose", "PoseCoordinate", "VectorXYZ"], "as-seen-by": "ex:b"}
    (found,) = compared(relation | {"unit": "M", **shift(1, 2, 3)}, coordinates)

    assert (found["first"], found["second"]) == ("ex:p", "ex:p-coord")
    assert found["distance"] == 1


def test_a_reflection_agrees_with_nothing() -> None:
    """It turns nothing, so its angle says nothing."""
    mirror = turn((0, 0, 1), (0, 1, 0), (1, 0, 0))
    (found,) = compared(*pose("p", "a", "b", STRAIGHT | shift(0, 0, 1), mirror | shift(0, 0, 1)))

    assert "angle" not in found
    assert found["distance"] == 0


def test_numbers_without_a_unit_are_not_compared() -> None:
    """Nor those with two of one kind."""
    for unit in ([], ["M", "MilliM"]):
        doubtful = shift(9, 9, 9) | {"unit": unit}

        assert not compared(*pose("p", "a", "b", shift(1, 2, 3), doubtful))


def inertia(*coordinates: Node) -> list[Node]:
    types = ["InertiaReference", "RigidBodyInertiaCoordinate", "MassScalar"]
    types += ["FirstMomentOfMassVectorXYZ", "MomentOfInertiaXYZ", "ProductOfInertiaXYZ"]
    return [
        {"@id": "ex:i", "@type": "RigidBodyInertia", "of-body": "ex:link", "about": "ex:o"},
        *(
            {"@id": f"ex:c{index}", "@type": types, "of-inertia": "ex:i", "as-seen-by": "ex:base"}
            | {"unit": ["KiloGM", "M-KiloGM", "KiloGM-M2"]}
            | each
            for index, each in enumerate(coordinates)
        ),
    ]


def test_inertias_are_turned_into_one_frame() -> None:
    """A quarter turn about z swaps the moments about x and y."""
    facts = compared(
        *pose("p", "one", "base", QUARTER),
        *inertia(
            {"ixx": 1, "iyy": 2, "izz": 3, "mass": 5, "first-moment-of-mass": [1, 0, 0]},
            {"ixx": 2, "iyy": 1, "izz": 3.5, "mass": 4, "first-moment-of-mass": [0, -1, 0]}
            | {"as-seen-by": "ex:one"},
        ),
    )
    by = {found["quantity"].rpartition("#")[2]: found for found in facts}

    assert by["ixx"]["distance"] == pytest.approx(0.5)
    assert by["ixx"]["magnitude"] == 3.5
    assert by["mass"]["distance"] == 1
    assert by["first-moment-of-mass"]["distance"] == pytest.approx(0, abs=1e-15)


def test_twists_are_compared_by_their_parts() -> None:
    """Each with the unit of its dimension."""
    types = ["VelocityReference", "VelocityTwistCoordinate"]
    types += ["AngularVelocityVectorXYZ", "LinearVelocityVectorXYZ"]
    twist = {"@type": types, "of-velocity": "ex:t", "as-seen-by": "ex:b"}
    facts = compared(
        {"@id": "ex:t", "@type": "VelocityTwist", "of": "ex:a", "with-respect-to": "ex:b"},
        twist
        | {"@id": "ex:one", "unit": ["RAD-PER-SEC", "M-PER-SEC"]}
        | {"angular-velocity": [0, 0, 1.0], "linear-velocity": [1, 0, 0]},
        twist
        | {"@id": "ex:two", "unit": ["DEG-PER-SEC", "MilliM-PER-SEC"]}
        | {"angular-velocity": [0, 0, 180.0], "linear-velocity": [1000, 0, 0]},
    )
    by = {found["quantity"].rpartition("#")[2]: found for found in facts}

    assert by["angular-velocity"]["distance"] == pytest.approx(math.pi - 1)
    assert by["linear-velocity"]["distance"] == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("wrong", range(4))
def test_of_several_coordinates_the_odd_one_out_is_compared_with_the_others(wrong: int) -> None:
    """Where it is written does not matter: one of the comparisons shows a difference."""
    coordinates = [QUARTER | shift(1, 0, 0) for _ in range(4)]
    coordinates[wrong] = QUARTER | shift(2, 0, 0)
    facts = compared(*pose("p", "one", "base", *coordinates))

    (apart,) = [fact for fact in facts if fact.get("distance")]
    assert apart["second"] == f"ex:p-coord{wrong or ''}"
