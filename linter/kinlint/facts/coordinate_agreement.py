"""Comparison of several coordinates of one relation, after change of unit and frame."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Container, Iterator, Mapping, Sequence
from functools import cached_property, partial
from itertools import chain, count
from typing import TypeAlias

from kinlint.facts.fact_statements import derived, fact, fact_node, numbers
from kinlint.facts.inertia import Inertias
from kinlint.facts.linear_algebra import (
    Matrix,
    Vector,
    angle,
    apply,
    length,
    product,
    scale,
    subtract,
    transpose,
)
from kinlint.facts.metamodel_terms import coord, qudt
from kinlint.facts.metamodel_terms import inertia as inertial
from kinlint.facts.orientation_graph import OrientationGraph
from kinlint.facts.spatial_relations import SpatialRelations
from kinlint.facts.units import (
    ACCELERATION,
    ANGULAR_ACCELERATION,
    ANGULAR_SPEED,
    FORCE,
    LENGTH,
    SPEED,
    TORQUE,
)
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import RDF_TYPE, Term, Triple, literal

LISTS = (
    (coord("angular-velocity"), ANGULAR_SPEED),
    (coord("linear-velocity"), SPEED),
    (coord("angular-acceleration"), ANGULAR_ACCELERATION),
    (coord("linear-acceleration"), ACCELERATION),
    (inertial("force"), FORCE),
    (inertial("torque"), TORQUE),
)
FIRST_MOMENT_OF_MASS = inertial("first-moment-of-mass")
MOMENTS = inertial("ixx")
MASS = inertial("mass")
NORM = literal("norm")


FEW = 2
"""Of two coordinates that differ, neither can be told to be the wrong one."""

PLACE = ""
"""Quantity that poses and positions state, which needs no name."""

Values: TypeAlias = list[tuple[str, float]]


@dataclass
class Comparison:
    """Differences between two coordinates of one relation, by the names of their facts."""

    values: Values = field(default_factory=list)
    """Names of the facts, such as `distance` and `angle` in SI units, with their numbers."""
    norm_only: bool = False
    """True if only norms of vectors were compared, as no orientation is known."""


@dataclass(frozen=True)
class Pair:
    """Two coordinates of a relation that state the same quantity."""

    node: Term
    """Fact node of the comparison."""
    relation: Term
    """Relation that both are coordinates of."""
    quantity: Term
    """Property that states the quantity; `PLACE` for positions and orientations."""
    first: Term
    """Coordinates that others are compared with."""
    second: Term
    """Coordinates that are compared."""
    found: Comparison
    """Differences between both."""
    alone: bool
    """True if no other coordinates of the relation state the quantity."""


class CoordinateAgreements:
    """Agreement of the coordinates of each relation, each compared with one of the first two."""

    def __init__(
        self, relations: SpatialRelations, orientations: OrientationGraph, inertias: Inertias
    ) -> None:
        self.relations = relations
        self.orientations = orientations
        self.inertias = inertias

    def facts(self) -> Iterator[Triple]:
        """Yield a fact node for each two coordinates and each quantity that both state."""
        for pair in self.pairs():
            yield pair.node, RDF_TYPE, fact("Agreement")
            yield pair.node, fact("of"), pair.relation
            yield pair.node, fact("first"), pair.first
            yield pair.node, fact("second"), pair.second
            if pair.quantity != PLACE:
                yield pair.node, fact("quantity"), pair.quantity
            if pair.found.norm_only:
                yield pair.node, fact("compared"), NORM
            yield from numbers(pair.node, pair.found.values)
            yield from derived(pair.node, [pair.first, pair.second])

    def pairs(self) -> Iterator[Pair]:
        """Yield the coordinates that are compared, two by two, with the fact node for them."""
        names = count(1)
        for relation, nodes in self.relations.coordinates.items():
            if len(nodes) == 1:
                continue
            compared = self._compared(relation, nodes)
            times = Counter(quantity for quantity, _, _ in compared)
            for (quantity, first, second), found in compared.items():
                node, alone = fact_node("agreement", next(names)), times[quantity] == 1
                yield Pair(node, relation, quantity, first, second, found, alone)

    def _compared(
        self, relation: Term, nodes: Sequence[Term]
    ) -> Mapping[tuple[Term, Term, Term], Comparison]:
        found: dict[tuple[Term, Term, Term], Comparison] = {}

        for quantity, table in self._vectors.items():
            for pair, each in _compared(nodes, table, partial(self._vector, relation, table)):
                found[quantity, *pair] = each
        proper, tensors = self.relations.rotations.proper, self.inertias.tensors
        for pair, each in _compared(nodes, proper, partial(self._rotation, relation)):
            found.setdefault((PLACE, *pair), Comparison()).values += each.values
        for pair, each in _compared(nodes, tensors, partial(self._tensor, relation)):
            found[MOMENTS, *pair] = each
        for quantity, scalars in self._scalars.items():
            for pair, each in _compared(nodes, scalars, partial(_scalar, scalars)):
                found[quantity, *pair] = each
        return found

    def _vector(
        self, relation: Term, table: Mapping[Term, Vector], first: Term, second: Term
    ) -> Comparison:
        """Return the distance between two vectors, or that of their norms if no frame is shared."""
        a, b = table[first], table[second]
        magnitude = ("magnitude", max(length(a), length(b)))
        turn = self.turn(relation, first, second)
        if turn is None:
            apart = abs(length(a) - length(b))
            return Comparison([("distance", apart), magnitude], norm_only=True)
        return Comparison([("distance", length(subtract(a, apply(turn, b)))), magnitude])

    def _rotation(self, relation: Term, first: Term, second: Term) -> Comparison:
        """Return the angle between two orientations, if both are with respect to one frame."""
        proper, relations = self.relations.rotations.proper, self.relations
        one, other = (relations.seen_by(node, relation) for node in (first, second))
        if one is None or one != other:
            return Comparison()
        return Comparison([("angle", angle(product(transpose(proper[first]), proper[second])))])

    def _tensor(self, relation: Term, first: Term, second: Term) -> Comparison:
        """Return the largest difference of two tensors' entries, and the largest entry of both."""
        turn = self.turn(relation, first, second)
        if turn is None:
            return Comparison()
        a, b = self.inertias.tensors[first], self.inertias.tensors[second]
        b = product(product(turn, b), transpose(turn))
        entries = list(zip(chain(*a), chain(*b), strict=True))
        apart = max(abs(x - y) for x, y in entries)
        return Comparison(
            [("distance", apart), ("magnitude", max(max(abs(x), abs(y)) for x, y in entries))]
        )

    def turn(self, relation: Term, first: Term, second: Term) -> Matrix | None:
        """Return the rotation of components of coordinates *second* into those of *first*."""
        one, other = (self.relations.seen_by(node, relation) for node in (first, second))
        return None if one is None or other is None else self.orientations.between(one, other)

    @cached_property
    def _vectors(self) -> Mapping[Term, Mapping[Term, Vector]]:
        found = {PLACE: self.relations.quantities.vectors}
        found[FIRST_MOMENT_OF_MASS] = self.inertias.first_moments
        for predicate, dimension in LISTS:
            found[predicate] = {
                node: scale(unit.factor, (row[0], row[1], row[2]))
                for node, row in self.relations.scan.lists(predicate, 3).items()
                if (unit := self.inertias.units.measuring(node, dimension)) is not None
            }
        return {quantity: table for quantity, table in found.items() if len(table) > 1}

    @cached_property
    def _scalars(self) -> Mapping[Term, Mapping[Term, float]]:
        scan, units = self.relations.scan, self.inertias.units
        values = scan.numbers(qudt("value"))
        distances = {
            node: unit.si(values[node])
            for node in scan.instances(coord("LinearDistanceCoordinate"))
            if node in values and (unit := units.measuring(node, LENGTH)) is not None
        }
        return {MASS: self.inertias.quantities.masses, qudt("value"): distances}


