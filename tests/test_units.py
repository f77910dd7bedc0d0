"""The unit tables agree with themselves, with pint, and with what models write."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Any

import pytest
from pyoxigraph import RdfFormat, Store

from kinlint.resources import data
from kinlint.vocabulary import KIN, QUANTITY_KIND, QUDT, UNIT

PREFIXES = f"""
PREFIX qudt: <{QUDT}>
PREFIX unit: <{UNIT}>
PREFIX kind: <{QUANTITY_KIND}>
PREFIX kin: <{KIN}>
PREFIX skos: <http://www.w3.org/2004/02/skos/core#>
PREFIX geom-coord: <https://comp-rob2b.github.io/metamodels/geometry/coordinates#>
"""
FITS = "(skos:broader|qudt:exactMatch)*/^qudt:hasQuantityKind"

# The names of QUDT's base units in pint's words; compound names are read by the grammar below.
WORDS = {
    "UNITLESS": "dimensionless",
    "NUM": "dimensionless",
    "PERCENT": "percent",
    "RAD": "radian",
    "DEG": "degree",
    "ARCMIN": "arcminute",
    "ARCSEC": "arcsecond",
    "GRAD": "grade",
    "REV": "turn",
    "M": "meter",
    "IN": "inch",
    "FT": "foot",
    "L": "liter",
    "SEC": "second",
    "MIN": "minute",
    "HR": "hour",
    "HZ": "1/second",
    "G": "standard_gravity",
    "GM": "gram",
    "TONNE": "metric_ton",
    "LB": "pound",
    "LB_M": "pound",
    "OZ": "ounce",
    "N": "newton",
    "GM_F": "force_gram",
    "LB_F": "force_pound",
    "OZ_F": "force_ounce",
    "PA": "pascal",
    "J": "joule",
    "W": "watt",
    "A": "ampere",
    "V": "volt",
    "OHM": "ohm",
    "S": "siemens",
    "H": "henry",
    "K": "kelvin",
    "DEG_C": "delta_degC",
    "DEG_F": "delta_degF",
    "YD": "yard",
    "MI": "mile",
    "DAY": "day",
    "KN": "knot",
    "PPM": "ppm",
    "SLUG": "slug",
    "DYN": "dyne",
    "BAR": "bar",
    "PSI": "psi",
    "ATM": "atmosphere",
    "HP": "horsepower",
    "FARAD": "farad",
    "C": "coulomb",
    "T": "tesla",
    "WB": "weber",
}
SCALES = {
    "Giga": 1e9,
    "Mega": 1e6,
    "Kilo": 1e3,
    "Hecto": 1e2,
    "Deci": 1e-1,
    "Centi": 1e-2,
    "Milli": 1e-3,
    "Micro": 1e-6,
    "Nano": 1e-9,
    "Pico": 1e-12,
}


@pytest.fixture(scope="module")
def units() -> Store:
    """All facts of shapes/units in one default graph."""
    store = Store()
    for path in (data("shapes") / "units").glob("*.ttl"):
        store.bulk_load(path=str(path), format=RdfFormat.TURTLE)
    return store


def rows(store: Store, query: str) -> list[tuple[str, ...]]:
    found: Any = store.query(PREFIXES + query)
    return sorted(tuple(cell.value if cell else "" for cell in row) for row in found)


def local(iri: str) -> str:
    return re.split("[/#]", iri)[-1]


def factors(name: str) -> Iterator[tuple[str, float, int]]:
    """The pint word, scale and exponent of each factor that a QUDT unit name is made of."""
    sign = 1
    for part in name.split("-"):
        if part == "PER":
            sign = -1
            continue
        match = re.fullmatch(rf"({'|'.join(SCALES)})?([A-Z_]+)([2-9]?)", part)
        assert match, name
        scale = SCALES.get(match[1] or "", 1.0)
        yield WORDS[match[2]], scale, sign * int(match[3] or 1)


def test_size(units: Store) -> None:
    """There are at least 60 units, and every kind that comp-rob2b names or coins."""
    kinds = {local(row[0]) for row in rows(units, "SELECT ?k { ?k a qudt:QuantityKind }")}
    named = (
        "PlaneAngle Distance Position AngularSpeed AngularVelocity LinearSpeed LinearVelocity "
        "AngularAcceleration LinearAcceleration Torque Force AccelerationEnergy Angle Length "
        "Mass LengthMass MomentOfInertia Dimensionless Direction"
    )

    assert len(rows(units, "SELECT ?u { ?u a qudt:Unit }")) >= 60
    assert set(named.split()) <= kinds


def test_complete(units: Store) -> None:
    """Each unit has one symbol, dimension and factor, as double; each kind has one dimension."""
    found = rows(
        units,
        """SELECT ?u (COUNT(DISTINCT ?d) AS ?n) (COUNT(DISTINCT ?f) AS ?m) (COUNT(?s) AS ?k) {
        ?u a qudt:Unit . OPTIONAL { ?u qudt:hasDimensionVector ?d }
        OPTIONAL { ?u qudt:conversionMultiplier ?f FILTER(DATATYPE(?f) = xsd:double && ?f > 0) }
        OPTIONAL { ?u qudt:symbol ?s } } GROUP BY ?u""".replace(
            "xsd:double", "<http://www.w3.org/2001/XMLSchema#double>"
        ),
    )
    kinds = rows(
        units,
        """SELECT ?k (COUNT(?d) AS ?n) { ?k a qudt:QuantityKind
        OPTIONAL { ?k qudt:hasDimensionVector ?d } } GROUP BY ?k""",
    )

    assert [row for row in found if row[1:] != ("1", "1", "1")] == []
    assert [row for row in kinds if row[1] != "1"] == []


def test_every_term_is_described(units: Store) -> None:
    """Each kind that a unit, a kind or a representation refers to is itself described."""
    missing = rows(
        units,
        """SELECT DISTINCT ?k {
        ?s qudt:hasQuantityKind|skos:broader|qudt:exactMatch|
            kin:represents|kin:measuredAs|kin:hasKind ?k
        FILTER NOT EXISTS { ?k a qudt:QuantityKind } }""",
    )

    assert missing == []


def test_dimensions_agree(units: Store) -> None:
    """A unit has the dimension of each kind that it fits, and broader or equal kinds share it."""
    fitting = f"SELECT ?u ?k {{ ?k {FITS} ?u . ?u qudt:hasDimensionVector ?d . "
    fitting += "?k qudt:hasDimensionVector ?e FILTER(?d != ?e) }"

    assert rows(units, fitting) == []


def test_every_kind_has_a_unit(units: Store) -> None:
    """Each kind is fitted by some unit, and each unit of QUDT fits some kind."""
    kinds = f"SELECT ?k {{ ?k a qudt:QuantityKind FILTER NOT EXISTS {{ ?k {FITS} ?u }} }}"
    lone = "SELECT ?u { ?u a qudt:Unit FILTER NOT EXISTS { ?u qudt:hasQuantityKind ?k } }"

    assert rows(units, kinds) == []
    assert [local(row[0]) for row in rows(units, lone)] == ["N-M2-PER-SEC2"]


def test_equal_kinds(units: Store) -> None:
    """Equality of kinds is stated both ways."""
    query = "SELECT ?a { ?a qudt:exactMatch ?b FILTER NOT EXISTS { ?b qudt:exactMatch ?a } }"

    assert rows(units, query) == []


@pytest.mark.parametrize(
    ("kind", "fitting", "other"),
    [
        ("Angle", "RAD DEG REV", "UNITLESS M NUM"),
        ("PlaneAngle", "RAD DEG", "UNITLESS"),
        ("Dimensionless", "UNITLESS NUM PERCENT", "RAD"),
        ("Distance", "M MilliM IN", "RAD"),
        ("Position", "M", "UNITLESS"),
        ("Torque", "N-M MilliN-M", "J N"),
        ("Energy", "J W-HR", "N-M"),
        ("AngularVelocity", "RAD-PER-SEC REV-PER-MIN", "HZ M-PER-SEC"),
        ("Frequency", "HZ", "RAD-PER-SEC"),
        ("AccelerationEnergy", "N-M-PER-SEC2", "N-M2-PER-SEC2 J"),
        ("TorquePerAngle", "N-M-PER-RAD", "N-M"),
        ("Temperature", "K DEG_C", ""),
        ("CelsiusTemperature", "DEG_C", "K"),
    ],
)
def test_fit(units: Store, kind: str, fitting: str, other: str) -> None:
    """Kinds tell apart what dimensions cannot: torque and energy, angles and numbers."""
    found = {local(row[0]) for row in rows(units, f"SELECT ?u {{ kind:{kind} {FITS} ?u }}")}

    assert set(fitting.split()) <= found
    assert not set(other.split()) & found


def test_direction_cosines(units: Store) -> None:
    """Direction cosines state an angle by numbers without a unit."""
    query = f"""SELECT ?u {{ geom-coord:DirectionCosineXYZ kin:represents kind:Angle ;
        kin:measuredAs/{FITS} ?u }}"""

    assert {"UNITLESS", "NUM", "PERCENT", "PPM"} == {local(row[0]) for row in rows(units, query)}


@pytest.mark.slow
def test_pint(units: Store) -> None:
    """Each unit has the factor, offset and dimension that pint gives to what its name says."""
    pint = pytest.importorskip("pint", reason="pint is not installed")
    registry = pint.UnitRegistry()
    found = rows(
        units,
        """SELECT ?u ?f ?d { ?u a qudt:Unit ; qudt:conversionMultiplier ?f ;
        qudt:hasDimensionVector ?d }""",
    )

    for iri, factor, vector in found:
        quantity = math.prod(
            (registry.Quantity(scale, word) ** exponent)
            for word, scale, exponent in factors(local(iri))
        )
        base = quantity.to_base_units()
        assert float(factor) == pytest.approx(base.magnitude, rel=1e-12), iri
        of = {name: int(base.dimensionality.get(f"[{name}]", 0)) for name in DIMENSIONS}
        letters = "".join(f"{DIMENSIONS[name]}{of[name]}" for name in DIMENSIONS)
        assert local(vector) == f"{letters}D{int(not any(of.values()))}", iri

    offsets = rows(units, "SELECT ?u ?o { ?u qudt:conversionOffset ?o }")
    assert {local(iri): float(offset) for iri, offset in offsets} == {
        name: registry.Quantity(0, word).to("kelvin").magnitude
        for name, word in (("DEG_C", "degC"), ("DEG_F", "degF"))
    }


DIMENSIONS = {
    "substance": "A",
    "current": "E",
    "length": "L",
    "luminosity": "I",
    "mass": "M",
    "temperature": "H",
    "time": "T",
}
