"""States what a stage says of robots: bodies, joints, shapes and masses, in SI."""

from __future__ import annotations

from math import isfinite, radians

from kinlint.errors import SourceError
from kinlint.formats.rigid_transform import Transform, between, composed
from kinlint.formats.usd.articulations import assemblies, cut_off, further_roots
from kinlint.formats.usd.colliders import shapes
from kinlint.formats.usd.joint_couplings import couplings
from kinlint.formats.usd.mass_properties import mass_properties
from kinlint.formats.usd.physics_joints import PhysicsJoint, Side, body_at, bound, is_body, joints
from kinlint.formats.usd.prim_transforms import PrimTransforms
from kinlint.formats.usd.stage import StagePrim
from kinlint.formats.usd.stage_statements import TRUE, StageStatements
from kinlint.formats.usd.usda_scanner import MOST
from kinlint.terms import Term

MOST_BODIES = MOST["rigid bodies"]
SLIDES = {"prismatic"}
MASSES = ("physics:mass", "physics:diagonalInertia", "physics:density", "physics:centerOfMass")
SIZES = ("size", "radius", "height", "points")
MOVES = {"revolute", "prismatic"}
DRIVE = "PhysicsDriveAPI"
SPEEDS = (
    "physxJointAxis:{}:maxJointVelocity",
    "physxJoint:maxJointVelocity",
    "newton:velocityLimit",
)
"""Attributes with the greatest speed of a joint, in degrees or lengths per second."""


