"""Placements of frames on bodies, in SI units, and directions of joint axes.

A frame is where a pose, or a position and an orientation, says that it is. However they are written
(other units, Euler angles, quaternions, direction cosines), rules and pictures see one point in m
and one rotation matrix: SPARQL has neither sine nor cosine, so this is computed here, once for all.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cached_property
from typing import NamedTuple, TypeVar

from kinlint.document import FROM
from kinlint.facts.linear_algebra import IDENTITY, ZERO, Matrix, Vector, length, scale
from kinlint.facts.metamodel_terms import body, coord, geom, kin
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.spatial_relations import (
    RelativeOrientation,
    RelativePosition,
    SpatialRelations,
)
from kinlint.terms import Term

XYZ = (coord("x"), coord("y"), coord("z"))
PARENT_ATTACHMENT, PARENT_BODY = kin("parent-attachment"), kin("parent-body")
DIRECTIONS = (kin("positive-direction"), kin("first-axis"))
ABOUT, OF_BODY, ORIGIN = body("about"), body("of-body"), geom("origin")
ATTACHED_TO = kin("attached-to")
NEEDED = (
    *(PARENT_ATTACHMENT, PARENT_BODY, *DIRECTIONS, ABOUT, OF_BODY, ORIGIN, ATTACHED_TO),
    *(kin("of-body"), geom("simplices"), geom("Frame")),
)
"""Properties and classes that placements are read from, besides spatial relations."""

Relation = TypeVar("Relation", RelativePosition, RelativeOrientation)


class Placement(NamedTuple):
    """Pose of a frame, as a body sees it."""

    point: Vector | None
    """Its origin in m; None where none is stated, or a malformed one."""
    turn: Matrix | None
    """Rotation from its components to those of the body; None where no rotation is stated."""
    turn_from: Term | None = None
    """Coordinates that state the rotation."""

    def is_at(self, other: Placement | None) -> bool:
        """Tell whether both are known to be the same pose."""
        known = other is not None and self.point is not None and self.turn is not None
        return known and other is not None and self[:2] == other[:2]


OWN = Placement(ZERO, IDENTITY)
"""Placement of the frame that a body is described in."""


class Placements:
    """Placements of a closed model; those by joint, body or shape are of lifted ones.

    Of a frame with several relations to frames of one body, the first counts.
    """

    def __init__(self, scan: PredicateIndex, relations: SpatialRelations) -> None:
        self.scan = scan
        self.relations = relations

    @cached_property
    def _shifts(self) -> Mapping[Term, list[RelativePosition]]:
        return _by_end(self.relations.shifts)

    @cached_property
    def _turns(self) -> Mapping[Term, list[RelativeOrientation]]:
        return _by_end(self.relations.turns)

    def placement(self, frame: Term, sees: Callable[[Term], bool]) -> Placement | None:
        """Return where *frame* is for what *sees* a base and a frame on it; None if unstated."""
        base = self.relations.base
        shifts = self._shifts.get(self.relations.point(frame), ())
        turns = self._turns.get(self.relations.axes(frame), ())
        points = (
            each.vector for each in shifts if sees(base[each.relation]) and sees(each.seen_by)
        )
        point = next(points, None)
        turn = next((each for each in turns if sees(each.base)), None)
        if turn is not None:
            return Placement(point, turn.matrix, turn.source)
        return Placement(point, None) if point is not None else None

    def is_own(self, frame: Term, owner: Term) -> bool:
        """Tell whether *frame* is the one that the lifted body *owner* is described in.

        Its address is that of the body with `/frame`; of one body there may be further frames that
        were lifted from the same element, such as that of an inertia that follows from shapes.
        """
        return frame == f"{owner[:-1]}/frame>" and frame in self.scan.table(FROM)

    def placement_on(self, frame: Term, owner: Term) -> Placement | None:
        """Return where *frame* is as the lifted body *owner* sees it; None if that is unstated."""
        if self.is_own(frame, owner):
            return OWN
        return self.placement(frame, lambda base: self.is_own(base, owner))

    @cached_property
    def origins(self) -> Mapping[Term, Vector]:
        """The place of each joint in m, as the link that carries it sees it."""
        carriers = self.scan.single(PARENT_BODY)
        placed = (
            (joint, self.placement_on(frame, carriers[joint]))
            for joint, frame in self.scan.single(PARENT_ATTACHMENT).items()
            if joint in carriers
        )
        return {joint: at.point for joint, at in placed if at is not None and at.point is not None}

    @cached_property
    def axes(self) -> Mapping[Term, Vector]:
        """The direction of the axis of each joint, in its own frame; of length 1."""
        components = [self.scan.numbers(each) for each in XYZ]
        found: dict[Term, Vector] = {}
        for name in reversed(DIRECTIONS):
            for joint, axis in self.scan.single(name).items():
                x, y, z = (each.get(axis, 0.0) for each in components)
                if axis in self.scan.table(FROM) and (size := length((x, y, z))) > 0.0:
                    found[joint] = scale(1.0 / size, (x, y, z))
        return found

    @cached_property
    def _inertial(self) -> Mapping[Term, Placement]:
        """Placement of the frame whose origin is the centre of mass, by body."""
        frames = {point: frame for frame, point in self.scan.single(ORIGIN).items()}
        centres = self.scan.single(ABOUT)
        found: dict[Term, Placement] = {}
        for inertia, owner in self.scan.single(OF_BODY).items():
            frame = frames.get(centres.get(inertia, ""))
            at = self.placement_on(frame, owner) if frame is not None else None
            if at is not None:
                found[owner] = at
        return found

    def inertial(self, owner: Term) -> Placement | None:
        """Return where the frame that sees the inertia of a body is, as the body sees it."""
        return self._inertial.get(owner)

    @cached_property
    def centres(self) -> Mapping[Term, Vector]:
        """The centre of mass of each body in m, as the body sees it."""
        return {owner: at.point for owner, at in self._inertial.items() if at.point is not None}

    @cached_property
    def turned(self) -> frozenset[Term]:
        """The bodies whose inertia is seen along other axes than theirs, or may be."""
        return frozenset(owner for owner, at in self._inertial.items() if at.turn != IDENTITY)

    def shape_placement(self, node: Term) -> Placement | None:
        """Return where the shape *node* is, as its body sees it; None if that is not stated."""
        frame, owner = (self.scan.single(each).get(node) for each in (ATTACHED_TO, kin("of-body")))
        return self.placement_on(frame, owner) if frame is not None and owner is not None else None


def _by_end(relations: tuple[Relation, ...]) -> Mapping[Term, list[Relation]]:
    """Return the relations of each point, or of the axes of each frame."""
    found: dict[Term, list[Relation]] = {}
    for each in relations:
        found.setdefault(each.of, []).append(each)
    return found
