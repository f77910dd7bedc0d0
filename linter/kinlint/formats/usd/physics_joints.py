"""Joints of a stage: the bodies that they join, and their frames on these."""

from __future__ import annotations

from collections.abc import Iterator
from math import isfinite

from kinlint.formats.rigid_transform import IDENTITY, Transform, between, composed
from kinlint.formats.usd.matrices import quaternion, turning
from kinlint.formats.usd.prim_transforms import PrimTransforms
from kinlint.formats.usd.stage import Stage, StagePrim
from kinlint.light_dataclasses import dataclass

BODY, ROOT = "PhysicsRigidBodyAPI", "PhysicsArticulationRootAPI"
TYPES = {
    "PhysicsRevoluteJoint": "revolute",
    "PhysicsPrismaticJoint": "prismatic",
    "PhysicsFixedJoint": "fixed",
    "PhysicsSphericalJoint": "spherical",
}
DIRECTIONS = ("transX", "transY", "transZ", "rotX", "rotY", "rotZ")
LIMIT = "PhysicsLimitAPI"


@dataclass(eq=False)
class Side:
    """Side of a joint."""

    body: StagePrim | None
    """Body; None for the world."""
    frame: Transform
    """Pose of the joint on the body, or in the world, in units of the stage."""
    target: str = ""
    """Path that it names; empty if it names none."""
    dangling: bool = False
    """True if there is no such prim."""


@dataclass(eq=False)
class PhysicsJoint:
    """Joint of a stage."""

    prim: StagePrim
    """Its prim."""
    sides: tuple[Side, Side]
    """Sides of body0 and body1."""
    kind: str
    """"revolute", "prismatic" and so on, by the directions in which it is free; empty if that is no
    known kind."""
    axis: str
    """"X", "Y" or "Z": along or about which it moves."""
    free: tuple[str, ...] = ()
    """Directions that a joint without a kind of its own leaves free."""
    turned: bool = False
    """True if body1 is the parent."""

    @property
    def enabled(self) -> bool:
        """True if the joint is enabled."""
        return self.prim.flag("physics:jointEnabled", default=True)

    @property
    def closes_loop(self) -> bool:
        """True if the joint is left out of the tree of its articulation."""
        return self.prim.flag("physics:excludeFromArticulation", default=False)

    @property
    def parent(self) -> Side:
        """The side that carries the other one."""
        return self.sides[1 if self.turned else 0]

    @property
    def child(self) -> Side:
        """The side that the joint moves."""
        return self.sides[0 if self.turned else 1]

    def between_bodies(self) -> bool:
        """Tell whether it joins two bodies that are there, or one and the world."""
        one, other = self.sides
        return one.body is not other.body and not (one.dangling or other.dangling)


def is_body(prim: StagePrim) -> bool:
    """Tell whether *prim* is a rigid body."""
    enabled = prim.flag("physics:rigidBodyEnabled", default=True)
    return prim.has(BODY) and enabled


def body_at(prim: StagePrim) -> StagePrim | None:
    """Return the body that *prim* moves with; None if it stands still."""
    return next((each for each in (prim, *prim.around()) if is_body(each)), None)


def joints(stage: Stage, transforms: PrimTransforms) -> Iterator[PhysicsJoint]:
    """Yield the joints of *stage*, in the order of their prims."""
    for prim in stage.defined():
        if prim.is_a("PhysicsJoint"):
            one, other = (_side(number, prim, stage, transforms) for number in "01")
            axis = prim.word("physics:axis")
            kind = TYPES.get(prim.type_name, "")
            free: tuple[str, ...] = ()
            if prim.type_name == "PhysicsJoint":
                kind, axis, free = _generic(prim)
            yield PhysicsJoint(
                prim, (one, other), kind, axis if axis in "YZ" and axis else "X", free
            )


def _side(number: str, prim: StagePrim, stage: Stage, transforms: PrimTransforms) -> Side:
    """Return the side *number* of the joint *prim*."""
    position = prim.numbers(f"physics:localPos{number}", 3) or [0.0, 0.0, 0.0]
    w, x, y, z = prim.numbers(f"physics:localRot{number}", 4) or [1.0, 0.0, 0.0, 0.0]
    turn = quaternion(turning((x, y, z, w)))
    paths = prim.targets(f"physics:body{number}")
    target = stage.prims.get(paths[0]) if paths else None
    if target is None:
        place = ((position[0], position[1], position[2]), turn)
        return Side(None, place, paths[0] if paths else "", dangling=bool(paths))
    pose = transforms.pose(target)
    px, py, pz = (each * factor for each, factor in zip(position, pose.scale, strict=True))
    own: Transform = (px, py, pz), turn
    body = body_at(target)
    at = transforms.pose(body).place if body is not None else IDENTITY
    return Side(body, own if body is target else composed(between(at, pose.place), own), paths[0])


def _generic(prim: StagePrim) -> tuple[str, str, tuple[str, ...]]:
    """Return kind, axis and free directions of a joint that limits lock some directions of."""
    free = tuple(each for each in DIRECTIONS if not _locked(prim, each))
    slides = [each[-1] for each in free if each.startswith("trans")]
    turns = [each[-1] for each in free if each.startswith("rot")]
    axis = (turns or slides or ["X"])[0]
    kinds = {
        (0, 0): "fixed",
        (0, 1): "revolute",
        (1, 0): "prismatic",
        (0, 3): "spherical",
        (3, 3): "floating",
    }
    kind = kinds.get((len(slides), len(turns)), "")
    if len(turns) == 1 and slides == turns:
        kind = "cylindrical"
    elif len(turns) == 1 and len(slides) == 2 and turns[0] not in slides:  # noqa: PLR2004
        kind = "planar"
    return kind, axis, free


def _locked(prim: StagePrim, direction: str) -> bool:
    low, high = (bound(prim, f"limit:{direction}:physics:{end}") for end in ("low", "high"))
    applied = prim.has(f"{LIMIT}:{direction}")
    return applied and low is not None and high is not None and low > high


def bound(prim: StagePrim, name: str) -> float | None:
    """Return the finite number *name* of *prim*; None if there is none."""
    number = prim.number(name)
    return number if number is not None and isfinite(number) else None
