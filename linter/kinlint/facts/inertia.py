"""Principal moments of inertia, about the reference point of coordinates and the centre of mass."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from functools import cached_property
from itertools import chain

from kinlint.document import FROM
from kinlint.facts.coordinate_pairs import CoordinatePairs
from kinlint.facts.fact_statements import derived, numbers
from kinlint.facts.linear_algebra import (
    ZERO,
    Matrix,
    Vector,
    difference,
    dot,
    eigenvalues,
    length,
    scale,
)
from kinlint.facts.metamodel_terms import body
from kinlint.facts.metamodel_terms import inertia as inertial
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.quantity import Quantities
from kinlint.facts.units import FIRST_MOMENT, INERTIA, SI, Unit, Units
from kinlint.terms import Term, Triple

MOMENTS = ("ixx", "iyy", "izz")
PRODUCTS = ("ixy", "ixz", "iyz")


class Inertias:
    """Inertias of a model by coordinates node, in SI units where a unit is named."""

    def __init__(self, scan: PredicateIndex, units: Units, quantities: Quantities) -> None:
        self.scan = scan
        self.units = units
        self.quantities = quantities

    @cached_property
    def tensors(self) -> Mapping[Term, Matrix]:
        """Tensor in kg m² of each node that states three moments; products not stated are zero."""
        moments = {name: self.scan.numbers(inertial(name)) for name in (*MOMENTS, *PRODUCTS)}
        principal = [self.scan.numbers(body(name)) for name in ("xx", "yy", "zz")]
        found: dict[Term, Matrix] = {}
        for xx, yy, zz in (principal, [moments[name] for name in MOMENTS]):
            for node in xx:
                unit = self._unit(node, INERTIA)
                if unit is None or node not in yy or node not in zz or self._garbled(node):
                    continue
                x, y, z = (unit.si(each[node]) for each in (xx, yy, zz))
                xy, xz, yz = (unit.si(moments[name].get(node, 0.0)) for name in PRODUCTS)
                found[node] = ((x, xy, xz), (xy, y, yz), (xz, yz, z))
        return found

    @cached_property
    def principal(self) -> Mapping[Term, Vector]:
        """Principal moments of each of `tensors`, its eigenvalues, in ascending order."""
        return {node: eigenvalues(tensor) for node, tensor in self.tensors.items()}

    def _garbled(self, node: Term) -> bool:
        """Tell whether a product of inertia is stated that is not one number."""
        return any(
            node in self.scan.table(inertial(name))
            and node not in self.scan.numbers(inertial(name))
            for name in PRODUCTS
        )

    def _unit(self, node: Term, dimension: Term) -> Unit | None:
        """Return the unit of *dimension*; SI where none is named, None where several are."""
        if self.units.ambiguous(node, dimension):
            return None
        return self.units.measuring(node, dimension) or SI

    @cached_property
    def first_moments(self) -> Mapping[Term, Vector]:
        """First moment of mass of each node that states one, in kg m."""
        found: dict[Term, Vector] = {}
        for node, row in self.scan.lists(inertial("first-moment-of-mass"), 3).items():
            unit = self.units.measuring(node, FIRST_MOMENT)
            if unit is not None or not self.units.has(node):
                factor = unit.factor if unit else 1.0
                found[node] = scale(factor, (row[0], row[1], row[2]))
        return found

    @cached_property
    def central(self) -> Mapping[Term, Matrix]:
        """Tensors about the centre of mass, where that is known to be the point they are for.

        URDF and SDF know no other point, so what is lifted from them states no first moment.
        """
        moments = CoordinatePairs(self.scan).with_moment(self.first_moments)
        found: dict[Term, Matrix] = {}
        for node, tensor in self.tensors.items():
            shifted = moments.match(node)
            away = self.first_moments[shifted] if shifted is not None else None
            if away == ZERO or (away is None and node in self.scan.table(FROM)):
                found[node] = tensor
        return found

    def facts(self) -> Iterator[Triple]:
        """Yield the moments of each inertia, and those about its centre of mass where it is known.

        Rules test them for the triangle inequality: a rigid body of positive density has positive
        principal moments, none of which exceeds the sum of the others (Wensing, Kim and Slotine,
        Linear Matrix Inequalities for Physically-Consistent Inertial Parameter Identification,
        2018).
        """
        companions = CoordinatePairs(self.scan)
        masses = companions.with_mass(self.quantities.masses)
        moments = companions.with_moment(self.first_moments)
        for node, tensor in self.tensors.items():
            yield from _moments(node, tensor, self.principal[node], "moment")
            heavy, shifted = masses.match(node), moments.match(node)
            if heavy is None or not self._comparable(node, heavy):
                continue
            mass = self.quantities.masses[heavy]
            yield from numbers(node, [("body-mass", mass)])
            if heavy == node and not self.units.has(node):
                yield from numbers(node, [("mass", mass)])
            sources = {heavy} - {node}
            if shifted is not None and mass > 0.0 and self._comparable(node, shifted):
                centre = scale(1.0 / mass, self.first_moments[shifted])
                central = about_centre(tensor, mass, centre)
                yield from _moments(node, central, eigenvalues(central), "central-moment")
                yield from numbers(node, [("centre-distance", length(centre))])
                sources |= {shifted} - {node}
            yield from derived(node, sorted(sources))

    def _comparable(self, tensor: Term, other: Term) -> bool:
        """Tell whether both are in SI; of one node, that it names no unit at all will do."""
        known = self.units.measuring(tensor, INERTIA) is not None
        if tensor == other:
            return known or not self.units.has(tensor)
        return known and self.units.has(other)


def about_centre(tensor: Matrix, mass: float, centre: Vector) -> Matrix:
    """Return the tensor about the centre of mass, at *centre* from the point of *tensor*.

    By the parallel axis theorem of Huygens and Steiner, I_c = I_o - m (c·c 1 - c cᵀ) (Featherstone,
    Rigid Body Dynamics Algorithms, 2008, on rigid-body inertia).
    """
    return difference(tensor, about_origin(mass, centre))


def about_origin(mass: float, at: Vector) -> Matrix:
    """Return the tensor in kg m² of a point mass at *at*, about the origin: m (r·r 1 - r rᵀ)."""
    square = dot(at, at)
    x, y, z = (
        tuple(
            mass * ((square if row == column else 0.0) - at[row] * at[column])
            for column in range(3)
        )
        for row in range(3)
    )
    return (x[0], x[1], x[2]), (y[0], y[1], y[2]), (z[0], z[1], z[2])


def _moments(node: Term, tensor: Matrix, principal: Vector, kind: str) -> Iterator[Triple]:
    if all(map(math.isfinite, chain.from_iterable(tensor))):
        names = (f"{size}-{kind}" for size in ("least", "middle", "greatest"))
        yield from numbers(node, zip(names, principal, strict=True))
