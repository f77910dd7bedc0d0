"""Motion that each joint of a tree allows: where it is on both bodies, and along which axis.

The pose of a child at position q, as its parent sees it, is placement, motion by q, rest. What the
model leaves open is named, never assumed; but attachments without a zero configuration coincide at
zero (paper, section II-C).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

from kinlint.facts.body_frames import BodyFrames, Transform
from kinlint.facts.fact_statements import fact
from kinlint.facts.frame_placement import Placements
from kinlint.facts.joint_meetings import COINCIDENT, OF_JOINT, JointMeetings, Meeting
from kinlint.facts.joint_numbers import DIRECTION
from kinlint.facts.joint_trees import Edge, arrange_joints
from kinlint.facts.linear_algebra import ZERO, Vector, apply, cross, length, scale, transpose
from kinlint.facts.mechanism import Mechanism
from kinlint.facts.metamodel_terms import AS_SEEN_BY, chain, kin
from kinlint.facts.spatial_relations import SpatialRelations
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term, Triple, literal

AXIAL = kin("AxialJoint")
FIRST_AXIS = kin("first-axis")
OFFSET = chain("origin-offset")
ATTACHMENT, PARENT, CHILD = "a frame on each of two bodies", "parent", "child"
AXIS, ZERO_CONFIGURATION = "the direction of its axis", "a zero configuration"
SHIFT, ALONG = "the numbers of its offset", "an offset along its common axis"
OFF = 1e-6
"""Distance in m beyond which two lines are not one."""


@dataclass(frozen=True, slots=True)
class JointMotion:
    """Joint of a tree, with what moves by it."""

    edge: Edge
    """Joint with the bodies at its ends, the parent nearer to the root."""
    placement: Transform
    """Pose of its frame on the parent."""
    zero: Transform
    """Pose of the frame on the child in that on the parent, at zero."""
    rest: Transform
    """Pose of the child in the frame of the joint, at zero."""
    axis: Vector | None
    """Unit vector in the frame of the joint along which, or about which, it moves."""
    turned: bool
    """True if the model counts the motion of the parent, as the child sees it."""


class JointMotions:
    """Joints of a closed model, each with its motion or with what is missing to tell it."""

    def __init__(
        self, mechanism: Mechanism, relations: SpatialRelations, placements: Placements
    ) -> None:
        self.scan = mechanism.scan
        self.mechanism = mechanism
        self.relations = relations
        self.placements = placements
        self.frames = BodyFrames(mechanism, relations, placements)
        self.trees = arrange_joints(mechanism.bodies, mechanism.edges)
        self._meetings = JointMeetings(mechanism, self.trees.edges)

    @cached_property
    def in_tree_order(self) -> Sequence[Edge]:
        """The joints of all trees, each behind the one that carries it; none that close loops."""
        below: dict[Term, list[Edge]] = {}
        for each in self.trees.edges:
            if each.parent is not None and not each.closes:
                below.setdefault(each.parent, []).append(each)
        found: list[Edge] = []
        waiting = [
            each for root in reversed(self.trees.roots) for each in below.get(root, ())[::-1]
        ]
        while waiting:
            edge = waiting.pop()
            found.append(edge)
            waiting += below.get(edge.child or "", ())[::-1]
        return found

    @cached_property
    def roots(self) -> Sequence[Term]:
        """The roots of trees that have joints."""
        carrying = {each.parent for each in self.trees.edges}
        return [root for root in self.trees.roots if root in carrying]

    @cached_property
    def _written(self) -> Mapping[Term, Edge]:
        return {each.joint: each for each in self.mechanism.edges}

    @cached_property
    def _met(self) -> Mapping[Term, Meeting]:
        return {each.joint: each for each in self._meetings.all}

    @cached_property
    def _lacking(self) -> dict[Term, list[str]]:
        """Return the lacks of each joint whose motion was asked for."""
        return {}

    def motion(self, edge: Edge) -> JointMotion | None:
        """Return the motion of a joint; None where the model does not determine it."""
        self._lacking[edge.joint] = list(self._missing(edge))
        meeting = self._met.get(edge.joint)
        if self._lacking[edge.joint] or meeting is None or not edge.parent or not edge.child:
            return None
        near = self.frames.pose(edge.parent, meeting.near)
        far = self.frames.pose(edge.child, meeting.far)
        assert near is not None
        assert far is not None
        shift = self._shift(meeting)
        zero = Transform(meeting.turn, shift or ZERO)
        axis = self._axis(edge, meeting) if self._is_axial(edge.joint) else None
        turned = self._written[edge.joint].parent != edge.parent
        return JointMotion(edge, near, zero, zero * far.inverse(), axis, turned)

    def _missing(self, edge: Edge) -> Iterator[str]:
        meeting = self._met.get(edge.joint)
        if meeting is None or edge.others or not edge.parent or not edge.child:
            yield ATTACHMENT
            return
        for body, end, side in (
            (edge.parent, meeting.near, PARENT),
            (edge.child, meeting.far, CHILD),
        ):
            if self.frames.pose(body, end) is None:
                yield f"the pose of its frame on the {side}"
        shift = self._shift(meeting)
        if shift is None:
            yield SHIFT
        if self._is_axial(edge.joint):
            if (axis := self._axis(edge, meeting)) is None:
                yield AXIS
            elif self._ends_on_axis(meeting) and length(cross(axis, shift or ZERO)) > OFF:
                yield ALONG
        if not self._zero_is_drawn(meeting):
            yield ZERO_CONFIGURATION

    def _ends_on_axis(self, meeting: Meeting) -> bool:
        """Tell whether the common axis runs through the origins of both attachments."""
        drawn = (self._meetings.basis.get(each) for each in self._meetings.lines(meeting.joint))
        return {meeting.near, meeting.far} <= {each[0] for each in drawn if each is not None}

    def _is_axial(self, joint: Term) -> bool:
        return joint in self.scan.instances(AXIAL)

    def _shift(self, meeting: Meeting) -> Vector | None:
        """Return the vector in m between the attachments at zero; None if it is not usable."""
        point = self.relations.point
        near, far = point(meeting.near), point(meeting.far)
        stated = set(self.scan.table(OFFSET).values(meeting.joint))
        for each in self.relations.shifts:
            if each.relation not in stated:
                continue
            if each.vector == ZERO:
                return ZERO
            forward = (each.base, each.of) == (near, far)
            if not forward and (each.of, each.base) != (near, far):
                return None
            seen = scale(1.0 if forward else -1.0, each.vector)
            if each.seen_by == self.relations.axes(meeting.near):
                return seen
            if each.seen_by == self.relations.axes(meeting.far):
                return apply(meeting.turn, seen)
            return None
        return ZERO

    def _zero_is_drawn(self, meeting: Meeting) -> bool:
        """Tell whether all vectors that coincide at zero are axes of the two attachments."""
        ends = {meeting.near, meeting.far, *map(self.relations.point, (meeting.near, meeting.far))}
        for node, joints in self.scan.table(OF_JOINT).items():
            if meeting.joint in joints:
                for each in self.scan.table(COINCIDENT).values(node):
                    drawn = self._meetings.basis.get(each)
                    if each not in ends and (drawn is None or drawn[0] not in ends):
                        return False
        return True

    def _axis(self, edge: Edge, meeting: Meeting) -> Vector | None:
        if (written := self.placements.axes.get(edge.joint)) is not None:
            return written
        lines = self._meetings.lines(edge.joint)
        stated = [self.scan.single(each).get(edge.joint) for each in (DIRECTION, FIRST_AXIS)]
        told = [each for each in stated if each is not None] or sorted(lines)
        for each in told:
            if (found := self._direction(each)) is None:
                continue
            frame, vector = found
            for body, end, near in (
                (edge.parent, meeting.near, True),
                (edge.child, meeting.far, False),
            ):
                own, home = self.frames.turn(body or "", frame), self.frames.turn(body or "", end)
                if (
                    self.mechanism.carrier.get(frame) == body
                    and own is not None
                    and home is not None
                ):
                    seen = apply(transpose(home), apply(own, vector))
                    return seen if near else apply(meeting.turn, seen)
        return None

    def _direction(self, vector: Term) -> tuple[Term, Vector] | None:
        """Return the frame that sees *vector*, and its components there, of length 1."""
        if (drawn := self._meetings.basis.get(vector)) is not None:
            return drawn
        frame = self.scan.single(AS_SEEN_BY).get(vector)
        written = self.relations.quantities.plain.get(vector)
        written = written or self.relations.quantities.vectors.get(vector)
        if frame is None or written is None or not (size := length(written)) > 0.0:
            return None
        return frame, scale(1.0 / size, written)

    def facts(self) -> Iterator[Triple]:
        """Yield what keeps the joints from being one tree whose motions are known."""
        for each in self.trees.edges:
            if each.closes:
                yield each.joint, fact("closes-loop"), literal("true")
            elif self.motion(each) is None:
                for lack in self._lacking[each.joint]:
                    yield each.joint, fact("lacks"), literal(lack)
        for root in self.roots[1:]:
            yield root, fact("tree-beside"), self.roots[0]
