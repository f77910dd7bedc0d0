"""Affine transforms as matrices of three rows for column vectors, and what is rigid of them."""

from __future__ import annotations

from collections.abc import Sequence
from math import copysign, cos, hypot, radians, sin
from typing import TypeAlias

from kinlint.formats.rigid_transform import Quaternion, Transform, Vector
from kinlint.light_dataclasses import dataclass

Matrix: TypeAlias = tuple[tuple[float, ...], ...]
"""Three rows of four numbers."""
UNIT: Matrix = ((1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0))
SQUARE = 1e-5
"""Greatest cosine of the angle between two axes of a frame that is not sheared."""


@dataclass(frozen=True, slots=True)
class Pose:
    """Rigid part of a transform, and the scale that comes before it."""

    place: Transform
    """Position and orientation."""
    scale: Vector
    """Scale along the axes; all negative for a reflection."""
    sheared: bool = False
    """True if the axes are not perpendicular: the other parts are approximate."""


def product(a: Matrix, b: Matrix) -> Matrix:
    """Return the transform *b* followed by *a*."""
    columns = list(zip(*b, strict=True))
    return tuple(
        tuple(
            sum(row[k] * column[k] for k in range(3)) + (row[3] if number == 3 else 0.0)  # noqa: PLR2004
            for number, column in enumerate(columns)
        )
        for row in a
    )


def translation(vector: Sequence[float]) -> Matrix:
    """Return a translation."""
    return tuple((*row[:3], each) for row, each in zip(UNIT, vector, strict=True))


def scaling(factors: Sequence[float]) -> Matrix:
    """Return a scaling along the axes."""
    return tuple(
        tuple(each * factor for each in row) for row, factor in zip(UNIT, factors, strict=True)
    )


def turning(quaternion: Quaternion) -> Matrix:
    """Return the rotation by a *quaternion* of any length."""
    x, y, z, w = quaternion
    length = x * x + y * y + z * z + w * w
    s = 2 / length if length else 0.0
    return (
        (1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w), 0.0),
        (s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w), 0.0),
        (s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y), 0.0),
    )


def turning_about(axis: str, degrees: float) -> Matrix:
    """Return the rotation about the *axis* "X", "Y" or "Z"."""
    half = radians(degrees) / 2
    x, y, z = (sin(half) if each == axis else 0.0 for each in "XYZ")
    return turning((x, y, z, cos(half)))


def applied(matrix: Matrix, point: Sequence[float]) -> Vector:
    """Return *point* transformed by *matrix*."""
    x, y, z = (row[0] * point[0] + row[1] * point[1] + row[2] * point[2] + row[3] for row in matrix)
    return x, y, z


def pose_of(matrix: Matrix) -> Pose:
    """Return the rigid part of *matrix*, and its scale."""
    columns = [[row[k] for row in matrix] for k in range(3)]
    lengths = [hypot(*each) for each in columns]
    a, b, c = (
        [x / length for x in column] if length else list(UNIT[k][:3])
        for k, (column, length) in enumerate(zip(columns, lengths, strict=True))
    )
    sheared = max(abs(_dot(a, b)), abs(_dot(a, c)), abs(_dot(b, c))) > SQUARE
    b = _unit([y - _dot(a, b) * x for x, y in zip(a, b, strict=True)])
    third = _crossed(a, b)
    sign = copysign(1.0, _dot(third, c))
    if sign < 0:
        a, b = [-x for x in a], [-x for x in b]
    rows = list(zip(a, b, third, strict=True))
    position = (matrix[0][3], matrix[1][3], matrix[2][3])
    scale = (sign * lengths[0], sign * lengths[1], sign * lengths[2])
    return Pose((position, quaternion(rows)), scale, sheared)


def quaternion(rows: Sequence[Sequence[float]]) -> Quaternion:
    """Return the unit quaternion of a rotation matrix of *rows*, with a w that is not negative."""
    (a, b, c), (d, e, f), (g, h, i) = (row[:3] for row in rows)
    ways = (
        (1 + a + e + i, (h - f, c - g, d - b, 1 + a + e + i)),
        (1 + a - e - i, (1 + a - e - i, b + d, c + g, h - f)),
        (1 - a + e - i, (b + d, 1 - a + e - i, f + h, c - g)),
        (1 - a - e + i, (c + g, f + h, 1 - a - e + i, d - b)),
    )
    _, found = max(ways, key=lambda each: each[0])
    length = copysign(hypot(*found), found[3])
    x, y, z, w = (each / length for each in found)
    return x, y, z, w


def _dot(a: Sequence[float], b: Sequence[float]) -> float:
    return sum(x * y for x, y in zip(a, b, strict=True))


def _crossed(a: Sequence[float], b: Sequence[float]) -> list[float]:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def _unit(a: Sequence[float]) -> list[float]:
    length = hypot(*a)
    return [x / length for x in a] if length else [0.0, 1.0, 0.0]
