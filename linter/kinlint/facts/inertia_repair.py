"""Numbers that wrong moments and products of inertia were probably meant to be."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from decimal import Decimal
from itertools import count

from kinlint.facts.assembly import Assemblies
from kinlint.facts.body_shapes import BOX, CYLINDER, SPHERE, BodyShapes, Shape
from kinlint.facts.fact_statements import double, fact, fact_node
from kinlint.facts.frame_placement import OWN, Placements
from kinlint.facts.inertia import MOMENTS, PRODUCTS, Inertias, about_origin
from kinlint.facts.linear_algebra import Matrix, eigenvalues
from kinlint.facts.metamodel_terms import body, kin
from kinlint.facts.metamodel_terms import inertia as inertial
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.terms import Term, Triple

PLACES = range(1, 10)
"""Places by which a decimal point is tried elsewhere.

Further ones lie beyond any robot's inertia.
"""
CLEAR = 1.1
"""Least ratio of the greatest moment to the sum of the others at which a slip of the point is
sought: less is an inequality that rounding or measurement may have broken.
"""
WATER = 1000.0
"""The density of water in kg/m³."""
DIGITS = 6
"""Significant digits that a computed number is written with, as URDF exporters do."""

Entries = dict[Term, float]
"""Moments and products by the property that states them, xx yy zz xy xz yz, in one unit."""


class InertiaRepairs:
    """Replacements for entries of tensors, each kind of change where only one is possible."""

    def __init__(
        self,
        scan: PredicateIndex,
        inertias: Inertias,
        assemblies: Assemblies,
        geometries: BodyShapes,
        placements: Placements,
    ) -> None:
        self.scan = scan
        self.inertias = inertias
        self.assemblies = assemblies
        self.geometries = geometries
        self.placements = placements

    def decimal_slips(self) -> Iterator[Triple]:
        """Yield the one entry whose decimal point stands in the wrong place, if that is all.

        That is so where exactly one power of ten, at exactly one entry, makes an impossible tensor
        one that a body can have.
        """
        numbers = count(1)
        for node, entries in self._stated():
            values = list(entries.values())
            least, middle, greatest = eigenvalues(_matrix(values))
            if min(values[:3]) <= 0.0 or greatest <= CLEAR * (least + middle):
                continue
            found = [
                (entry, moved)
                for at, (entry, value) in enumerate(entries.items())
                for moved in (_shifted(value, by * sign) for by in PLACES for sign in (1, -1))
                if value and _possible([*values[:at], moved, *values[at + 1 :]])
            ]
            if len(found) == 1:
                yield from _amended(node, "decimal-slip", entries, dict(found), numbers)

    def sign_slips(self) -> Iterator[Triple]:
        """Yield the signs that turn an impossible tensor into that of a body.

        Those of all moments that are negative, or those of all three products: of two products they
        make no difference, and of one the same as of three.
        """
        numbers = count(1)
        for node, entries in self._stated():
            if _possible(list(entries.values())):
                continue
            items = list(entries.items())
            changes = (
                {entry: -value for entry, value in items[:3] if value < 0.0},
                {entry: -value for entry, value in items[3:] if all(each for _, each in items[3:])},
            )
            found = [each for each in changes if _possible(list({**entries, **each}.values()))]
            if len(found) == 1:
                yield from _amended(node, "sign-slip", entries, found[0], numbers)

    def solids(self) -> Iterator[Triple]:
        """Yield the tensor of each body of one primitive about its centre, if it were solid."""
        numbers = count(1)
        for node, entries in self._stated():
            weighed = self.assemblies.weighed(node) if node in self.inertias.central else None
            shape = self.geometries.sole(weighed[0]) if weighed is not None else None
            if weighed is None or shape is None:
                continue
            owner, mass = weighed
            here = self.placements.inertial(owner)
            there = self.placements.shape_placement(shape.node)
            if here is not None and here.is_at(there):
                tensor = (*solid_moments(shape, mass), 0.0, 0.0, 0.0)
                changed = dict(zip(entries, _rounded(tensor), strict=False))
                yield from _amended(node, "solid", entries, changed, numbers)

    def filled(self) -> Iterator[Triple]:
        """Yield the mass and moments of each body of one primitive, at the density of water.

        Only where all visual and collision shapes are the same, in the frame of the link.
        """
        known, bodies = self.scan.instances(kin("MassProperty")), self.scan.single(kin("of-body"))
        weighed = {owner for node, owner in bodies.items() if node in known}
        for owner, nodes in sorted(self.geometries.references.items()):
            shape = self.geometries.uniform(owner) if owner not in weighed else None
            places = map(self.placements.shape_placement, nodes)
            if shape is None or not all(map(OWN.is_at, places)):
                continue
            mass = WATER * shape.volume
            moments = solid_moments(shape, mass)
            if math.isfinite(sum((mass, *moments))) and min(mass, *moments) > 0.0:
                values = (*_rounded([mass]), *_rounded(moments))
                for name, value in zip(("mass", *MOMENTS), values, strict=True):
                    yield owner, fact(f"water-{name}"), double(value)

    def shifts(self) -> Iterator[Triple]:
        """Yield each tensor moved from the origin of its link to the centre of mass."""
        numbers = count(1)
        for node, entries in self._stated():
            owner = self.assemblies.body(node)
            centre = self.placements.centres.get(owner) if owner is not None else None
            if owner is None or centre is None or owner in self.placements.turned:
                continue
            moved = about_origin(self.assemblies.masses.get(owner, 0.0), centre)
            flat = (*(moved[at][at] for at in range(3)), moved[0][1], moved[0][2], moved[1][2])
            values = list(entries.values())
            left = [value - away for value, away in zip(values, flat, strict=False)]
            if any(flat) and len(left) == len(flat) and _possible(left):
                # What the shift leaves of a number is as exact as the number was.
                changed = dict(zip(entries, _rounded(left, max(map(abs, values))), strict=True))
                yield from _amended(node, "shift", entries, changed, numbers)

    def _stated(self) -> Iterator[tuple[Term, Entries]]:
        """Yield the entries of each tensor as they are written.

        Products that are not count as zero.
        """
        axes = [inertial(name) for name in (*MOMENTS, *PRODUCTS)]
        principal = [body(name) for name in ("xx", "yy", "zz")]
        for node in sorted(self.inertias.tensors):
            names = axes if node in self.scan.numbers(axes[0]) else principal
            entries = {name: self.scan.numbers(name).get(node, 0.0) for name in names}
            if all(map(math.isfinite, entries.values())):
                yield node, entries


def _amended(
    node: Term, kind: str, entries: Entries, changed: Mapping[Term, float], numbers: Iterator[int]
) -> Iterator[Triple]:
    """Yield that *node* could have the numbers of *changed*, where they are not those it has."""
    for entry, value in changed.items():
        if value != entries[entry]:
            amended = fact_node(kind, next(numbers))
            yield node, fact(kind), amended
            yield amended, fact("entry"), entry
            yield amended, fact("amended"), double(value)


def _shifted(value: float, places: int) -> float:
    return float(Decimal(repr(value)).scaleb(places))


def _matrix(values: Sequence[float]) -> Matrix:
    xx, yy, zz, xy, xz, yz = (*values, 0.0, 0.0, 0.0)[:6]
    return (xx, xy, xz), (xy, yy, yz), (xz, yz, zz)


def _possible(values: Sequence[float]) -> bool:
    """Tell whether a body that extends in space can have these moments and products.

    The triangle inequality may be missed by one percent, the rounding of two digits; an eigenvalue
    below 1e-9 of the greatest is zero but for the rounding of doubles.
    """
    least, middle, greatest = eigenvalues(_matrix(values))
    return least > 1e-9 * greatest and least + middle >= 0.99 * greatest


def solid_moments(shape: Shape, mass: float) -> tuple[float, float, float]:
    """Return the principal moments of a solid of uniform density about its centre, in kg m².

    Source: https://en.wikipedia.org/wiki/List_of_moments_of_inertia; a capsule is a cylinder
    between two halves of a ball, whose mass counts by their volumes.
    """
    kind, sizes = shape.kind, shape.sizes
    if kind == BOX:
        x, y, z = (each * each * mass / 12.0 for each in sizes)
        return y + z, x + z, x + y
    radius = sizes[0]
    ball = 0.4 * mass * radius**2
    if kind == SPHERE:
        return ball, ball, ball
    long = sizes[1]
    round_, turned = mass * radius**2 / 2.0, mass * (3.0 * radius**2 + long**2) / 12.0
    if kind == CYLINDER:
        return turned, turned, round_
    share = 4.0 * radius / (4.0 * radius + 3.0 * long)
    ends = ball + mass * (long**2 / 4.0 + 3.0 * long * radius / 8.0)
    across = (1.0 - share) * turned + share * ends
    return across, across, (1.0 - share) * round_ + share * ball


def _rounded(values: Sequence[float], size: float = 0.0) -> list[float]:
    """Return *values* to `DIGITS` significant digits of the greatest of them, or of *size*."""
    size = size or max(map(abs, values))
    decimals = DIGITS - 1 - math.floor(math.log10(size)) if size > 0.0 else DIGITS
    return [round(each, decimals) + 0.0 for each in values]
