"""Shapes of bodies: what collides, and what is only drawn."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi

from kinlint.formats.rigid_transform import Quaternion, Transform, between, composed
from kinlint.formats.usd.physics_joints import is_body
from kinlint.formats.usd.prim_transforms import ORDER, RESET, PrimTransforms
from kinlint.formats.usd.stage import StagePrim
from kinlint.light_dataclasses import dataclass

COLLISION = "PhysicsCollisionAPI"
SIZES = {"Cube": (("size", 2.0),), "Sphere": (("radius", 1.0),)} | dict.fromkeys(
    ("Cylinder", "Capsule"), (("radius", 1.0), ("height", 2.0))
)
FALLBACKS = {("Capsule", "radius"): 0.5, ("Capsule", "height"): 1.0}
_HALF = 0.5**0.5
ALONG: dict[str, Quaternion] = {
    "X": (0.0, _HALF, 0.0, _HALF),
    "Y": (-_HALF, 0.0, 0.0, _HALF),
    "Z": (0.0, 0.0, 0.0, 1.0),
}
"""Rotations that turn axis z to the axis along which a cylinder stands."""


@dataclass(eq=False)
class Shape:
    """Shape of a body."""

    prim: StagePrim
    """Its prim."""
    collides: bool
    """True if it is a collider, false if it is only drawn."""
    place: Transform
    """Pose on the body, in units of the stage; of a solid of revolution, with axis z along it."""
    kind: str
    """"box", "sphere", "cylinder" or "capsule"; empty for what is known by another way."""
    sizes: tuple[float, ...]
    """Edges, or radius and height, in units of the stage."""

    @property
    def volume(self) -> float | None:
        """Volume in units of the stage; None if it is not known."""
        if self.kind == "box":
            return self.sizes[0] * self.sizes[1] * self.sizes[2]
        r = self.sizes[0] if self.sizes else 0.0
        ball = 4 / 3 * pi * r**3
        if self.kind == "sphere":
            return ball
        rod = pi * r**2 * self.sizes[1] if self.kind else None
        return rod if self.kind != "capsule" or rod is None else rod + ball

    @property
    def moments(self) -> tuple[float, float, float]:
        """Moments of inertia about its centre along its own axes, for a density of one."""
        if self.kind == "box":
            x, y, z = self.sizes
            v = x * y * z / 12
            return v * (y * y + z * z), v * (x * x + z * z), v * (x * x + y * y)
        r = self.sizes[0]
        ball = 4 / 3 * pi * r**3
        if self.kind == "sphere":
            return (0.4 * ball * r * r,) * 3
        h = self.sizes[1]
        rod = pi * r**2 * h
        across = rod * (r * r / 4 + h * h / 12)
        along = rod * r * r / 2
        if self.kind == "capsule":
            across += ball * (0.4 * r * r + h * h / 4 + 0.375 * h * r)
            along += ball * 0.4 * r * r
        return across, across, along


def shapes(body: StagePrim, transforms: PrimTransforms) -> Iterator[Shape]:
    """Yield the shapes of *body*, those of bodies in it left out."""
    frame = transforms.pose(body).place
    pending = [body]
    while pending:
        at = pending.pop()
        if at is not body and (is_body(at) or RESET in at.words(ORDER) or at.specifier != "def"):
            continue
        pending += at.children[::-1]
        if at.is_a("Gprim"):
            collides = at.has(COLLISION)
            if collides and not at.flag("physics:collisionEnabled", default=True):
                continue
            yield _shape(at, frame, transforms, collides=collides)


def _shape(
    prim: StagePrim, frame: Transform, transforms: PrimTransforms, *, collides: bool
) -> Shape:
    pose = transforms.pose(prim)
    place = between(frame, pose.place)
    known = SIZES.get(prim.type_name)
    if known is None or pose.sheared:
        return Shape(prim, collides, place, "", ())
    scale = [abs(each) for each in pose.scale]
    numbers = []
    for name, usual in known:
        number = prim.number(name)
        fallback = FALLBACKS.get((prim.type_name, name), usual)
        numbers.append(fallback if number is None else number)
    if prim.type_name == "Cube":
        return Shape(prim, collides, place, "box", tuple(numbers[0] * each for each in scale))
    if prim.type_name == "Sphere":
        return Shape(prim, collides, place, "sphere", (numbers[0] * max(scale),))
    axis = prim.word("axis") or "Z"
    axis = axis if axis in ALONG else "Z"
    along = "XYZ".index(axis)
    across = max(each for number, each in enumerate(scale) if number != along)
    sizes = numbers[0] * across, numbers[1] * scale[along]
    turned = composed(place, ((0.0, 0.0, 0.0), ALONG[axis]))
    return Shape(prim, collides, turned, prim.type_name.lower(), sizes)
