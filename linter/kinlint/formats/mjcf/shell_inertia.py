"""Inertia of geoms that are thin shells, of the same mass for each square metre."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

from kinlint.formats.rigid_transform import Vector

Surface = tuple[float, Vector]
"""The area of a part in m², and its moments about the centre of the geom for each kilogram."""


def shell_moments(type_: str, size: Sequence[float]) -> Surface:
    """Return the area of a sphere, box, cylinder or capsule, and its moments for each kilogram."""
    r = size[0]
    if type_ == "sphere":
        return 4 * pi * r * r, (2 / 3 * r * r,) * 3
    if type_ == "box":
        a, b, c = (each * each for each in size)
        x, y, z = size
        return _whole(
            (8 * y * z, ((b + c) / 3, a + c / 3, a + b / 3)),
            (8 * x * z, (b + c / 3, (a + c) / 3, b + a / 3)),
            (8 * x * y, (c + b / 3, c + a / 3, (a + b) / 3)),
        )
    h = 2 * size[1]
    across = r * r / 2 + h * h / 12
    tube = 2 * pi * r * h, (across, across, r * r)
    if type_ == "cylinder":
        across = r * r / 4 + h * h / 4
        return _whole(tube, (2 * pi * r * r, (across, across, r * r / 2)))
    across = 5 / 12 * r * r + (h + r) * (h + r) / 4
    return _whole(tube, (4 * pi * r * r, (across, across, 2 / 3 * r * r)))


def _whole(*parts: Surface) -> Surface:
    """Return what *parts* are together."""
    area = sum(each for each, _ in parts)
    x, y, z = (sum(part * of[axis] for part, of in parts) / area for axis in range(3))
    return area, (x, y, z)
