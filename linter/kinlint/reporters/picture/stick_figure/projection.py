"""Projection of points in space to the plane of a figure."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import TypeAlias

from kinlint.structure import Vector

Spot: TypeAlias = tuple[float, float]
"""Point of a figure in pixels from its middle, to the right and downwards."""

AZIMUTH, ELEVATION = -50.0, 24.0
"""Direction in degrees from which a figure is seen: from x towards y, and above the floor."""


def project(point: Vector) -> Spot:
    """Return where *point*, in pixels with z upwards, is seen by a camera that is far away.

    The formula of `figure.js`, which turns the figure.
    """
    x, y, z = point
    azimuth, elevation = math.radians(AZIMUTH), math.radians(ELEVATION)
    near = math.cos(azimuth) * x + math.sin(azimuth) * y
    right = math.cos(azimuth) * y - math.sin(azimuth) * x
    return right, math.sin(elevation) * near - math.cos(elevation) * z


def depth(point: Vector) -> float:
    """Return how near *point* is to the camera, in pixels."""
    x, y, z = point
    azimuth, elevation = math.radians(AZIMUTH), math.radians(ELEVATION)
    near = math.cos(azimuth) * x + math.sin(azimuth) * y
    return math.cos(elevation) * near + math.sin(elevation) * z


def way(points: Iterable[Vector], *, closed: bool = False) -> str:
    """Return the path of SVG through *points*."""
    spots = (project(each) for each in points)
    return "M" + "L".join(f"{coordinate(x)} {coordinate(y)}" for x, y in spots) + "z" * closed


def coordinates(points: Iterable[Vector]) -> str:
    """Return *points* as the figure keeps them for turning: numbers with blanks between them."""
    return " ".join(coordinate(each) for point in points for each in point)


def coordinate(value: float) -> str:
    """Return a coordinate in pixels, to a tenth."""
    shown = f"{value:.1f}".removesuffix(".0")
    return "0" if shown == "-0" else shown


def overlaps(one: Sequence[float], other: Sequence[float]) -> bool:
    """Tell whether two boxes, each left, top, right and bottom, have an area in common."""
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]
