"""Robots as numbers, read from what is lifted of files or stated by composable models."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import PurePosixPath
from typing import NamedTuple
from urllib.parse import unquote

from kinlint.addresses import local_name
from kinlint.facts.assembly import Assemblies
from kinlint.facts.body_shapes import BodyShapes
from kinlint.facts.comparison.described_robot import (
    Body,
    DescribedRobot,
    Group,
    MovingJoint,
    Shape,
)
from kinlint.facts.comparison.pose import HERE, Pose
from kinlint.facts.frame_placement import ATTACHED_TO, Placements
from kinlint.facts.inertia import Inertias
from kinlint.facts.joint_numbers import JointNumbers
from kinlint.facts.joint_trees import Edge, arrange_joints
from kinlint.facts.linear_algebra import IDENTITY, Vector, length
from kinlint.facts.mechanism import Mechanism
from kinlint.facts.metamodel_terms import AS_SEEN_BY, kin
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.spanning_forest import DisjointSets
from kinlint.facts.spatial_relations import SpatialRelations
from kinlint.facts.zero_configuration import ZeroConfiguration
from kinlint.light_dataclasses import replace
from kinlint.terms import Term, iri, is_iri
from kinlint.vocabulary import SRC

FLOATING = "floating"
PAIR = 2
FROM, TIED = iri(f"{SRC}from"), iri(f"{SRC}firstBody")
AXIAL = frozenset({"revolute", "prismatic", "cylindrical", "helical", "planar"})
"""Movements that have one axis, or one normal."""


class RobotParts(NamedTuple):
    """Facts of a closed model that its robots are read from."""

    scan: PredicateIndex
    """Statements of the model."""
    mechanism: Mechanism
    """Bodies and joints."""
    relations: SpatialRelations
    """Spatial relations with numbers."""
    placements: Placements
    """Poses of frames on their bodies."""
    joints: JointNumbers
    """Axes and limits of joints."""
    inertias: Inertias
    """Moments of inertia."""
    assemblies: Assemblies
    """Masses of bodies."""
    geometries: BodyShapes
    """Shapes of bodies."""


class RobotExtraction:
    """Descriptions of robots in a closed model."""

    def __init__(self, parts: RobotParts) -> None:
        self.scan = parts.scan
        self.parts = parts

    @cached_property
    def edges(self) -> Sequence[Edge]:
        """Joints of the model with their bodies, arranged in trees."""
        mechanism = self.parts.mechanism
        return arrange_joints(mechanism.bodies, mechanism.edges).edges

    @cached_property
    def _zero(self) -> ZeroConfiguration:
        parts = self.parts
        return ZeroConfiguration(parts.mechanism, parts.relations, parts.placements, self.edges)

    def robot(self, form: str, bodies: Iterable[Term], joints: Iterable[Term]) -> DescribedRobot:
        """Return the robot of *bodies* and *joints*, described in the format called *form*.

        A joint that leaves a body free in the world is left out, as is a second one of a body
        that ties it to another tree, whose place is unknown.
        """
        known = frozenset(joints)
        every = [each for each in self.edges if each.joint in known]
        edges = [each for each in every if not each.closes]
        trees = DisjointSets()
        for parent, child in (each.ends for each in edges if len(each.ends) == PAIR):
            trees.join(parent, child)
        loops = {
            each.joint
            for each in every
            if each.closes and len({trees.representative(end) for end in each.ends}) == 1
        }
        movement = self.parts.mechanism.movement
        moving = [
            each
            for each in every
            if each.joint in loops
            or (not each.closes and movement(each.joint) not in {"fixed", FLOATING})
        ]
        fixed = [each for each in edges if movement(each.joint) == "fixed"]
        welded = DisjointSets()
        for each in fixed:
            if each.parent is not None and each.child is not None:
                welded.join(each.parent, each.child)
        members: dict[Term, list[Term]] = {}
        ends = (end for each in edges for end in (each.parent, each.child) if end is not None)
        for body in dict.fromkeys((*bodies, *ends)):
            members.setdefault(welded.representative(body), []).append(body)
        carried = {each.child for each in fixed}
        groups = [sorted(each, key=lambda body: body in carried) for each in members.values()]
        number = {body: index for index, group in enumerate(groups) for body in group}
        frames = [self._body_pose(group[0]) for group in groups]
        return DescribedRobot(
            form,
            [
                Group(tuple(self._body(body, frame) for body in group))
                for group, frame in zip(groups, frames, strict=True)
            ],
            list(self._moving(moving, number, frames)),
            {_name(each.child): each.joint for each in fixed if each.child is not None},
            {_name(each.joint): each.joint for each in edges if movement(each.joint) == FLOATING},
        )

    def _body_pose(self, body: Term) -> Pose:
        found = self._zero.body_pose(body)
        return HERE if found is None else Pose(*found)

    def _body(self, body: Term, frame: Pose) -> Body:
        """Return *body* as a group with *frame* sees it."""
        back = frame.inverse
        made = Body(
            body,
            _name(body),
            back.of(self._body_pose(body)),
            self.parts.assemblies.masses.get(body),
            shapes=tuple(self._shapes(body, back)),
        )
        centre = self._zero.centre(body)
        node = self._tensors.get(body)
        seen = self._frame_pose(node, AS_SEEN_BY, body) if node is not None else None
        return replace(
            made,
            centre=None if centre is None else back.at(centre),
            tensor=(
                None
                if seen is None or node is None
                else back.of(seen).tensor(self.parts.inertias.central[node])
            ),
            mass_node=self._weights.get(body),
            inertia_node=node,
        )

    @cached_property
    def _weights(self) -> Mapping[Term, Term]:
        """Node that states the mass of each body."""
        owner = self.parts.assemblies.body
        found = ((owner(node), node) for node in self.parts.inertias.quantities.masses)
        return {body: node for body, node in found if body is not None}

    @cached_property
    def _tensors(self) -> Mapping[Term, Term]:
        """Node that states the central inertia of each body; 1 kg m² is the default of SDF."""
        owner = self.parts.assemblies.body
        stated = self.parts.inertias.central.items()
        found = ((owner(node), node) for node, tensor in stated if tensor != IDENTITY)
        return {body: node for body, node in found if body is not None}

    def _frame_pose(self, node: Term, way: Term, body: Term) -> Pose | None:
        """Return the pose of the frame that *node* names by the property *way*."""
        frame = self.scan.single(way).get(node)
        found = self._zero.pose(frame, body) if frame is not None else None
        return None if found is None else Pose(*found)

    def _shapes(self, body: Term, back: Pose) -> Iterator[Shape]:
        geometries = self.parts.geometries
        scales = self._scales
        for node in sorted(geometries.references.get(body, ()), key=self.parts.mechanism.place):
            if not geometries.collides(node):
                continue
            pose = self._shape_pose(node, body)
            primitive = geometries.shape(node)
            if pose is None:
                continue
            if primitive is not None:
                kind = local_name(primitive.kind).lower()
                yield Shape(node, kind, primitive.sizes, back.of(pose))
            elif files := geometries.meshes(node):
                name = PurePosixPath(unquote(files[0][1:-1]).rpartition(":")[2]).stem.casefold()
                scale = scales.get(node, (1.0, 1.0, 1.0))
                yield Shape(node, "mesh", scale, back.of(pose), name)

    def _shape_pose(self, node: Term, body: Term) -> Pose | None:
        """Return the pose of the shape *node* of *body*, by relations on that body alone if any."""
        placed = self.parts.placements.shape_placement(node)
        if placed is None or placed.point is None or placed.turn is None:
            return self._frame_pose(node, ATTACHED_TO, body)
        return self._body_pose(body).of(Pose(placed.point, placed.turn))

    @cached_property
    def _origin(self) -> Mapping[Term, Term]:
        """Element from which each node is lifted."""
        return self.scan.single(FROM)

    @cached_property
    def _constraints(self) -> Mapping[Term, Term]:
        """Elements that tie two bodies without being a joint of their format."""
        return self.scan.single(TIED)

    @cached_property
    def _scales(self) -> Mapping[Term, tuple[float, ...]]:
        return self.scan.lists(kin("scale"), 3)

    def _moving(
        self, edges: Iterable[Edge], number: Mapping[Term, int], frames: Sequence[Pose]
    ) -> Iterator[MovingJoint]:
        numbers = self.parts.joints
        for each in edges:
            joint = each.joint
            parent, child = (number.get(end or "", -1) for end in (each.parent, each.child))
            near, far = (frames[end] if end >= 0 else HERE for end in (parent, child))
            back = far.inverse
            point = self._zero.child_point(each) or self._zero.joint_point(each)
            lower, upper = numbers.limits.get(joint, (None, None))
            kind = self.parts.mechanism.movement(joint)
            yield MovingJoint(
                joint,
                _name(joint),
                kind,
                parent,
                child,
                near.inverse.of(far),
                back.at(far.point if point is None else point),
                self._axis(each, back) if kind in AXIAL else None,
                lower,
                upper,
                numbers.efforts.get(joint),
                numbers.speeds.get(joint),
                numbers.ranges.get(joint),
                (each.parent, each.child),
                each.closes,
                next(iter(numbers.gearings.get(joint, ())), None),
                kind == "spherical" and self._origin.get(joint) in self._constraints,
            )

    def _axis(self, edge: Edge, back: Pose) -> Vector | None:
        """Return the axis of a joint as its child, which sees the root at *back*, sees it."""
        direction = self._zero.direction(edge)
        if direction is None or not 0.5 < length(direction) < 2.0:  # noqa: PLR2004
            return None
        return back.along(direction)


def _name(node: Term) -> str:
    return local_name(node) if is_iri(node) else node
