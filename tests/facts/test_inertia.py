"""Principal moments of inertia, in any frame and about the centre of mass."""

from __future__ import annotations

import math
from typing import Any

import pytest
from computed import Node, computed
from hypothesis import example, given
from hypothesis import strategies as st

from kinlint.facts.inertia import about_centre
from kinlint.facts.linear_algebra import eigenvalues, product, transpose
from kinlint.facts.rotation import from_euler

SIZES = ("least", "middle", "greatest")
TYPES = ["InertiaReference", "RigidBodyInertiaCoordinate", "MassScalar"]
TYPES += ["FirstMomentOfMassVectorXYZ", "MomentOfInertiaXYZ", "ProductOfInertiaXYZ"]
moments = st.floats(1e-6, 1e3)
angles = st.floats(-math.pi, math.pi)


def inertia(**said: Any) -> dict[str, Any]:
    return computed({"@id": "ex:c", "@type": TYPES, **said}).of("ex:c")


def principal(found: Node, kind: str = "moment") -> list[float]:
    return [found[f"{size}-{kind}"] for size in SIZES]


def diagonal(x: float, y: float, z: float) -> tuple[tuple[float, float, float], ...]:
    return (x, 0.0, 0.0), (0.0, y, 0.0), (0.0, 0.0, z)


def test_moments_without_products_are_principal() -> None:
    """In ascending order."""
    found = inertia(unit="KiloGM-M2", ixx=3, iyy=1, izz=2)

    assert principal(found) == [1, 2, 3]


def test_products_turn_the_principal_axes() -> None:
    """[[2, 1], [1, 2]] has the eigenvalues 1 and 3."""
    found = inertia(unit="KiloGM-M2", ixx=2, iyy=2, izz=5, ixy=1, ixz=0, iyz=0)

    assert principal(found) == pytest.approx([1, 3, 5], rel=1e-15)


def test_a_tensor_may_have_no_unit() -> None:
    """Whether a body can have it does not depend on its unit."""
    assert principal(inertia(ixx=2, iyy=2, izz=5)) == [2, 2, 5]
    assert inertia(unit=["KiloGM-M2", "KiloGM-CentiM2"], ixx=2, iyy=2, izz=5) == {}


def test_a_garbled_product_is_not_taken_for_zero() -> None:
    """Nothing is known of the tensor then."""
    assert inertia(ixx=2, iyy=2, izz=5, ixy=[1, 2]) == {}
    assert inertia(ixx=2, iyy=2, izz=5, ixy="one") == {}


def test_the_parallel_axis_leads_to_the_centre() -> None:
    """A point mass of 2 kg at x = 3 m resists turning about y and z, but not about its centre."""
    point = {"mass": 2, "first-moment-of-mass": [6, 0, 0], "ixx": 0, "iyy": 18, "izz": 18}
    found = inertia(unit=["KiloGM", "M-KiloGM", "KiloGM-M2"], **point)

    assert principal(found) == [0, 18, 18]
    assert principal(found, "central-moment") == [0, 0, 0]
    assert found["centre-distance"] == 3
    assert found["mass"] == 2


def test_units_of_mass_and_moment_count_too() -> None:
    """Grams and a first moment in kg m."""
    said = {"mass": 2000, "first-moment-of-mass": [6, 0, 0], "ixx": 1, "iyy": 19, "izz": 19}
    found = inertia(unit=["GM", "M-KiloGM", "KiloGM-M2"], **said)

    assert principal(found, "central-moment") == pytest.approx([1, 1, 1])


def split(**said: Any) -> dict[str, Any]:
    """What is computed of moments, where *said* is on other coordinates of one inertia."""
    seen = {"of-inertia": "ex:i", "as-seen-by": "ex:f"}
    parts = {
        "ex:m": {"mass": 2, "unit": "KiloGM", **seen},
        "ex:s": {"first-moment-of-mass": [6, 0, 0], "unit": "M-KiloGM", **seen},
        "ex:c": {"ixx": 0, "iyy": 18, "izz": 18, "unit": "KiloGM-M2", **seen},
    }
    nodes: list[Node] = [{"@id": name, "@type": TYPES, **part} for name, part in parts.items()]
    whole = {"@type": "RigidBodyInertia", "of-body": "ex:b", "about": "ex:p"}
    nodes += [{"@id": "ex:i", **whole}, {"@id": "ex:other", **whole}]
    changed = [{**node, **said.get(node["@id"].removeprefix("ex:"), {})} for node in nodes]
    return computed(*changed).of("ex:c")


