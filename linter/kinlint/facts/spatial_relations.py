"""Spatial relations between frames and points, with their numbers (paper, section II-B)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property

from kinlint.facts.linear_algebra import Matrix, Vector
from kinlint.facts.metamodel_terms import (
    AS_SEEN_BY,
    COORDINATE_OF,
    OF,
    WITH_RESPECT_TO,
    geom,
    kin,
    rel,
)
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.quantity import Quantities
from kinlint.facts.rotation import Rotations
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term

POSE, POSITION, ORIENTATION = rel("Pose"), rel("Position"), rel("Orientation")


@dataclass(frozen=True, slots=True)
class RelativeOrientation:
    """Orientation: the rotation of components seen by frame `of` into those seen by `base`."""

    relation: Term
    """Relation that states it: a pose or an orientation."""
    base: Term
    """Axes that see it."""
    of: Term
    """Axes that are seen."""
    matrix: Matrix
    """Proper rotation from components along `of` to those along `base`."""
    source: Term
    """Coordinates that state the numbers."""


@dataclass(frozen=True, slots=True)
class RelativePosition:
    """Position: the vector in m from point `base` to point `of`, as frame `seen_by` sees it."""

    relation: Term
    """Relation that states it: a pose or a position."""
    base: Term
    """Point where the vector begins."""
    of: Term
    """Point where it ends."""
    vector: Vector
    """Components in m along the axes of `seen_by`."""
    seen_by: Term
    """Axes that see the vector."""
    source: Term
    """Coordinates that state the numbers."""


class SpatialRelations:
    """Relations of a model in the order of their files, and the coordinates with their numbers."""

    def __init__(self, scan: PredicateIndex, quantities: Quantities, rotations: Rotations) -> None:
        self.scan = scan
        self.quantities = quantities
        self.rotations = rotations
        self.of = scan.single(OF)
        self.base = scan.single(WITH_RESPECT_TO)

    @cached_property
    def coordinates(self) -> Mapping[Term, list[Term]]:
        """Coordinates of each relation; one that states numbers itself is the first of them."""
        stating = self.scan.instances(kin("Coordinate"))
        found: dict[Term, list[Term]] = {}
        for node, relation in self.scan.single(COORDINATE_OF).items():
            found.setdefault(relation, []).append(node)
        for relation, nodes in found.items():
            if len(nodes) > 1:
                nodes.sort(key=self.scan.place)
            if relation in stating and relation not in nodes:
                nodes.insert(0, relation)
        return found

    def seen_by(self, node: Term, relation: Term) -> Term | None:
        """Return the frame by which coordinates *node* are seen; None if that cannot be told."""
        stated = self.scan.table(AS_SEEN_BY).values(node)
        if stated:
            return self.axes(stated[0]) if len(stated) == 1 else None
        if relation in self._framed and relation in self.base:
            return self.axes(self.base[relation])
        return None

    @cached_property
    def _framed(self) -> frozenset[Term]:
        """Relations with respect to a frame, which sees them where no other is named."""
        return self.scan.instances(POSE) | self.scan.instances(ORIENTATION)

    def axes(self, frame: Term) -> Term:
        """Return the node for the axes of *frame*."""
        return self.scan.single(geom("rotation-frame")).get(frame, frame)

    def point(self, node: Term) -> Term:
        """Return the node for the position of a frame or a point."""
        return self.scan.single(geom("origin")).get(node, node)

    def _related(self, *kinds: Term) -> Iterator[tuple[Term, list[Term]]]:
        """Yield the relations of *kinds* between two things, with their coordinates."""
        nodes = frozenset[Term]().union(*map(self.scan.instances, kinds))
        both = (node for node in nodes if node in self.of and node in self.base)
        for relation in sorted(both, key=self.scan.place):
            if self.of[relation] != self.base[relation]:
                yield relation, self.coordinates.get(relation, [relation])

    @cached_property
    def turns(self) -> tuple[RelativeOrientation, ...]:
        """Orientations that coordinates state, the first usable ones of each relation."""
        return tuple(self._turns())

    def _turns(self) -> Iterator[RelativeOrientation]:
        stated = self.rotations.proper
        if not stated:
            return
        for relation, nodes in self._related(POSE, ORIENTATION):
            base, of = self.axes(self.base[relation]), self.axes(self.of[relation])
            for node in nodes:
                if node in stated and self.seen_by(node, relation) == base:
                    yield RelativeOrientation(relation, base, of, stated[node], node)
                    break

    @cached_property
    def shifts(self) -> tuple[RelativePosition, ...]:
        """Positions that coordinates state, the first usable ones of each relation."""
        return tuple(self._shifts())

    def _shifts(self) -> Iterator[RelativePosition]:
        stated = self.quantities.vectors
        if not stated:
            return
        for relation, nodes in self._related(POSE, POSITION):
            base, of = self.point(self.base[relation]), self.point(self.of[relation])
            for node in nodes:
                if node in stated and (seen_by := self.seen_by(node, relation)) is not None:
                    yield RelativePosition(relation, base, of, stated[node], seen_by, node)
                    break
