"""Joints on the left and the right of a robot, compared as they are drawn with all joints at zero.

A robot is taken as symmetric about the plane that most of its pairs of left and right joints mirror
each other in. Each step from the frame of the parent to the joint is compared alone, along the axes
of the root, so that what hangs below a misplaced joint is not misplaced, too.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import NamedTuple

from kinlint.facts.fact_statements import fact, numbers
from kinlint.facts.frame_placement import OWN, PARENT_ATTACHMENT, Placements
from kinlint.facts.joint_numbers import JointNumbers
from kinlint.facts.joint_trees import Edge
from kinlint.facts.laterality import counterpart, is_left
from kinlint.facts.linear_algebra import (
    IDENTITY,
    Matrix,
    Vector,
    apply,
    cross,
    dot,
    length,
    product,
    subtract,
    transpose,
)
from kinlint.facts.link_trees import LinkTrees
from kinlint.facts.metamodel_terms import kin
from kinlint.facts.mirror_symmetry import split_name, twin_of
from kinlint.terms import Term, Triple

CHILD_ATTACHMENT = kin("child-attachment")
TURNING = frozenset(("revolute", "continuous"))
MOVING = TURNING | {"prismatic"}
OF_MUJOCO = {"hinge": "revolute", "slide": "prismatic"}
STEPS = ("step-x", "step-y", "step-z")
ALIKE = 0.9
"""The least cosine of the angle between two axes of one sense."""
NEAR = 1e-3
"""Distance in m up to which joints count as placed alike: drawings are rounded to a millimetre."""
SHARE = 0.02
"""The part of a length up to which two count as equal."""
PARALLEL = 0.02
"""Sine of the angle in rad up to which axes count as parallel."""
PAIRS = 2
"""The fewest other pairs that make a robot symmetric."""
FEW = 0.34
"""The part of the pairs that may not mirror each other in a robot that is still symmetric."""


class Drawn(NamedTuple):
    """Joint at zero, along the axes of the root of its robot."""

    edge: Edge
    """Joint itself, with its parent and its child."""
    step: Vector
    """From the origin of its parent to its own, in m."""
    axis: Vector | None
    """Unit vector about which, or along which, it moves."""


class DrawnSymmetry:
    """Joints of each robot of XML whose counterparts are drawn otherwise. Takes linear time."""

    def __init__(self, trees: LinkTrees, placements: Placements, numbers: JointNumbers) -> None:
        self.trees = trees
        self.numbers = numbers
        self.placements = placements

    def facts(self) -> Iterator[Triple]:
        """Yield the joints that are not mirrored, or that cross sides."""
        for robot, edges in self.trees.robots.items():
            drawn = self.robots[robot]
            yield from self._unmirrored(drawn)
            yield from self._crossing(edges)

    @cached_property
    def robots(self) -> Mapping[Term, Mapping[Term, Drawn]]:
        """Joints of each robot whose axes at zero are known."""
        return {robot: self._drawn(edges) for robot, edges in self.trees.robots.items()}

    def axis_on_child(self, edge: Edge) -> Vector | None:
        """Return the axis of a joint as its child sees it."""
        axis = self.placements.axes.get(edge.joint)
        return None if axis is None else apply(self._end(edge), axis)

    def _drawn(self, edges: Sequence[Edge]) -> dict[Term, Drawn]:
        """Return the joints whose axes at zero are known."""
        turns: dict[Term, Matrix | None] = {}
        return {
            edge.joint: Drawn(edge, apply(turn, at[0]), self._axis(edge, turn, at[1]))
            for edge in edges
            if edge.parent is not None
            and (turn := self._turn(edge.parent, turns)) is not None
            and (at := self._origin(edge)) is not None
        }

    def _turn(self, body: Term, known: dict[Term, Matrix | None]) -> Matrix | None:
        """Return the rotation from the axes of *body* to those of the root."""
        way: list[Edge] = []
        at = body
        while at not in known and (edge := self.trees.above.get(at)) is not None:
            known[at] = None
            way.append(edge)
            if edge.parent is None:
                return None
            at = edge.parent
        known.setdefault(at, IDENTITY)
        for edge in reversed(way):
            above, origin = known[at], self._origin(edge)
            at = edge.child or at
            if above is not None and origin is not None:
                known[at] = product(product(above, origin[1]), transpose(self._end(edge)))
        return known[body]

    def _origin(self, edge: Edge) -> tuple[Vector, Matrix] | None:
        """Return the point in m and the rotation of a joint, as its parent sees them."""
        frame = self._near.get(edge.joint)
        if frame is None or edge.parent is None:
            return None
        at = self.placements.placement_on(frame, edge.parent)
        return None if at is None or at.point is None else (at.point, at.turn or IDENTITY)

    def _end(self, edge: Edge) -> Matrix:
        """Return the rotation of a joint as its child sees it."""
        frame = self._far.get(edge.joint)
        if frame is None or edge.child is None:
            return IDENTITY
        return (self.placements.placement_on(frame, edge.child) or OWN).turn or IDENTITY

    @cached_property
    def _near(self) -> Mapping[Term, Term]:
        return self.trees.scan.single(PARENT_ATTACHMENT)

    @cached_property
    def _far(self) -> Mapping[Term, Term]:
        return self.trees.scan.single(CHILD_ATTACHMENT)

    def _axis(self, edge: Edge, turn: Matrix, own: Matrix) -> Vector | None:
        axis = self.placements.axes.get(edge.joint)
        return None if axis is None else apply(turn, apply(own, axis))

    def _unmirrored(self, drawn: Mapping[Term, Drawn]) -> Iterator[Triple]:
        """Yield the joints on the left whose steps or axes are no mirror images of the right."""
        pairs = list(self.pairs(drawn))
        plane = plane_of(pairs)
        fits = [_is_mirrored(*pair, plane) for pair in pairs]
        good = [pair for pair, fit in zip(pairs, fits, strict=True) if fit]
        evident = [pair for pair in good if abs(pair[0].step[plane]) > NEAR]
        beside = {body for pair in evident for body in pair[0].edge.ends}
        symmetric = len(good) >= PAIRS and len(pairs) - len(good) <= FEW * len(pairs)
        for pair, fit in zip(pairs, fits, strict=True):
            left, right = pair
            one = left.edge.parent == right.edge.parent
            if fit:
                if pair in evident or (symmetric and (one or left.edge.parent in beside)):
                    yield from self._turned(left, right, plane)
            elif symmetric and evident and self._carries_motion(left.edge):
                ends = {end for end in left.edge.ends if end not in beside}
                if not _is_turned(left, right, plane) and (
                    one or not ends or not _is_moved(left, right)
                ):
                    yield left.edge.joint, fact("unmirrored"), right.edge.joint
                    for each in pair:
                        yield from numbers(each.edge.joint, zip(STEPS, each.step, strict=True))

    def _carries_motion(self, edge: Edge) -> bool:
        """Tell whether a joint moves, or carries a joint that does."""
        return self.kind(edge.joint) in MOVING or edge.child in self._driven

    @cached_property
    def _driven(self) -> frozenset[Term]:
        return frozenset(
            edge.parent
            for edges in self.trees.robots.values()
            for edge in edges
            if edge.parent is not None and self.kind(edge.joint) in MOVING
        )

    def pairs(self, drawn: Mapping[Term, Drawn]) -> Iterator[tuple[Drawn, Drawn]]:
        """Yield the joints of the left with those of the right, by name or by those of bodies."""
        above = self.trees.above
        carrying = {body: drawn[above[body].joint] for body in above if above[body].joint in drawn}
        for joint, left in drawn.items():
            right = drawn.get(twin_of(joint, drawn) or "")
            body = left.edge.child
            if right is None and body is not None and above[body].joint == joint:
                right = carrying.get(twin_of(body, carrying) or "")
            if right is not None and self.kind(joint) == self.kind(right.edge.joint):
                yield left, right

    def _turned(self, left: Drawn, right: Drawn, plane: int) -> Iterator[Triple]:
        """Yield how the axes of two mirrored joints differ, if they are no mirror images."""
        joint, other = left.edge.joint, right.edge.joint
        if left.axis is None or right.axis is None or self.kind(joint) not in MOVING:
            return
        if length(cross(_mirrored(left.axis, plane), right.axis)) > PARALLEL:
            yield joint, fact("axis-unmirrored"), other
            return
        along = dot(_mirrored(left.axis, plane), right.axis)
        sense = along if self.kind(joint) == "prismatic" else -along
        (low, high), (least, most) = (
            self.numbers.limits.get(each, (None, None)) for each in (joint, other)
        )
        if low is None or high is None or least is None or most is None or not low < high:
            return
        slack = SHARE * (high - low)
        equal = abs(low - least) <= slack and abs(high - most) <= slack
        opposite = abs(low + most) <= slack and abs(high + least) <= slack
        if equal not in (opposite, sense > 0.0):
            yield joint, fact("moves-unlike"), other

    def kind(self, joint: Term) -> str:
        """Return the type of *joint*, in the words of URDF."""
        kind = self.trees.mechanism.kind(joint)
        return OF_MUJOCO.get(kind, kind)

    def _crossing(self, edges: Sequence[Edge]) -> Iterator[Triple]:
        """Yield the joints that hang a body of one side on a body of the other."""
        bodies = {body for edge in edges for body in edge.ends}
        above = {edge.joint: edge.parent for edge in edges}
        for edge in edges:
            if edge.parent is None or edge.child is None:
                continue
            other = _across(edge.joint)
            if above.get(other) != edge.parent:
                continue
            name = split_name(edge.parent)[1]
            own = {is_left(split_name(each)[1]) for each in (edge.joint, edge.child)}
            proper = _across(edge.parent)
            if own in ({True}, {False}) and is_left(name) not in (None, *own) and proper in bodies:
                yield edge.joint, fact("hangs-across"), edge.parent
                yield edge.joint, fact("own-side"), proper


def _across(node: Term) -> Term:
    """Return what *node* would be called on the other side."""
    space, name = split_name(node)
    return f"{space}{counterpart(name)}>"


def plane_of(pairs: Sequence[tuple[Drawn, Drawn]]) -> int:
    """Return the axis across which most *pairs* are mirrored: of several, that of REP 103."""
    return max((1, 0, 2), key=lambda at: sum(_is_mirrored(*pair, at) for pair in pairs))


def _is_mirrored(left: Drawn, right: Drawn, plane: int) -> bool:
    slack = NEAR + SHARE * length(left.step)
    return length(subtract(_mirrored(left.step, plane), right.step)) <= slack


def _is_moved(left: Drawn, right: Drawn) -> bool:
    """Tell whether both steps are equal, as in whole hands that are mounted twice."""
    return length(subtract(left.step, right.step)) <= NEAR + SHARE * length(left.step)


def _is_turned(left: Drawn, right: Drawn, plane: int) -> bool:
    """Tell whether the right step is the left one after half a turn, as of hands mounted so."""
    turned = (_mirrored(_mirrored(left.step, plane), at) for at in range(3) if at != plane)
    slack = NEAR + SHARE * length(left.step)
    return any(length(subtract(each, right.step)) <= slack for each in turned)


def _mirrored(vector: Vector, plane: int) -> Vector:
    """Return the mirror image of *vector* in the plane across an axis."""
    x, y, z = (-each if at == plane else each for at, each in enumerate(vector))
    return x, y, z
