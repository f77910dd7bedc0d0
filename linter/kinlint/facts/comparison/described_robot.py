"""Robots as numbers: rigid groups of bodies, and the joints that move these against each other.

Frames are as the file chose them; a comparison has to align them first. All numbers are in SI
units, as they are with all joints at zero.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import NamedTuple

from kinlint.facts.comparison.pose import HERE, Pose
from kinlint.facts.joint_numbers import Gearing
from kinlint.facts.linear_algebra import Matrix, Vector, scale
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.terms import Term

HINGE = "revolute"


class Shape(NamedTuple):
    """Collision shape of a body."""

    node: Term
    """Node of the shape."""
    kind: str
    """Primitive, such as `box`, or `mesh`."""
    sizes: tuple[float, ...]
    """Edges of a box, else the radius and the length, in m; of a mesh, its scale."""
    pose: Pose
    """Pose as its group sees it."""
    file: str = ""
    """Name of the file of a mesh, without folders and suffix, in lower case."""


@dataclass(frozen=True)
class Body:
    """Rigid body."""

    node: Term
    """Body itself."""
    name: str
    """Name in the file."""
    pose: Pose = HERE
    """Pose of its frame as its group sees it."""
    mass: float | None = None
    """Mass in kg; None if none is stated."""
    centre: Vector | None = None
    """Centre of mass in m, as its group sees it."""
    tensor: Matrix | None = None
    """Inertia in kg m² about the centre of mass, along the axes of its group."""
    mass_node: Term | None = None
    """Node that states the mass."""
    inertia_node: Term | None = None
    """Node that states the inertia."""
    shapes: tuple[Shape, ...] = ()
    """Collision shapes."""

    @property
    def is_solid(self) -> bool:
        """Tell whether the body has a mass or a shape."""
        return bool(self.mass or self.shapes)


@dataclass(frozen=True)
class Group:
    """Bodies that no joint moves against each other; the first one lends them its frame."""

    bodies: tuple[Body, ...]
    """Bodies of the group."""

    @property
    def main(self) -> Body:
        """The first body that has a mass or a shape, else the first."""
        solid = (body for body in self.bodies if body.mass is not None or body.shapes)
        return next(solid, self.bodies[0])

    @property
    def name(self) -> str:
        """Name of the main body."""
        return self.main.name

    def body(self, node: Term | None) -> Body | None:
        """Return the body with this node."""
        return next((body for body in self.bodies if body.node == node), None)

    @cached_property
    def shapes(self) -> tuple[Shape, ...]:
        """Collision shapes of all bodies."""
        return tuple(shape for body in self.bodies for shape in body.shapes)


@dataclass(frozen=True)
class MovingJoint:
    """Joint that is not fixed, between two groups."""

    node: Term
    """Joint itself."""
    name: str
    """Name in the file."""
    kind: str
    """Kind of the movement, such as `revolute`."""
    parent: int
    """Index of the group that carries it; -1 if none is stated."""
    child: int
    """Index of the group that it moves; -1 if none is stated."""
    transform: Pose
    """Pose of the child as the parent sees it, at zero."""
    anchor: Vector
    """Origin of the joint in m, as the child sees it."""
    axis: Vector | None
    """Unit vector of the axis, as the child sees it."""
    lower: float | None = None
    """Least position in rad or m; None if there is no bound."""
    upper: float | None = None
    """Greatest position in rad or m."""
    effort: float | None = None
    """Greatest force in N or torque in N m; None if none is stated."""
    speed: float | None = None
    """Greatest speed in m/s or rad/s; None if none is stated."""
    limit_node: Term | None = None
    """Node of the range."""
    bodies: tuple[Term | None, Term | None] = (None, None)
    """Bodies of the parent and of the child that it joins."""
    closes: bool = False
    """True if its child is carried by another joint, so that it closes a loop."""
    gearing: Gearing | None = None
    """Dependency on another joint; None if none is stated."""
    is_point: bool = False
    """True if the format closes loops at points only, and knows no axis for that."""

    @property
    def is_complete(self) -> bool:
        """Tell whether both of its bodies are stated."""
        return self.parent >= 0 and self.child >= 0

    def completed_by(self, other: MovingJoint) -> MovingJoint:
        """Return the joint, with the movement of hinge *other* if it is but a point of a loop."""
        if not self.is_point or other.kind != HINGE:
            return self
        return replace(self, kind=other.kind, lower=other.lower, upper=other.upper)

    @property
    def mirrored(self) -> MovingJoint:
        """The same joint with its positions counted the other way."""
        return replace(self, axis=None if self.axis is None else scale(-1.0, self.axis))

    @property
    def reversed(self) -> MovingJoint:
        """The same joint, seen from its child: its position counts as before."""
        back = self.transform.inverse
        axis = None if self.axis is None else scale(-1.0, self.transform.along(self.axis))
        anchor = self.transform.at(self.anchor)
        return replace(
            self,
            parent=self.child,
            child=self.parent,
            transform=back,
            anchor=anchor,
            axis=axis,
            bodies=self.bodies[::-1],
        )


@dataclass(frozen=True)
class DescribedRobot:
    """Robot as one description has it."""

    form: str
    """Name of the file format."""
    groups: Sequence[Group] = ()
    """Rigid groups."""
    joints: Sequence[MovingJoint] = ()
    """Joints that move, and those that close loops, whatever their kind."""
    fixed: Mapping[str, Term] = field(default_factory=dict)
    """Fixed joints by the name of the body that they hold."""
    floating: Mapping[str, Term] = field(default_factory=dict)
    """Joints that leave a body free in the world, by their names."""

    @cached_property
    def body_names(self) -> frozenset[str]:
        """Names of all bodies."""
        return frozenset(body.name for _, body in self.bodies())

    @cached_property
    def around(self) -> Sequence[Sequence[int]]:
        """Indices of the joints at each group."""
        found: list[list[int]] = [[] for _ in self.groups]
        for index, joint in enumerate(self.joints):
            if joint.is_complete:
                found[joint.parent].append(index)
                found[joint.child].append(index)
        return found

    @cached_property
    def roots(self) -> Sequence[int]:
        """Indices of the groups that no joint moves, those with most joints in their tree first."""
        moved = {joint.child for joint in self.joints if not joint.closes}
        free = [index for index in range(len(self.groups)) if index not in moved]
        return sorted(free, key=lambda index: (-self.sizes[index], index))

    @cached_property
    def sizes(self) -> Sequence[int]:
        """Number of joints below each group."""
        found = [0] * len(self.groups)
        for joint in reversed(self.downward):
            found[joint.parent] += found[joint.child] + 1
        return found

    @cached_property
    def downward(self) -> Sequence[MovingJoint]:
        """Joints of the trees, each after the one that carries its parent."""
        below: list[list[MovingJoint]] = [[] for _ in self.groups]
        moved = set()
        for joint in self.joints:
            if joint.is_complete and not joint.closes:
                below[joint.parent].append(joint)
                moved.add(joint.child)
        waiting = [index for index in range(len(self.groups)) if index not in moved]
        found: list[MovingJoint] = []
        for group in waiting:
            found += below[group]
            waiting += [joint.child for joint in below[group]]
        return found

    def seen_from(self, joint: int, group: int) -> MovingJoint:
        """Return the joint with this index such that *group* is its parent."""
        own = self.joints[joint]
        return own if own.parent == group else own.reversed

    def bodies(self) -> Iterator[tuple[int, Body]]:
        """Yield all bodies with the index of their group."""
        for index, group in enumerate(self.groups):
            for body in group.bodies:
                yield index, body
