"""What coordinates that contradict others would say if the others are right."""

from __future__ import annotations

import math
from collections.abc import Mapping
from itertools import product as every
from typing import Any

import pytest
from computed import QUARTER, STRAIGHT, Computed, Node, pose, shift, store_of
from hypothesis import assume, given
from hypothesis import strategies as st

from kinlint.facts.computation import hints
from kinlint.facts.fact_statements import fact
from kinlint.facts.linear_algebra import Matrix
from kinlint.facts.rotation import LOCKED, euler, from_euler, from_quaternion, quaternion

SEQUENCES = ["".join(each) for each in every("xyz", repeat=3) if each[0] != each[1] != each[2]]
QUATERNION = {"@type": ["PoseReference", "PoseCoordinate", "Quaternion", "VectorXYZ"]}

turns = st.tuples(*[st.floats(-math.pi, math.pi)] * 3)
signs = st.tuples(*[st.floats(-1.0, 1.0)] * 4)


def said(*nodes: Node) -> list[tuple[str, str, float]]:
    """The numbers that could be there instead: of which node, which property, and what."""
    found = Computed(hints(store_of(*nodes), [fact("recomputed")]))
    changes = [found.of(node) for node in found.nodes("recomputed")]
    return [(each["place"], _local(each["entry"]), each["amended"]) for each in changes]


def changed(*nodes: Node) -> Mapping[str, float]:
    """The same by property, of one node."""
    places = {place for place, _, _ in said(*nodes)}
    assert len(places) == 1
    return {entry: value for _, entry, value in said(*nodes)}


def entries(matrix: Matrix) -> Any:
    return pytest.approx([each for row in matrix for each in row], abs=1e-9)


def flat(matrix: Matrix) -> list[float]:
    return [each for row in matrix for each in row]


def test_what_has_fewer_digits_is_recomputed() -> None:
    """In its own unit, and as its own frame sees it."""
    first = QUARTER | shift(1, 0, 0)
    second = shift(0, -1234, 0) | {"as-seen-by": "ex:one", "unit": ["UNITLESS", "MilliM"]}

    assert said(*pose("p", "one", "base", first, second)) == [("ex:p-coord", "x", 1.234)]
    first = QUARTER | shift(1.2345, 0, 0)
    assert said(*pose("p", "one", "base", first, second)) == [("ex:p-coord1", "y", -1234.5)]


def test_of_equally_many_digits_the_first_is_right() -> None:
    """Nothing tells which of the two is meant."""
    assert said(*pose("p", "a", "b", shift(1, 2, 3), shift(1, 2, 4))) == [("ex:p-coord1", "z", 3)]


def test_of_three_the_odd_one_is_recomputed() -> None:
    """However many digits it has."""
    odd, even = shift(1, 2, 3.4567), shift(1, 2, 3)
    assert said(*pose("p", "a", "b", odd, even, even)) == [("ex:p-coord", "z", 3)]
    assert said(*pose("p", "a", "b", even, odd, even)) == [("ex:p-coord1", "z", 3)]


def test_coordinates_that_agree_are_left() -> None:
    """To the last digit."""
    assert said(*pose("p", "a", "b", QUARTER | shift(1, 2, 3), QUARTER | shift(1, 2, 3))) == []


def test_masses_and_distances_are_recomputed_and_tensors_left() -> None:
    """A number has a unit and no frame; which moments are wrong is not to be told."""
    types = ["InertiaReference", "RigidBodyInertiaCoordinate", "MassScalar", "MomentOfInertiaXYZ"]
    mass: Node = {"@type": types, "of-inertia": "ex:i", "ixx": 1, "iyy": 1, "izz": 1}
    of = "https://comp-rob2b.github.io/metamodels/geometry/coordinates#of"
    far = {"@type": ["LinearDistanceCoordinate", "Quantity"], of: {"@id": "ex:d"}}
    found = said(
        {"@id": "ex:i", "@type": "RigidBodyInertia", "of-body": "ex:link"},
        mass | {"@id": "ex:one", "unit": ["KiloGM", "KiloGM-M2"], "mass": 1.25},
        mass | {"@id": "ex:two", "unit": ["GM", "KiloGM-M2"], "mass": 1300, "izz": 1.5},
        far | {"@id": "ex:near", "unit": "M", "value": 1},
        far | {"@id": "ex:off", "unit": "MilliM", "value": 1250},
    )

    assert found == [("ex:near", "value", 1.25), ("ex:two", "mass", 1250)]


def test_frames_of_unknown_orientation_leave_no_way() -> None:
    """The norm alone does not make a vector."""
    other = shift(6, 0, 0) | {"as-seen-by": "ex:camera"}
    assert said(*pose("p", "a", "b", shift(0, 3, 4), other)) == []


def test_a_quaternion_follows_from_direction_cosines() -> None:
    """With the sign that leaves more of it as it was."""
    old = QUATERNION | {"qx": 0, "qy": 0, "qz": 0, "qw": -1}
    found = changed(*pose("p", "a", "b", QUARTER, old))

    assert found == {"qz": -0.707107, "qw": -0.707107}


def test_direction_cosines_follow_from_a_quaternion() -> None:
    """The numbers stand in lists."""
    exact = QUATERNION | {"qx": 0, "qy": 0, "qz": 0.70711, "qw": 0.70711}
    found = said(*pose("p", "a", "b", STRAIGHT, exact))

    assert [(entry, value) for _, entry, value in found] == [
        *(("first", 0), ("first", 1)),
        *(("first", -1), ("first", 0)),
    ]


def test_euler_angles_follow_in_their_unit() -> None:
    """Of two rotations on one node that with more digits is right."""
    node = {
        "@id": "ex:c",
        "@type": ["OrientationCoordinate", "Quaternion", "EulerAngles", "Intrinsic"],
        "qx": 0,
        "qy": 0,
        "qz": 0.70710678,
        "qw": 0.70710678,
        "axes-sequence": "xyz",
        "alpha": 0,
        "beta": 0,
        "gamma": 80,
        "unit": "DEG",
    }

    assert said(node) == [("ex:c", "gamma", 90)]


@pytest.mark.parametrize("intrinsic", [True, False])
@pytest.mark.parametrize("sequence", SEQUENCES)
@given(angles=turns)
def test_a_rotation_has_euler_angles(
    sequence: str, angles: tuple[float, float, float], *, intrinsic: bool
) -> None:
    """In each of the twelve sequences: those nearest to given ones are these themselves."""
    matrix = from_euler(sequence, angles, intrinsic=intrinsic)
    sine = math.sin(angles[1]) if sequence[0] == sequence[2] else math.cos(angles[1])
    assume(abs(sine) > 100 * LOCKED)

    assert euler(sequence, matrix, angles, intrinsic=intrinsic) == pytest.approx(angles, abs=1e-6)


def test_angles_about_one_axis_are_not_told_apart() -> None:
    """Looking straight up, only the sum of the first and the last angle is known."""
    up = from_euler("zyx", (0.1, math.pi / 2, 0.2), intrinsic=True)

    assert euler("zyx", up, (0, 0, 0), intrinsic=True) == ()


@given(signs)
def test_a_rotation_has_a_quaternion(given: tuple[float, float, float, float]) -> None:
    """It is that of the same rotation, whichever of its components is small."""
    norm = math.hypot(*given)
    assume(norm > 0.01)
    x, y, z, w = (each / norm for each in given)
    matrix = from_quaternion(x, y, z, w)

    assert flat(from_quaternion(*quaternion(matrix))) == entries(matrix)


def _local(entry: str) -> str:
    return entry.replace("/", "#").rpartition("#")[2]
