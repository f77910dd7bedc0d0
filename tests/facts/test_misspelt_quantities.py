"""Units and kinds of quantity that are known ones, but for a slip of spelling."""

from __future__ import annotations

import pytest
from computed import computed

from kinlint.vocabulary import QUANTITY_KIND, UNIT


def resembled(kind: str) -> list[str]:
    """The names of the known kinds that *kind* is told to resemble."""
    found = computed({"@id": "ex:quantity", "@type": "Quantity", "quantity-kind": kind})
    return [
        end.removeprefix(QUANTITY_KIND)
        for start, name, end in found.triples
        if (start, name) == (QUANTITY_KIND + kind, "fact:resembles")
    ]


@pytest.mark.parametrize(
    ("slip", "meant"),
    [
        ("Lenght", "Length"),
        ("Angel", "Angle"),
        ("Legth", "Length"),
        ("Torqua", "Torque"),
        ("torque", "Torque"),
        ("linear-velocity", "LinearVelocity"),
        ("AngularVelocitiy", "AngularVelocity"),
    ],
)
def test_a_slip_of_spelling_is_told(slip: str, meant: str) -> None:
    """One letter inserted, deleted, replaced or swapped, capitals and hyphens aside."""
    assert resembled(slip) == [meant]


@pytest.mark.parametrize(
    "kind", ["Length", "Jerk", "LuminousIntensity", "Viscosity", "Reluctance", "ReactivePower"]
)
def test_another_kind_is_not_taken_for_a_slip(kind: str) -> None:
    """Neither a known kind nor one of the many others that QUDT has."""
    assert resembled(kind) == []


def measured(unit: str) -> list[str]:
    """The names of the known units that *unit* is told to resemble."""
    found = computed({"@id": "ex:quantity", "@type": "Quantity", "unit": unit})
    return [
        end.removeprefix(UNIT)
        for start, name, end in found.triples
        if (start, name) == (UNIT + unit, "fact:resembles")
    ]


@pytest.mark.parametrize(
    ("slip", "meant"),
    [("RADD", "RAD"), ("rad", "RAD"), ("MM", "MilliM"), ("KG", "KiloGM")],
)
def test_a_unit_is_known_by_its_name_or_symbol(slip: str, meant: str) -> None:
    assert measured(slip) == [meant]


@pytest.mark.parametrize("unit", ["RAD", "degrees", "KM2", "KiloM-PER-SEC3", "X", "SHEET"])
def test_another_unit_is_not_taken_for_a_slip(unit: str) -> None:
    """Neither a known unit nor a short name, which is near to many."""
    assert measured(unit) == []
