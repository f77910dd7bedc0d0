"""Rotations by direction cosines, quaternions, Euler angles and the vectors of frames."""

from __future__ import annotations

import math
from typing import Any

import pytest
from computed import QUARTER, Node, computed, pose, shift, turn
from hypothesis import given
from hypothesis import strategies as st

from kinlint.facts.linear_algebra import (
    IDENTITY,
    angle,
    determinant,
    orthonormality,
    product,
    rigid,
    transpose,
)
from kinlint.facts.rotation import from_axis, from_euler, from_quaternion

angles = st.floats(-math.pi, math.pi)


def stated(*types: str, **said: Any) -> dict[str, Any]:
    return computed({"@id": "ex:c", "@type": list(types), **said}).of("ex:c")


def cosines(matrix: Node) -> dict[str, Any]:
    return stated("OrientationCoordinate", "DirectionCosineXYZ", **matrix)


def test_a_quarter_turn_is_a_rotation() -> None:
    """Its determinant is 1, and it misses nothing."""
    assert cosines(QUARTER) == {"determinant": 1.0, "orthonormality": 0.0}


def test_a_reflection_is_orthonormal() -> None:
    """Only its determinant gives it away."""
    mirror = turn((0, 0, 1), (0, 1, 0), (1, 0, 0))

    assert cosines(mirror) == {"determinant": -1.0, "orthonormality": 0.0}


def test_a_shear_has_determinant_one() -> None:
    """Only its columns, which are the lists, give it away."""
    shear = turn((1, 0, 0), (0.5, 1, 0), (0, 0, 1))

    assert cosines(shear) == {"determinant": 1.0, "orthonormality": 0.5}


def test_a_matrix_needs_three_lists_of_three() -> None:
    """Fewer say nothing."""
    assert cosines(turn((1, 0), (0, 1, 0), (0, 0, 1))) == {}
    assert cosines({"direction-cosine-x": [1, 0, 0]}) == {}


def test_a_quaternion_has_a_norm() -> None:
    """A rotation is one of norm 1."""
    half = math.sqrt(0.5)
    found = stated("OrientationCoordinate", "Quaternion", qx=half, qy=0, qz=0, qw=half)
    double = stated("OrientationCoordinate", "Quaternion", qx=0, qy=0, qz=0, qw=2)

    assert found["norm"] == pytest.approx(1.0, abs=1e-15)
    assert found["orthonormality"] < 1e-15
    assert double == {"norm": 2.0, "determinant": 64.0, "orthonormality": 15.0}


def test_the_axes_of_a_quaternion() -> None:
    """A quarter turn about z leads x to y."""
    half = math.sqrt(0.5)
    (xx, _, _), (xy, _, _), (xz, _, _) = from_quaternion(0, 0, half, half)

    assert (xx, xy, xz) == pytest.approx((0, 1, 0))


def test_intrinsic_angles_turn_about_moved_axes() -> None:
    """First a quarter turn about z, then one about the new x, which is the old y: z leads to x."""
    intrinsic = from_euler("zxy", (math.pi / 2, math.pi / 2, 0), intrinsic=True)
    extrinsic = from_euler("zxy", (math.pi / 2, math.pi / 2, 0), intrinsic=False)

    assert [row[2] for row in intrinsic] == pytest.approx([1, 0, 0])
    assert [row[2] for row in extrinsic] == pytest.approx([0, -1, 0])


@given(angles, angles, angles)
def test_extrinsic_is_intrinsic_in_reverse(a: float, b: float, c: float) -> None:
    """The same turns in the opposite order."""
    one = from_euler("xyz", (a, b, c), intrinsic=False)
    other = from_euler("zyx", (c, b, a), intrinsic=True)

    assert angle(product(transpose(one), other)) < 1e-7


@pytest.mark.parametrize(
    "said",
    [
        {"axes-sequence": "xyw"},
        {"axes-sequence": "xxy"},
        {"axes-sequence": "xy"},
        {"@type": ["OrientationCoordinate", "Quaternion", "EulerAngles"]},
        {"@type": ["OrientationCoordinate", "Quaternion", "EulerAngles", "Intrinsic", "Extrinsic"]},
        {"unit": "UNITLESS"},
        {"gamma": "INF"},
    ],
)
def test_what_leaves_a_choice_is_no_rotation(said: Node) -> None:
    """Angles need three axes, one convention and a unit."""
    whole = {
        "@id": "ex:c",
        "@type": ["OrientationCoordinate", "Quaternion", "EulerAngles", "Extrinsic"],
        "axes-sequence": "xyz",
        "unit": "DEG",
        "alpha": 90,
        "beta": 0,
        "gamma": 0,
        **dict.fromkeys(("qx", "qw"), math.sqrt(0.5)),
        **dict.fromkeys(("qy", "qz"), 0),
    }

    assert computed(whole).value("ex:c", "spread") == pytest.approx(0.0, abs=1e-9)
    assert computed(whole | said).values("ex:c", "spread") == []


@given(st.sampled_from("xyz"), angles)
def test_the_angle_of_a_rotation_is_found_again(axis: str, by: float) -> None:
    """Small angles as exactly as large ones."""
    assert angle(from_axis(axis, by)) == pytest.approx(abs(by), rel=1e-12, abs=1e-300)


