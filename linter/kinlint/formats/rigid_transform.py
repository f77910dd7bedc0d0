"""Rigid transforms: what a pose says, put together and turned round."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, hypot, radians, sin
from typing import TypeAlias

Vector: TypeAlias = tuple[float, float, float]
Quaternion: TypeAlias = tuple[float, float, float, float]
"""x, y, z, w."""
Transform: TypeAlias = tuple[Vector, Quaternion]
"""Position of the origin of a frame, in metres, and its orientation, in another frame."""

IDENTITY: Transform = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0)
EULER, QUATERNION = 6, 7
DIGITS = 14


def transform(numbers: Sequence[float], *, degrees: bool = False) -> Transform | None:
    """Return the pose of *numbers*.

    A position, and roll, pitch and yaw or a quaternion; else None.
    """
    position = (*numbers[:3], 0.0, 0.0, 0.0)[:3]
    if len(numbers) == EULER:
        roll, pitch, yaw = (radians(each) if degrees else each for each in numbers[3:])
        return (position[0], position[1], position[2]), _rotation(roll, pitch, yaw)
    if len(numbers) == QUATERNION and (length := hypot(*numbers[3:])):
        x, y, z, w = (each / length for each in numbers[3:])
        return (position[0], position[1], position[2]), (x, y, z, w)
    return None


def _rotation(roll: float, pitch: float, yaw: float) -> Quaternion:
    """Return the rotation about x, then y, then z, all of the fixed frame."""
    (sr, cr), (sp, cp), (sy, cy) = ((sin(a / 2), cos(a / 2)) for a in (roll, pitch, yaw))
    return (
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    )


def rotated(q: Quaternion, v: Vector) -> Vector:
    """Return the vector *v* of a frame rotated by *q*, in the frame before the rotation."""
    x, y, z, w = q
    tx, ty, tz = 2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])
    return (
        v[0] + w * tx + y * tz - z * ty,
        v[1] + w * ty + z * tx - x * tz,
        v[2] + w * tz + x * ty - y * tx,
    )


def inverse(a: Transform) -> Transform:
    """Return the pose of the second frame as the first sees it."""
    (px, py, pz), (x, y, z, w) = a
    back = (-x, -y, -z, w)
    return rotated(back, (-px, -py, -pz)), back


def composed(a: Transform, b: Transform) -> Transform:
    """Return the pose *b*, seen by a frame of the pose *a*, as seen by what sees *a*."""
    (px, py, pz), (ax, ay, az, aw) = a
    (x, y, z), (bx, by, bz, bw) = rotated(a[1], b[0]), b[1]
    return (px + x, py + y, pz + z), (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def between(a: Transform, b: Transform) -> Transform:
    """Return the pose *b* as seen by a frame of the pose *a*, where the same frame sees both."""
    return composed(inverse(a), b)


def rounded(values: Sequence[float]) -> list[float]:
    """Return *values* without rounding errors of the arithmetic."""
    return [round(each, DIGITS) + 0.0 for each in values]
