"""Placements of frames on their own body, through any number of spatial relations."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property

from kinlint.facts.frame_placement import Placements
from kinlint.facts.linear_algebra import (
    IDENTITY,
    ZERO,
    Matrix,
    Vector,
    add,
    apply,
    product,
    subtract,
    transpose,
)
from kinlint.facts.mechanism import Mechanism
from kinlint.facts.orientation_graph import OrientationGraph
from kinlint.facts.spanning_forest import SpanningForest
from kinlint.facts.spatial_relations import RelativeOrientation, RelativePosition, SpatialRelations
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term


@dataclass(frozen=True, slots=True)
class Transform:
    """Rigid motion: the pose of one frame as another one sees it."""

    turn: Matrix = IDENTITY
    """Rotation from components along the placed axes to those along the axes that see them."""
    point: Vector = ZERO
    """Origin in m."""

    def __mul__(self, other: Transform) -> Transform:
        """Return the composition: the pose *other*, seen by what sees this one."""
        point = add(apply(self.turn, other.point), self.point)
        return Transform(product(self.turn, other.turn), point)

    def inverse(self) -> Transform:
        """Return the pose of what sees this one, seen by it."""
        back = transpose(self.turn)
        return Transform(back, subtract(ZERO, apply(back, self.point)))


class BodyFrames:
    """Frames of bodies, each seen by the frame that its body is described in.

    Nothing is assumed: what no relation between parts of the body places is nowhere.
    """

    def __init__(
        self, mechanism: Mechanism, relations: SpatialRelations, placements: Placements
    ) -> None:
        self.mechanism = mechanism
        self.relations = relations
        self.placements = placements

    def on_one_body(self, each: RelativeOrientation | RelativePosition) -> bool:
        """Tell whether *each* relates two parts of one body."""
        relation = each.relation
        return self._together(self.relations.base[relation], self.relations.of[relation])

    def _together(self, one: Term, other: Term) -> bool:
        carrier = self.mechanism.carrier
        return one in carrier and carrier[one] == carrier.get(other)

    @cached_property
    def references(self) -> Mapping[Term, Term]:
        """Frame that each body is described in: its own, or else the one that others relate to."""
        found: dict[Term, Term] = {}
        for body, frames in self.mechanism.frames.items():
            own = (each for each in frames if self.placements.is_own(each, body))
            if (frame := next(own, None)) is not None:
                found[body] = frame
        known = frozenset(each for frames in self.mechanism.frames.values() for each in frames)
        for base, of in self._related:
            if base in known and self._together(base, of):
                found.setdefault(self.mechanism.carrier[base], base)
        for body, frames in self.mechanism.frames.items():
            found.setdefault(body, frames[0])
        return found

    @cached_property
    def _related(self) -> Sequence[tuple[Term, Term]]:
        shifts = {each.relation for each in self.relations.shifts}
        return [(self.relations.base[each], self.relations.of[each]) for each in sorted(shifts)]

    @cached_property
    def orientations(self) -> OrientationGraph:
        """Axes of each body, seen by each other."""
        return OrientationGraph([each for each in self.relations.turns if self.on_one_body(each)])

    @cached_property
    def _shifts(self) -> Sequence[RelativePosition]:
        """Positions on one body, seen by axes whose orientation on it is known."""
        axes, group = self.relations.axes, self.orientations.group
        found: list[RelativePosition] = []
        for each in self.relations.shifts:
            body = self.mechanism.carrier.get(self.relations.base[each.relation], "")
            home = self.references.get(body)
            placed = home is not None and self.on_one_body(each)
            if placed and group(each.seen_by) == group(axes(home or "")):
                found.append(each)
        return found

    @cached_property
    def _points(self) -> tuple[Mapping[Term, Vector], SpanningForest]:
        """Points along the axes that stand for those of their body, and how they hang together."""
        shifts = self._shifts
        forest = SpanningForest([(each.base, each.of) for each in shifts])
        places: dict[Term, Vector] = {}
        for node in forest.order:
            if node not in forest.parent:
                places[node] = ZERO
                continue
            above, index = forest.parent[node]
            each = shifts[index]
            step = apply(self.orientations.matrix(each.seen_by), each.vector)
            places[node] = (add if each.of == node else subtract)(places[above], step)
        return places, forest

    def point(self, body: Term, node: Term) -> Vector | None:
        """Return where the point or frame *node* is on *body*, in m; None if that is unknown."""
        if (home := self.references.get(body)) is None:
            return None
        base, end = self.relations.point(home), self.relations.point(node)
        if base == end:
            return ZERO
        places, forest = self._points
        if base not in places or forest.root[base] != forest.root.get(end):
            return None
        turn = transpose(self.orientations.matrix(self.relations.axes(home)))
        return apply(turn, subtract(places[end], places[base]))

    def turn(self, body: Term, frame: Term) -> Matrix | None:
        """Return the rotation of the axes of *frame* on *body*; None if that is unknown."""
        if (home := self.references.get(body)) is None:
            return None
        return self.orientations.between(self.relations.axes(home), self.relations.axes(frame))

    def pose(self, body: Term, frame: Term) -> Transform | None:
        """Return the pose of *frame* on *body*; None if that is unknown."""
        turn, point = self.turn(body, frame), self.point(body, frame)
        return None if turn is None or point is None else Transform(turn, point)
