"""Poses of frames on their bodies and directions of joint axes, as the lifted model states them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import NamedTuple

from kinlint.document import FROM
from kinlint.facts.linear_algebra import ZERO, Vector, length, scale
from kinlint.facts.metamodel_terms import OF, WITH_RESPECT_TO, body, coord, geom, kin
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.terms import Term

OF_POSE = coord("of-pose")
XYZ = (coord("x"), coord("y"), coord("z"))
ANGLES = (kin("alpha"), kin("beta"), kin("gamma"))
QUATERNION = (kin("qx"), kin("qy"), kin("qz"))
PARENT_ATTACHMENT = kin("parent-attachment")
DIRECTIONS = (kin("positive-direction"), kin("first-axis"))
ABOUT, OF_BODY, ORIGIN = body("about"), body("of-body"), geom("origin")
ATTACHED_TO = kin("attached-to")
NEEDED = (
    *(OF, WITH_RESPECT_TO, OF_POSE, *XYZ, *ANGLES, *QUATERNION, PARENT_ATTACHMENT, *DIRECTIONS),
    *(ABOUT, OF_BODY, ORIGIN, ATTACHED_TO, geom("simplices"), geom("Frame")),
)
"""The properties and classes that placements are read from."""


class Placement(NamedTuple):
    """Pose of a frame, as another one sees it."""

    base: Term
    """The frame that sees it."""
    point: Vector | None
    """Its origin in m; None where none is stated, or a malformed one."""
    turn: tuple[float, ...] | None
    """Its angles as they stand, or the x, y, z of its quaternion; None where neither is stated."""
    by_angles: bool
    """True if `turn` holds angles."""


class Placements:
    """The placements of lifted frames, by joint, body or shape; those of other models are none.

    Of a frame with several, the first counts. A quaternion counts less than angles.
    """

    def __init__(self, scan: PredicateIndex) -> None:
        self.scan = scan

    @cached_property
    def _poses(self) -> Mapping[Term, Term]:
        """The pose of each lifted frame."""
        lifted = self.scan.table(FROM)
        poses = sorted(self.scan.single(OF).items(), reverse=True)
        return {frame: pose for pose, frame in poses if pose in lifted}

    @cached_property
    def _points(self) -> Mapping[Term, Vector]:
        return {pose: (x, y, z) for pose, (x, y, z) in self._stated(XYZ)}

    @cached_property
    def _angles(self) -> Mapping[Term, Sequence[float]]:
        return dict(self._stated(ANGLES))

    @cached_property
    def _quaternions(self) -> Mapping[Term, Sequence[float]]:
        return dict(self._stated(QUATERNION))

    def _stated(self, names: Sequence[Term]) -> Iterator[tuple[Term, Sequence[float]]]:
        """Yield the numbers that coordinates of each pose have for three components."""
        pose_of = self.scan.single(OF_POSE)
        first, *others = (self.scan.numbers(each) for each in names)
        for node, number in first.items():
            if node in pose_of and all(node in each for each in others):
                yield pose_of[node], (number, *(each[node] for each in others))

    def placement(self, frame: Term) -> Placement | None:
        """Return where *frame* is; None if that is not stated."""
        pose = self._poses.get(frame)
        base = self.scan.single(WITH_RESPECT_TO).get(pose) if pose is not None else None
        if pose is None or base is None:
            return None
        by_angles = pose in self._angles
        turn = self._angles.get(pose) or self._quaternions.get(pose)
        return Placement(base, self._points.get(pose), tuple(turn) if turn else None, by_angles)

    def is_own(self, frame: Term, owner: Term) -> bool:
        """Tell whether *frame* is the one that the body *owner* is described in."""
        sources = self.scan.table(FROM)
        return bool(sources.values(frame)) and sources.values(frame) == sources.values(owner)

    def placement_on(self, frame: Term, owner: Term) -> Placement | None:
        """Return where *frame* is as the body *owner* sees it; None if something else sees it."""
        if self.is_own(frame, owner):
            return Placement(frame, ZERO, ZERO, by_angles=True)
        found = self.placement(frame)
        return found if found is not None and self.is_own(found.base, owner) else None

    @cached_property
    def origins(self) -> Mapping[Term, Vector]:
        """The place of each joint in m, as the link that carries it sees it."""
        near = self.scan.single(PARENT_ATTACHMENT).items()
        placed = ((joint, self.placement(frame)) for joint, frame in near)
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
        """Pose of the frame whose origin is the centre of mass, by body."""
        frames = {point: frame for frame, point in self.scan.single(ORIGIN).items()}
        centres = self.scan.single(ABOUT)
        found: dict[Term, Placement] = {}
        for inertia, owner in self.scan.single(OF_BODY).items():
            frame = frames.get(centres.get(inertia, ""))
            at = self.placement(frame) if frame is not None else None
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
        placed = self._inertial.items()
        return frozenset(owner for owner, at in placed if at.turn is None or any(at.turn))

    def shape_placement(self, node: Term) -> Placement | None:
        """Return where the shape *node* is, as its body sees it; None if that is not stated."""
        frame, owner = (self.scan.single(each).get(node) for each in (ATTACHED_TO, kin("of-body")))
        return self.placement_on(frame, owner) if frame is not None and owner is not None else None