def _scalar(table: Mapping[Term, float], first: Term, second: Term) -> Comparison:
    a, b = table[first], table[second]
    return Comparison([("distance", abs(a - b)), ("magnitude", max(abs(a), abs(b)))])


def _compared(
    nodes: Sequence[Term], table: Container[Term], compare: Callable[[Term, Term], Comparison]
) -> Iterator[tuple[tuple[Term, Term], Comparison]]:
    """Yield one of *nodes* with each of the others in *table*, where they can be compared.

    That is the first; of three and more, the second if it differs less from most.
    """
    stating = [node for node in nodes if node in table]
    one, other = (_star(stating, index, compare) for index in range(2))
    nearer = other if len(stating) > FEW and _median(other) < _median(one) else one
    yield from ((pair, found) for pair, found in nearer if found.values)


def _star(
    stating: Sequence[Term], index: int, compare: Callable[[Term, Term], Comparison]
) -> list[tuple[tuple[Term, Term], Comparison]]:
    """Return the comparisons of the node at *index* with each of the others, unless it is alone."""
    if len(stating) <= max(index, 1):
        return []
    first = stating[index]
    return [((first, node), compare(first, node)) for node in stating if node != first]


def _median(star: Sequence[tuple[tuple[Term, Term], Comparison]]) -> float:
    differences = sorted(found.values[0][1] for _, found in star if found.values)
    return differences[(len(differences) - 1) // 2] if differences else math.inf
