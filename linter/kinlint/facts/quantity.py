"""Quantities in SI units, where their unit leaves no doubt."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

from kinlint.facts.fact_statements import numbers
from kinlint.facts.linear_algebra import Vector
from kinlint.facts.metamodel_terms import COORDINATE_OF, body, coord, inertia, kin, qudt, rel
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.units import ANGLE, LENGTH, MASS, Units
from kinlint.terms import Term, Triple

AXES = ("x", "y", "z")
POSITIONAL = (coord("PositionCoordinate"), coord("PoseCoordinate"), rel("Position"), rel("Pose"))
VALUES = ((qudt("value"), "value"), *((kin(name), name) for name in ("lower", "upper", "offset")))
ANGLES = tuple((kin(name), name) for name in ("alpha", "beta", "gamma"))
MASSES = (body("mass"), inertia("mass"))


class Quantities:
    """Numbers of a model in SI units."""

    def __init__(self, scan: PredicateIndex, units: Units) -> None:
        self.scan = scan
        self.units = units

    @cached_property
    def _positional(self) -> frozenset[Term]:
        """Nodes whose x, y and z are lengths: coordinates of positions and poses."""
        own = frozenset[Term]().union(*map(self.scan.instances, POSITIONAL))
        of = self.scan.table(COORDINATE_OF).items()
        return own | {node for node, relations in of if not own.isdisjoint(relations)}

    @cached_property
    def components(self) -> Mapping[str, Mapping[Term, float]]:
        """Components x, y and z of each node, in SI units."""
        return {axis: dict(self._along(coord(axis))) for axis in AXES}

    def _along(self, axis: Term) -> Iterator[tuple[Term, float]]:
        positional, units = self._positional, self.units
        for node, number in self.scan.numbers(axis).items():
            only = units.measuring(node, LENGTH) if node in positional else units.only(node)
            if only is not None and math.isfinite(value := only.si(number)):
                yield node, value

    @cached_property
    def vectors(self) -> Mapping[Term, Vector]:
        """Vectors of the nodes that have all of x, y and z, in SI units."""
        x, y, z = (self.components[axis] for axis in AXES)
        return {node: (x[node], y[node], z[node]) for node in x if node in y and node in z}

    @cached_property
    def plain(self) -> Mapping[Term, Vector]:
        """Vectors of the nodes that name no unit, as they are."""
        x, y, z = (self.scan.numbers(coord(axis)) for axis in AXES)
        return {
            node: (x[node], y[node], z[node])
            for node in x
            if node in y and node in z and not self.units.has(node)
        }

    @cached_property
    def angles(self) -> Mapping[str, Mapping[Term, float]]:
        """Euler angles of each node, in rad."""
        found: dict[str, dict[Term, float]] = {}
        for predicate, name in ANGLES:
            found[name] = {}
            for node, number in self.scan.numbers(predicate).items():
                unit = self.units.measuring(node, ANGLE)
                if unit is not None and math.isfinite(angle := unit.si(number)):
                    found[name][node] = angle
        return found

    @cached_property
    def masses(self) -> Mapping[Term, float]:
        """Mass of each node, in kg; the number as it is where a node names no unit at all."""
        found: dict[Term, float] = {}
        for predicate in MASSES:
            for node, number in self.scan.numbers(predicate).items():
                unit = self.units.measuring(node, MASS)
                if unit is not None or not self.units.has(node):
                    found[node] = unit.si(number) if unit else number
        return found

    @cached_property
    def values(self) -> Sequence[tuple[Term, str, float]]:
        """Plain values of quantities, limits and couplings, each with its node and name."""
        return [
            (node, name, unit.si(number))
            for predicate, name in VALUES
            for node, number in self.scan.numbers(predicate).items()
            if (unit := self.units.only(node)) is not None
        ]


def stated(
    vectors: Quantities, angles: Quantities, masses: Quantities, values: Quantities
) -> Iterator[Triple]:
    """Yield all quantities, each of the part that is named after them."""
    for tables in (vectors.components, angles.angles):
        for name, table in tables.items():
            for node, number in table.items():
                yield from numbers(node, [(name, number)])
    for node, number in masses.masses.items():
        if masses.units.has(node):
            yield from numbers(node, [("mass", number)])
    for node, name, number in values.values:
        yield from numbers(node, [(name, number)])