@given(angles, angles, angles, st.integers(0, 8), st.floats(-0.01, 0.01))
def test_rounding_is_taken_off_a_rotation(
    a: float, b: float, c: float, entry: int, error: float
) -> None:
    """What is left is a rotation close by."""
    exact = from_euler("xyz", (a, b, c), intrinsic=True)
    rows = [list(row) for row in exact]
    rows[entry // 3][entry % 3] += error
    x, y, z = ((row[0], row[1], row[2]) for row in rows)

    found = rigid((x, y, z))

    assert orthonormality(found) < 1e-13
    assert determinant(found) == pytest.approx(1.0)
    assert angle(product(transpose(found), exact)) <= 2 * abs(error) + 1e-7
    assert rigid(IDENTITY) == IDENTITY


def basis(*ends: Node) -> list[Node]:
    nodes: list[Node] = [
        {"@id": "ex:f", "@type": ["Frame", "OriginVectorsXYZ"], "origin": "ex:o"}
        | {f"vector-{axis}": f"ex:v{axis}" for axis in "xyz"}
    ]
    for axis, end in zip("xyz", ends, strict=True):
        nodes += [
            {"@id": f"ex:v{axis}", "@type": ["Vector", "BoundVector"]}
            | {"start": "ex:o", "end": f"ex:e{axis}"},
            {"@id": f"ex:p{axis}", "@type": "Position"}
            | {"of": f"ex:e{axis}", "with-respect-to": "ex:o"},
            {"@id": f"ex:c{axis}", "@type": ["PositionReference", "PositionCoordinate"]}
            | {"of-position": f"ex:p{axis}", "as-seen-by": "ex:g", "unit": "MilliM"}
            | end,
        ]
        nodes[-1]["@type"].append("VectorXYZ")
    return nodes


def test_a_frame_is_judged_by_the_ends_of_its_vectors() -> None:
    """In metres, and left-handed where the third vector points the other way."""
    ends = [shift(1000, 0, 0), shift(0, 1000, 0), shift(0, 0, -1000)]
    found = computed(*basis(*ends))

    assert found.of("ex:f") == {"determinant": -1, "orthonormality": 0, "orthogonality": 0}
    assert found.values("ex:f", "derived-from") == ["ex:cx", "ex:cy", "ex:cz"]


def test_a_position_may_lead_from_end_to_start() -> None:
    """It counts in reverse."""
    nodes = basis(shift(1000, 0, 0), shift(0, 1000, 0), shift(0, 0, -1000))
    for node in nodes:
        if node["@id"] == "ex:pz":
            node |= {"of": "ex:o", "with-respect-to": "ex:ez"}

    assert computed(*nodes).value("ex:f", "determinant") == 1


def test_vectors_seen_by_different_frames_are_not_compared() -> None:
    """Their components do not add up to a matrix."""
    ends = [shift(1, 0, 0), shift(0, 1, 0), shift(0, 0, 1) | {"as-seen-by": "ex:h"}]

    assert computed(*basis(*ends)).of("ex:f") == {}


def test_vectors_may_have_numbers_of_their_own() -> None:
    """Without any unit, as directions have none; how long they are, orthogonality ignores."""
    nodes = [
        {"@id": "ex:f", "@type": "Frame"} | {f"vector-{axis}": f"ex:v{axis}" for axis in "xyz"},
        *(
            {"@id": f"ex:v{axis}", "@type": ["Vector", "VectorXYZ"]} | end
            for axis, end in zip(
                "xyz", (shift(2, 0, 0), shift(2, 2, 0), shift(0, 0, 1)), strict=True
            )
        ),
    ]
    found = computed(*nodes).of("ex:f")

    assert found["determinant"] == 4
    assert found["orthonormality"] == 7
    assert found["orthogonality"] == pytest.approx(math.sqrt(0.5))


def test_every_coordinates_node_speaks_for_itself() -> None:
    """Two of one pose are judged apart."""
    found = computed(*pose("p", "a", "b", QUARTER, turn((1, 0, 0), (0, 1, 0), (0, 0, -1))))

    assert found.value("ex:p-coord", "determinant") == 1
    assert found.value("ex:p-coord1", "determinant") == -1


def test_what_two_representations_of_one_node_differ_by() -> None:
    """In rad; a quaternion and its negative are one rotation, and what is none is left out."""
    half = math.sqrt(0.5)
    types = ("OrientationCoordinate", "DirectionCosineXYZ", "Quaternion")
    alike = stated(*types, **QUARTER, qx=0, qy=0, qz=-half, qw=-half)
    apart = stated(*types, **QUARTER, qx=0, qy=0, qz=-half, qw=half)
    mirrored = turn((1, 0, 0), (0, 1, 0), (0, 0, -1))

    assert alike["spread"] == pytest.approx(0.0, abs=1e-15)
    assert apart["spread"] == pytest.approx(math.pi)
    assert "spread" not in stated(*types, **mirrored, qx=0, qy=0, qz=0, qw=1)


def test_three_representations_differ_by_the_largest_of_their_angles() -> None:
    found = stated(
        *("OrientationCoordinate", "DirectionCosineXYZ", "Quaternion", "EulerAngles", "Intrinsic"),
        **QUARTER | dict(zip(("qx", "qy", "qz", "qw"), (0, 0, 0, 1), strict=True)),
        **{"axes-sequence": "xyz", "alpha": 0, "beta": 0, "gamma": 60, "unit": "DEG"},
    )

    assert found["spread"] == pytest.approx(math.pi / 2)
