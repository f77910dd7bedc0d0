"""Transforms of links, bodies and nodes: lists of translations, rotations and others, in order."""

from __future__ import annotations

from collections.abc import Container, Iterable, Sequence
from math import copysign, cos, hypot, radians, sin, sqrt
from typing import TypeAlias

from kinlint.formats.collada.collada_elements import ColladaElement
from kinlint.formats.rigid_transform import IDENTITY, Quaternion, Transform, composed

TRANSFORMS = ("translate", "rotate", "matrix", "scale", "skew", "lookat")
RIGID = ("translate", "rotate", "matrix")
ENTRIES = 16
TOLERANCE = 1e-4
"""Greatest deviation of a rotation matrix from an orthonormal one."""

Matrix: TypeAlias = tuple[tuple[float, ...], ...]


def place(
    element: ColladaElement, unit: float, without: Container[ColladaElement] = ()
) -> Transform | None:
    """Return the rigid transform that the children of *element* make, in order.

    Lengths are in *unit* metres. None if one of them is malformed, or does more than to move.
    """
    parts = (_rigid(each, unit) for each in element.all(*TRANSFORMS) if each not in without)
    return _product(parts)


def _product(parts: Iterable[Transform | None]) -> Transform | None:
    at = IDENTITY
    for each in parts:
        if each is None:
            return None
        at = composed(at, each)
    return at


def _rigid(element: ColladaElement, unit: float) -> Transform | None:
    numbers = element.numbers()
    if element.tag == "translate" and len(numbers) == 3:  # noqa: PLR2004  x, y, z
        x, y, z = numbers
        return (x * unit, y * unit, z * unit), IDENTITY[1]
    if element.tag == "rotate" and len(numbers) == 4:  # noqa: PLR2004  axis and angle
        return (0.0, 0.0, 0.0), _turn(numbers)
    if element.tag == "matrix" and len(numbers) == ENTRIES:
        rows = [numbers[0:4], numbers[4:8], numbers[8:12]]
        turned = _quaternion([row[:3] for row in rows])
        x, y, z = (row[3] * unit for row in rows)
        return None if turned is None else ((x, y, z), turned)
    if element.tag == "scale" and numbers == [1.0, 1.0, 1.0]:
        return IDENTITY
    return None


def _turn(numbers: Sequence[float]) -> Quaternion:
    """Return the rotation by an angle in degrees about an axis; none about no axis."""
    x, y, z, angle = numbers
    length = hypot(x, y, z)
    if not length:
        return IDENTITY[1]
    half = radians(angle) / 2
    s = sin(half) / length
    return x * s, y * s, z * s, cos(half)


def _quaternion(rows: Sequence[Sequence[float]]) -> Quaternion | None:
    """Return the rotation of a matrix of *rows*; None if it is none."""
    (a, b, c), (d, e, f), (g, h, i) = rows
    products = (sum(m * n for m, n in zip(p, q, strict=True)) for p in rows for q in rows)
    identity = (1, 0, 0, 0, 1, 0, 0, 0, 1)
    if any(abs(x - y) > TOLERANCE for x, y in zip(products, identity, strict=True)):
        return None
    if a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g) < 0:
        return None
    w, x, y, z = (
        sqrt(max(0.0, each)) / 2
        for each in (1 + a + e + i, 1 + a - e - i, 1 - a + e - i, 1 - a - e + i)
    )
    if w > max(x, y, z) / 2:
        x, y, z = copysign(x, h - f), copysign(y, c - g), copysign(z, d - b)
    else:
        x, y, z, w = _by_largest(x, y, z, rows)
    length = hypot(x, y, z, w)
    return x / length, y / length, z / length, w / length


def _by_largest(
    x: float, y: float, z: float, rows: Sequence[Sequence[float]]
) -> tuple[float, float, float, float]:
    """Return the quaternion of a rotation by nearly half a turn, the largest part positive."""
    (_, b, c), (d, _, f), (g, h, _) = rows
    if x >= y and x >= z:
        return x, (b + d) / (4 * x), (c + g) / (4 * x), (h - f) / (4 * x)
    if y >= z:
        return (b + d) / (4 * y), y, (f + h) / (4 * y), (c - g) / (4 * y)
    return (c + g) / (4 * z), (f + h) / (4 * z), z, (d - b) / (4 * z)


def world_place(node: ColladaElement, unit: float) -> Transform | None:
    """Return the pose of the visual *node* in its scene, if only rigid transforms make it."""
    nodes = [node, *(each for each in node.ancestors() if each.tag == "node")]
    return _product(place(each, unit) for each in reversed(nodes))
