"""Mass and inertia of the bodies of a model, given or from their geoms, as the compiler mends them.

The formulas are those of solids of one density: https://mujoco.readthedocs.io, "Computation", and
any book of mechanics.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import hypot, pi
from typing import TypeAlias

from kinlint.formats.mjcf.compiled_model import CompiledBody, CompiledModel, CompiledPart
from kinlint.formats.mjcf.orientation import UNTURNED, multiplied, upward
from kinlint.formats.mjcf.principal_axes import principal
from kinlint.formats.mjcf.shell_inertia import shell_moments
from kinlint.formats.rigid_transform import Quaternion, Transform, Vector, composed, rotated
from kinlint.light_dataclasses import dataclass, replace

Tensor: TypeAlias = tuple[float, float, float, float, float, float]
"""Ixx, Iyy, Izz, Ixy, Ixz, Iyz."""
DENSITY = 1000.0
"""Density of geoms that state none, in kg/m³."""
MASSLESS = frozenset({"plane", "hfield"})
UNKNOWN = frozenset({"mesh", "sdf"})
"""Types whose mass or inertia depends on files."""
OPAQUE = frozenset({"include", "composite", "flexcomp", "plugin", "attach", "replicate"})
"""Elements of a body that may add geoms to it."""


@dataclass(frozen=True)
class BodyInertia:
    """Mass and inertia of one body."""

    mass: float
    """Mass in kg."""
    place: Transform
    """Pose, on the body, of the frame at the centre of mass that sees the inertia."""
    moments: Tensor
    """Moments and products about the centre of mass, in kg m², in the axes of that frame."""
    given: bool
    """True if an inertial states it, and nothing mends it."""


def inertias(model: CompiledModel) -> dict[CompiledBody, BodyInertia]:
    """Return the inertia of each body of *model* that has one, and for which it is known."""
    found: dict[CompiledBody, BodyInertia] = {}
    complete = True
    for body in model.bodies:
        if body.parent is None:
            continue
        inertia = _of_body(body)
        if inertia is not None:
            found[body] = _mended(inertia, body)
        complete &= inertia is not None or not _weighs(body)
    total = model.settings.number("settotalmass", -1.0)
    whole = sum(each.mass for each in found.values())
    if total > 0 and complete and whole > 0:
        scale = total / whole
        found = {
            body: replace(
                each,
                mass=each.mass * scale,
                moments=_scaled(each.moments, scale),
                given=False,
            )
            for body, each in found.items()
        }
    return found


def massless(model: CompiledModel) -> Iterator[CompiledBody]:
    """Yield the bodies with joints that weigh nothing, with all that is welded to them.

    Bounds of the compiler do not count. Bodies of which parts are not known are left out.
    """
    carried: dict[CompiledBody, list[CompiledBody]] = {}
    for body in model.bodies:
        if body.parent is not None and not body.joints:
            carried.setdefault(body.parent, []).append(body)
    for body in model.bodies:
        pending = [body] if body.joints else []
        weighs = not pending
        while pending and not weighs:
            at = pending.pop()
            weighs = not _is_empty(at)
            pending += carried.get(at, [])
        if not weighs:
            yield body


def _is_empty(body: CompiledBody) -> bool:
    """Tell whether *body* has no inertial, and no geoms that give it mass."""
    if body.inertial is not None or any(e.tag in OPAQUE for e in body.element.children):
        return False
    first, last = body.settings.groups
    counted = [each for each in body.geoms if first <= each.element.number("group") <= last]
    solids = [_solid(each) for each in counted]
    inferred = body.settings.text("inertiafromgeom") != "false"
    return not inferred or all(each is not None and each.mass == 0 for each in solids)


def _weighs(body: CompiledBody) -> bool:
    return bool(body.geoms) or body.inertial is not None


def _of_body(body: CompiledBody) -> BodyInertia | None:
    wanted = body.settings.text("inertiafromgeom", "auto")
    if body.inertial is not None and (wanted != "true" or not body.geoms):
        return _written(body.inertial)
    return _from_geoms(body) if wanted != "false" else None


def _written(inertial: CompiledPart) -> BodyInertia | None:
    """Return the inertia that *inertial* states; None if it states none."""
    element = inertial.element
    mass, place = element.numbers("mass"), inertial.place
    diagonal, full = element.numbers("diaginertia"), element.numbers("fullinertia")
    if not mass or place is None:
        return None
    if len(full) == 6:  # noqa: PLR2004  the entries of a symmetric matrix
        moments = full[0], full[1], full[2], full[3], full[4], full[5]
        return BodyInertia(mass[0], place, moments, given=True)
    x, y, z = diagonal if len(diagonal) == len("xyz") else (0.0, 0.0, 0.0)
    return BodyInertia(mass[0], place, (x, y, z, 0.0, 0.0, 0.0), given=True)


def _from_geoms(body: CompiledBody) -> BodyInertia | None:
    """Return what the geoms of *body* come to together; None if unknown, or nothing."""
    first, last = body.settings.groups
    geoms = [each for each in body.geoms if first <= each.element.number("group") <= last]
    solids = [_solid(each) for each in geoms]
    known = [each for each in solids if each is not None]
    mass = sum(each.mass for each in known)
    if len(known) < len(solids) or not mass > 0:
        return None
    if len(known) == 1:
        return known[0]
    centre = _sum([[each.mass / mass * x for x in each.place[0]] for each in known])
    total = [0.0] * 6
    for each in known:
        offset = [a - b for a, b in zip(each.place[0], centre, strict=True)]
        own = _turned(each.place[1], each.moments)
        shift = _of_point(each.mass, offset)
        total = [a + b + c for a, b, c in zip(total, own, shift, strict=True)]
    place = (centre[0], centre[1], centre[2]), UNTURNED
    xx, yy, zz, xy, xz, yz = total
    return BodyInertia(mass, place, (xx, yy, zz, xy, xz, yz), given=False)


def _sum(vectors: Sequence[Sequence[float]]) -> list[float]:
    return [sum(column) for column in zip(*vectors, strict=True)]


def _of_point(mass: float, offset: Sequence[float]) -> Tensor:
    """Return the inertia of a point *mass* at *offset*."""
    x, y, z = offset
    return (
        mass * (y * y + z * z), mass * (x * x + z * z), mass * (x * x + y * y),
        -mass * x * y, -mass * x * z, -mass * y * z,
    )  # fmt: skip


def _turned(q: Quaternion, tensor: Tensor) -> Tensor:
    """Return *tensor*, of a frame that is turned by *q*, in the axes of the frame around it."""
    columns = [rotated(q, axis) for axis in ((1.0, 0, 0), (0, 1.0, 0), (0, 0, 1.0))]
    xx, yy, zz, xy, xz, yz = tensor
    inner = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    entries = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
    a, b, c, d, e, f = (
        sum(columns[m][row] * inner[m][n] * columns[n][column] for m in range(3) for n in range(3))
        for row, column in entries
    )
    return a, b, c, d, e, f


def _solid(geom: CompiledPart) -> BodyInertia | None:
    """Return mass and inertia of one *geom*; None if they depend on what is not known here."""
    element = geom.element
    type_ = element.text("type") or "sphere"
    if type_ in MASSLESS:
        return BodyInertia(
            0.0, geom.place or ((0, 0, 0), UNTURNED), (0, 0, 0, 0, 0, 0), given=False
        )
    place, size = shape(geom)
    given = element.numbers("mass")
    if given and given[0] == 0:
        return BodyInertia(0.0, place or ((0, 0, 0), UNTURNED), (0, 0, 0, 0, 0, 0), given=False)
    hollow = element.text("shellinertia") == "true"
    unknown = type_ in UNKNOWN or element.text("mesh") or (hollow and type_ == "ellipsoid")
    if unknown or place is None or not size:
        return None
    volume, moments = (shell_moments if hollow else _moments)(type_, size)
    mass = given[0] if given else volume * element.number("density", DENSITY)
    x, y, z = (mass * each for each in moments)
    return BodyInertia(mass, place, (x, y, z, 0.0, 0.0, 0.0), given=False)


def shape(geom: CompiledPart) -> tuple[Transform | None, list[float]]:
    """Return pose and sizes of *geom*, which both its ends may say; no sizes if one is missing."""
    element, place = geom.element, geom.place
    type_ = element.text("type") or "sphere"
    size, ends = element.numbers("size"), element.numbers("fromto")
    count = {"sphere": 1, "capsule": 2, "cylinder": 2, "box": 3, "ellipsoid": 3}.get(type_, 0)
    if len(ends) == 6 and geom.place is not None and size:  # noqa: PLR2004  two points
        half = hypot(*(b - a for a, b in zip(ends[:3], ends[3:], strict=True))) / 2
        size = [size[0], half] if count == 2 else [size[0], size[0], half]  # noqa: PLR2004
        place = _between(geom, ends)
    if len(size) < count or any(each <= 0 for each in size[:count]):
        return place, []
    return place, size[:count]


def _between(geom: CompiledPart, ends: Sequence[float]) -> Transform | None:
    """Return the pose of *geom*, whose axis z points from the second to the first of its *ends*."""
    first, second = ends[:3], ends[3:]
    turned = upward([a - b for a, b in zip(first, second, strict=True)])
    if turned is None or geom.frame is None:
        return None
    middle = tuple((a + b) / 2 for a, b in zip(first, second, strict=True))
    at: Vector = (middle[0], middle[1], middle[2])
    return composed(geom.frame, (at, turned))


def _moments(type_: str, size: Sequence[float]) -> tuple[float, Vector]:
    """Return the volume of a solid, and its principal moments for each kilogram."""
    if type_ == "sphere":
        r = size[0]
        return 4 / 3 * pi * r**3, (0.4 * r * r,) * 3
    if type_ == "ellipsoid":
        a, b, c = (each * each for each in size)
        return 4 / 3 * pi * size[0] * size[1] * size[2], ((b + c) / 5, (a + c) / 5, (a + b) / 5)
    if type_ == "box":
        a, b, c = (each * each for each in size)
        return 8 * size[0] * size[1] * size[2], ((b + c) / 3, (a + c) / 3, (a + b) / 3)
    r, h = size[0], 2 * size[1]
    if type_ == "cylinder":
        across = (3 * r * r + h * h) / 12
        return pi * r * r * h, (across, across, r * r / 2)
    ball, tube = 4 / 3 * pi * r**3, pi * r * r * h
    whole = ball + tube
    along = (0.4 * ball * r * r + tube * r * r / 2) / whole
    across = (
        ball * (0.4 * r * r + h * h / 4 + 3 / 8 * h * r) + tube * (3 * r * r + h * h) / 12
    ) / whole
    return whole, (across, across, along)


def _scaled(tensor: Tensor, factor: float) -> Tensor:
    a, b, c, d, e, f = (each * factor for each in tensor)
    return a, b, c, d, e, f


def _mended(inertia: BodyInertia, body: CompiledBody) -> BodyInertia:
    """Return *inertia* with the least mass and moments, and balanced, as the compiler is told."""
    settings = body.settings
    least_mass, least = settings.number("boundmass", 0.0), settings.number("boundinertia", 0.0)
    balanced = settings.text("balanceinertia") == "true"
    mass = max(inertia.mass, least_mass)
    if least_mass > 0 and mass != inertia.mass:
        inertia = replace(inertia, mass=mass, given=False)
    if not least and not balanced:
        return inertia
    values, turned = principal(inertia.moments)
    raised = [max(each, least) for each in values]
    x, y, z = sorted(raised)
    if balanced and x + y < z:
        raised = [(x + y + z) / 3] * 3
    if raised == values:
        return inertia
    place = inertia.place[0], multiplied(inertia.place[1], turned)
    a, b, c = raised
    return replace(inertia, place=place, moments=(a, b, c, 0.0, 0.0, 0.0), given=False)
