"""Values in SI: which unit counts, and where there is none."""

from __future__ import annotations

import math

import pytest
from computed import computed, pose, shift

PLACE = ("x", "y", "z")


def quantity(**said: object) -> dict[str, float]:
    return computed({"@id": "ex:q", "@type": "Quantity", **said}).of("ex:q")


def coordinates(*types: str, **said: object) -> dict[str, float]:
    return computed({"@id": "ex:c", "@type": list(types), **said}).of("ex:c")


@pytest.mark.parametrize(
    ("unit", "number", "si"),
    [
        ("M", "0.68", 0.68),
        ("MilliM", "680", 0.68),
        ("DEG", "90", math.pi / 2),
        ("DEG_C", "20", 293.15),
        ("KiloGM", "2.5", 2.5),
    ],
)
def test_a_value_is_stated_in_si(unit: str, number: str, si: float) -> None:
    """By factor and offset of the unit it names."""
    assert quantity(unit=unit, value=number)["value"] == pytest.approx(si, rel=1e-15)


@pytest.mark.parametrize("unit", [[], ["M", "MilliM"], "ex:furlong"])
def test_a_doubtful_unit_gives_no_value(unit: object) -> None:
    """None, several, or one that nobody knows."""
    assert quantity(unit=unit, value="1.0") == {}


def test_a_unit_that_the_model_defines_counts() -> None:
    """As long as it says what it measures and by which factor."""
    qudt = "http://qudt.org/schema/qudt/"
    furlong = {
        "@id": "ex:furlong",
        f"{qudt}conversionMultiplier": 201.168,
        f"{qudt}hasDimensionVector": {
            "@id": "http://qudt.org/vocab/dimensionvector/A0E0L1I0M0H0T0D0"
        },
    }
    value = {"@id": "ex:q", "@type": "Quantity", "unit": "ex:furlong", "value": "2.0"}

    assert computed(furlong, value).value("ex:q", "value") == 402.336


def test_of_several_units_of_a_pose_the_length_counts() -> None:
    """Whatever the unit of its orientation is."""
    metres = {"unit": ["UNITLESS", "CentiM"], **shift(1, 2, 3)}
    found = computed(*pose("p", "a", "b", metres)).of("ex:p-coord")

    assert [found[axis] for axis in PLACE] == pytest.approx([0.01, 0.02, 0.03])


@pytest.mark.parametrize("unit", [["UNITLESS", "RAD"], ["M", "CentiM"], "SEC", []])
def test_a_pose_without_one_length_has_no_numbers(unit: object) -> None:
    """A length in other units is none."""
    found = computed(*pose("p", "a", "b", {"unit": unit, **shift(1, 2, 3)}))

    assert not set(PLACE) & set(found.of("ex:p-coord"))


def test_coordinates_of_a_pose_may_forget_their_type() -> None:
    """What they are coordinates of tells that their numbers are lengths."""
    found = computed(
        {"@id": "ex:p", "@type": "Position", "of": "ex:a", "with-respect-to": "ex:b"},
        {"@id": "ex:c", "@type": ["PositionReference", "VectorXYZ"], "of-position": "ex:p"}
        | {"unit": ["M", "RAD"], **shift(1, 2, 3)},
    )

    assert found.value("ex:c", "y") == 2


def test_other_vectors_have_one_unit_or_no_numbers() -> None:
    """A twist has two units, and nothing says which of them its x, y and z are of."""
    direction = coordinates("DirectionCoordinate", "VectorXYZ", unit="UNITLESS", **shift(0, 0, 1))
    twist = coordinates("VectorXYZ", unit=["RAD-PER-SEC", "M-PER-SEC"], **shift(0, 0, 1))

    assert direction["z"] == 1
    assert twist == {}


def test_limits_couplings_and_masses() -> None:
    """They have SI values under the name of the property."""
    limit = coordinates("JointPositionLimit", unit="DEG", lower=-180, upper=90)
    coupling = coordinates("JointCoupling", unit="MilliM", multiplier=2.0, offset=5)
    mass = coordinates("MassCoordinate", "MassScalar", unit=["GM", "M"], mass=1500)

    assert limit == {"lower": pytest.approx(-math.pi), "upper": pytest.approx(math.pi / 2)}
    assert coupling == {"offset": 0.005}
    assert mass == {"mass": 1.5}


def test_angles_of_euler_are_in_radians() -> None:
    """Also where the node has a unit of length besides."""
    found = coordinates("EulerAngles", unit=["DEG", "M"], alpha=180, beta=0, gamma=-90)

    assert found["alpha"] == pytest.approx(math.pi)
    assert found["gamma"] == pytest.approx(-math.pi / 2)


def test_one_number_written_twice_is_one() -> None:
    """Two are none."""
    same = coordinates("MassCoordinate", "MassScalar", unit="KiloGM", mass=[1, 1.0])
    different = coordinates("MassCoordinate", "MassScalar", unit="KiloGM", mass=[1, 1.5])

    assert same == {"mass": 1}
    assert different == {}