@pytest.mark.parametrize(
    "elsewhere", [{}, {"m": {"of-inertia": "ex:other"}}, {"s": {"of-inertia": "ex:other"}}]
)
def test_mass_and_first_moment_may_be_on_nodes_of_their_own(elsewhere: dict[str, Node]) -> None:
    """Of the same inertia, or of another of the same body about the same point."""
    found = split(**elsewhere)

    assert principal(found, "central-moment") == [0, 0, 0]
    assert found["body-mass"] == 2


@pytest.mark.parametrize(
    ("apart", "masses"),
    [
        ({"s": {"as-seen-by": "ex:g"}}, 1),
        ({"s": {"of-inertia": "ex:other"}, "other": {"about": "ex:q"}}, 1),
        ({"m": {"of-inertia": "ex:other"}, "other": {"of-body": "ex:d"}}, 0),
        ({"m": {"unit": None}}, 0),
    ],
)
def test_what_does_not_go_together_is_not_put_together(apart: dict[str, Node], masses: int) -> None:
    """A moment in another frame or about another point, a mass of another body or no unit."""
    found = split(**apart)

    assert "least-central-moment" not in found
    assert list(found).count("body-mass") == masses


@pytest.mark.parametrize(
    "said",
    [
        {"mass": 0, "first-moment-of-mass": [1, 0, 0]},
        {"mass": -1, "first-moment-of-mass": [1, 0, 0]},
        {"first-moment-of-mass": [1, 0, 0]},
        {"mass": 1},
        {"mass": 1, "first-moment-of-mass": [1, 0]},
        {"mass": 1, "first-moment-of-mass": [1, 0, 0], "unit": ["KiloGM", "KiloGM-M2"]},
    ],
)
def test_without_mass_and_first_moment_there_is_no_centre(said: Node) -> None:
    """Nor with a mass of nothing, nor where only some of them have a unit."""
    found = inertia(**{"ixx": 1, "iyy": 1, "izz": 1, **said})

    assert "least-moment" in found
    assert "least-central-moment" not in found


def test_the_older_release_states_principal_moments() -> None:
    """On the inertia itself."""
    iri = (
        "https://comp-rob2b.github.io/metamodels/newtonian-rigid-body-dynamics/structural-entities#"
    )
    node = {"@id": "ex:i", f"{iri}xx": 0.3, f"{iri}yy": 0.1, f"{iri}zz": 0.2, f"{iri}mass": 2.0}
    found = computed(node).of("ex:i")

    assert principal(found) == [0.1, 0.2, 0.3]
    assert found["mass"] == 2


@given(st.tuples(moments, moments, moments), st.tuples(angles, angles, angles))
def test_eigenvalues_do_not_depend_on_the_frame(
    principal_moments: tuple[float, float, float], euler: tuple[float, float, float]
) -> None:
    """A rotated tensor has the same principal moments."""
    turn = from_euler("xyz", euler, intrinsic=True)
    rotated = product(product(turn, diagonal(*principal_moments)), transpose(turn))
    least = 1e-13 * max(principal_moments)

    assert eigenvalues(rotated) == pytest.approx(sorted(principal_moments), abs=least)


@given(moments, moments, moments, st.floats(0.01, 100), st.tuples(*[st.floats(-2, 2)] * 3))
def test_the_parallel_axis_is_undone(
    x: float, y: float, z: float, mass: float, centre: tuple[float, float, float]
) -> None:
    """Away from the centre and back is where it was: a negative mass moves the other way."""
    there = about_centre(diagonal(x, y, z), -mass, centre)
    back = about_centre(there, mass, centre)

    size = max(x, y, z, mass * 12)
    for row, expected in zip(back, diagonal(x, y, z), strict=True):
        assert row == pytest.approx(expected, abs=1e-13 * size)
    assert sum(there[index][index] for index in range(3)) >= x + y + z - 1e-12 * size


@given(st.lists(st.floats(allow_nan=False, allow_infinity=False), min_size=6, max_size=6))
@example([0.0, 0.0, 5.3e307, 1.3e308, 1.3e308, 0.0])
@example([1.7e308] * 6)
def test_no_numbers_upset_the_eigenvalues(entries: list[float]) -> None:
    """Not even those near the ends of a double: there are three, in order."""
    x, y, z, a, b, c = entries
    least, middle, greatest = eigenvalues(((x, a, b), (a, y, c), (b, c, z)))
    assert least <= middle <= greatest