class PhysicsStatements:
    """Statements about the robots of the stage that *about* states."""

    def __init__(self, about: StageStatements) -> None:
        self.about, self.stage, self.said = about, about.stage, about.said
        self.metres = self.stage.number("metersPerUnit", 0.01)
        self.kilograms = self.stage.number("kilogramsPerUnit", 1.0)
        self.transforms = PrimTransforms()

    def state(self) -> None:
        """State all bodies, and the joints that join two of them, or one and the world.

        Raises SourceError for too many bodies.
        """
        bodies = [each for each in self.stage.defined() if is_body(each)]
        if len(bodies) > MOST_BODIES:
            layer, prim = bodies[MOST_BODIES].opinions[0][1]
            source = layer.document.source
            cause = f"a stage of more than {MOST_BODIES} rigid bodies"
            raise SourceError(source.name, cause, *source.position(prim.name_span.start))
        for body in bodies:
            self.said.state(self.about.node(body), "rigidBody", TRUE)
            outer = body_at(body.parent) if body.parent is not None else None
            if outer is not None:
                self.said.state(self.about.node(body), "aroundBody", self.about.node(outer))
            self._flags(body)
            self._body(body)
        found = list(joints(self.stage, self.transforms))
        there = [each for each in found if each.enabled and each.between_bodies()]
        world = None
        for each in assemblies(there):
            base = self.about.node(each.base)
            for joint in each.joints:
                if None in (side.body for side in joint.sides):
                    world = world or self.about.world()
                self._joint(joint, base, world or base)
            for joint, body in cut_off(each).items():
                self.said.state(self.about.node(joint.prim), "cutsOff", self.about.node(body))
            for second, root in further_roots(each).items():
                self.said.state(self.about.node(second), "sharesRoot", self.about.node(root))
        for coupling in couplings(there, self.stage):
            node = self.about.node(coupling.follower)
            self.said.state(node, "leader", self.about.node(coupling.leader))
            slides = coupling.slides
            unit = self.metres if slides else radians(1)
            self.said.word(node, "couplingOf", "prismatic" if slides else "revolute")
            self.said.number(node, "multiplier", coupling.multiplier)
            self.said.number(node, "offset", coupling.offset * unit)

    def _metric(self, place: Transform) -> Transform:
        """Return *place* in metres."""
        x, y, z = (each * self.metres for each in place[0])
        return (x, y, z), place[1]

    def _joint(self, joint: PhysicsJoint, base: Term, world: Term) -> None:
        said, node = self.said, self.about.node(joint.prim)
        said.state(node, "inAssembly", base)
        for side, name in ((joint.parent, "parent"), (joint.child, "child")):
            body = self.about.node(side.body) if side.body is not None else world
            said.state(node, f"{name}Body", body)
            said.pose(node, name, self._metric(side.frame))
        said.pose(node, "drawn", self._metric(self._drawn(joint)))
        if joint.turned:
            said.state(node, "turned", TRUE)
        if joint.closes_loop:
            said.state(node, "closesLoop", TRUE)
        if joint.kind:
            said.word(node, "jointType", joint.kind)
        if joint.kind in MOVES:
            sign = -1.0 if joint.turned else 1.0
            for letter in "xyz":
                said.number(node, f"axis-{letter}", sign if letter.upper() == joint.axis else 0.0)
            self._limits(joint, node)
            self._drive(joint, node)

    def _drawn(self, joint: PhysicsJoint) -> Transform:
        """Return the pose of the frame on the child in that on the parent, as bodies are drawn."""
        near, far = (self._in_world(each) for each in (joint.parent, joint.child))
        return between(near, far)

    def _in_world(self, side: Side) -> Transform:
        if side.body is None:
            return side.frame
        return composed(self.transforms.pose(side.body).place, side.frame)

    def _limits(self, joint: PhysicsJoint, node: Term) -> None:
        """State the bounds of a joint that are not in degrees or metres where they are written."""
        names = ("physics:lowerLimit", "physics:upperLimit")
        if joint.free:
            stem = f"limit:{joint.free[0]}:physics"
            names = (f"{stem}:low", f"{stem}:high")
        bounds = [bound(joint.prim, name) for name in names]
        if all(each is None for each in bounds):
            return
        plain = not joint.free and (joint.kind == "revolute" or self.metres == 1)
        self.said.word(node, "limits", "plain" if plain else "converted")
        unit = self.metres if joint.kind in SLIDES else 1.0
        for name, value in zip(("lower", "upper"), bounds, strict=True):
            if value is not None and not plain:
                self.said.number(node, name, value * unit)

    def _drive(self, joint: PhysicsJoint, node: Term) -> None:
        """State what bounds force and speed of the drive of a joint."""
        slides = joint.kind in SLIDES
        instance = joint.free[0] if joint.free else "linear" if slides else "angular"
        force = joint.prim.number(f"drive:{instance}:physics:maxForce")
        if joint.prim.has(f"{DRIVE}:{instance}"):
            self.said.state(node, "driven", TRUE)
            if force is not None and isfinite(force):
                unit = self.kilograms * self.metres * (1 if slides else self.metres)
                self.said.number(node, "effort", force * unit)
        speeds = (joint.prim.number(each.format(instance)) for each in SPEEDS)
        speed = next((each for each in speeds if each is not None and isfinite(each)), None)
        if speed is not None:
            self.said.number(node, "velocity", speed * (self.metres if slides else radians(1)))

    def _flags(self, body: StagePrim) -> None:
        """State whether the transform of *body* is no pose."""
        node, pose = self.about.node(body), self.transforms.pose(body)
        if pose.sheared:
            self.said.state(node, "sheared", TRUE)
        if pose.scale[0] < 0:
            self.said.state(node, "mirrored", TRUE)

    def _body(self, body: StagePrim) -> None:
        """State masses and shapes of *body*."""
        said, node = self.said, self.about.node(body)
        found = list(shapes(body, self.transforms))
        scales = {
            each.path: self.transforms.pose(each).scale for each in (body, *(s.prim for s in found))
        }
        known = mass_properties(body, found, self.stage, scales)
        if known is not None:
            for each in known.sources[1:]:
                said.state(node, "collider", self.about.node(each))
            if known.mass is not None:
                said.number(node, "mass", known.mass * self.kilograms)
            said.state(node, "inertial", self.about.part(body, *MASSES))
            said.pose(node, "centre", self._metric((known.centre, known.axes)))
            if known.inertia is not None:
                unit = self.kilograms * self.metres**2
                (xx, xy, xz), (_, yy, yz), (_, _, zz) = known.inertia
                names = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
                for name, value in zip(names, (xx, yy, zz, xy, xz, yz), strict=True):
                    said.number(node, name, value * unit)
                for each in known.weighed:
                    said.state(node, "momentsFrom", self.about.node(each))
        for shape in found:
            own = self.about.node(shape.prim)
            said.state(own, "onBody", node)
            part = self.about.part(body, *SIZES) if shape.prim is body else own
            said.state(own, "shapeFrom", part)
            said.word(own, "shapeOf", "collision" if shape.collides else "visual")
            said.pose(own, "placed", self._metric(shape.place))
            if shape.kind:
                said.word(own, "shape", shape.kind)
                for number, size in enumerate(shape.sizes, 1):
                    said.number(own, f"size-{number}", size * self.metres)
