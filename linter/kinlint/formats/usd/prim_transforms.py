"""Transforms of prims: the operations that their order lists, the first outermost."""

from __future__ import annotations

from collections.abc import Sequence
from math import acos, cos, hypot, sin

from kinlint.formats.usd.matrices import (
    UNIT,
    Matrix,
    Pose,
    pose_of,
    product,
    scaling,
    translation,
    turning,
    turning_about,
)
from kinlint.formats.usd.stage import StagePrim
from kinlint.light_dataclasses import dataclass, field

RESET = "!resetXformStack!"
INVERSE = "!invert!"
ORDER = "xformOpOrder"
AXES = ("X", "Y", "Z")
COUNTS = {"translate": 3, "scale": 3, "orient": 4, "transform": 16}
"""Numbers of operations other than rotations about axes."""


@dataclass
class PrimTransforms:
    """Transforms of the prims of a stage, each worked out once, lengths in units of the stage."""

    known: dict[str, Matrix] = field(default_factory=dict)
    """Transforms from prims to the world, by paths."""
    poses: dict[str, Pose] = field(default_factory=dict)
    """Rigid parts of these, by paths."""

    def to_world(self, prim: StagePrim) -> Matrix:
        """Return the transform from *prim* to the world at the default time."""
        found = self.known.get(prim.path)
        if found is None:
            own, reset = local_transform(prim)
            above = UNIT if reset or prim.parent is None else self.to_world(prim.parent)
            found = self.known[prim.path] = above if own is UNIT else product(above, own)
        return found

    def pose(self, prim: StagePrim) -> Pose:
        """Return the rigid part of the transform from *prim* to the world."""
        found = self.poses.get(prim.path)
        if found is None:
            found = self.poses[prim.path] = pose_of(self.to_world(prim))
        return found


def local_transform(prim: StagePrim) -> tuple[Matrix, bool]:
    """Return the transform of *prim* in the prim around it, and whether it is in the world instead.

    Operations that are listed and not written do nothing, and so do all on what is not Xformable.
    """
    if prim.parent is None or not prim.is_a("Xformable"):
        return UNIT, False
    names = prim.words(ORDER)
    reset = RESET in names
    if reset:
        names = names[len(names) - names[::-1].index(RESET) :]
    found = UNIT
    for name in names:
        own = _operation(prim, name.removeprefix(INVERSE))
        if own is not None:
            own = _inverted(own) if name.startswith(INVERSE) else own
            found = own if found is UNIT else product(found, own)
    return found, reset


def _operation(prim: StagePrim, name: str) -> Matrix | None:
    """Return the operation *name*; None if it has no value."""
    kind = [*name.split(":"), ""][1]
    if kind.startswith("rotate"):
        return _rotation(prim, name, kind.removeprefix("rotate"))
    stem, axis = (kind[:-1], kind[-1]) if kind[-1:] in AXES else (kind, "")
    numbers = prim.numbers(name, 1 if axis else COUNTS.get(stem, 0))
    if numbers is None or stem not in COUNTS or (axis and stem not in ("translate", "scale")):
        return None
    if stem == "transform":
        return tuple(tuple(numbers[4 * row + column] for row in range(4)) for column in range(3))
    if stem == "orient":
        return _orientation(numbers)
    if axis:
        rest = 0.0 if stem == "translate" else 1.0
        numbers = [numbers[0] if each == axis else rest for each in "XYZ"]
    return translation(numbers) if stem == "translate" else scaling(numbers)


def _orientation(numbers: Sequence[float]) -> Matrix:
    """Return the rotation that OpenUSD makes of a quaternion, which need not be of unit length.

    The angle follows from the real part alone.
    """
    w, x, y, z = numbers
    half, length = acos(max(-1.0, min(1.0, w))), hypot(x, y, z)
    share = sin(half) / length if length else 0.0
    return turning((x * share, y * share, z * share, cos(half))) if length else UNIT


def _rotation(prim: StagePrim, name: str, axes: str) -> Matrix | None:
    """Return the rotation about one of the axes, or about three fixed ones in their order."""
    numbers = prim.numbers(name, len(axes))
    if numbers is None or not set(axes) <= set("XYZ"):
        return None
    angles = dict(zip("XYZ", numbers, strict=True)) if len(axes) > 1 else {axes: numbers[0]}
    found = UNIT
    for axis in axes:
        found = product(turning_about(axis, angles[axis]), found)
    return found


def _inverted(matrix: Matrix) -> Matrix:
    """Return the inverse of *matrix*; itself if there is none."""
    (a, b, c, p), (d, e, f, q), (g, h, i, r) = matrix
    whole = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    if not whole:
        return matrix
    rows = (
        ((e * i - f * h) / whole, (c * h - b * i) / whole, (b * f - c * e) / whole),
        ((f * g - d * i) / whole, (a * i - c * g) / whole, (c * d - a * f) / whole),
        ((d * h - e * g) / whole, (b * g - a * h) / whole, (a * e - b * d) / whole),
    )
    return tuple((*row, -(row[0] * p + row[1] * q + row[2] * r)) for row in rows)
