"""Glyphs of joints: the axis, a ring or a track about it, and the range of the limits."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kinlint.light_dataclasses import dataclass
from kinlint.structure import Joint, Vector

HEAD = 0.75
"""Length of the head of the arrow along the axis, relative to the ring."""
SMALL = 4.0
"""Radius in pixels below which a ring is not drawn."""
STEP = math.radians(15.0)
"""Angle between two points of an arc."""
AXIS, RANGE = 2.6, 2.3
"""Half the length of the axis, and the radius of the range, relative to the ring."""
ENDLESS = 1e4
"""Length in pixels of a range beyond which it is cut: no figure is as large."""


class Line(NamedTuple):
    """Line or area of a glyph."""

    kind: str
    """Class of its style: axis, ring, range or end."""
    points: Sequence[Vector]
    """Points in pixels."""
    closed: bool = False
    """True if its last point is joined to the first."""


@dataclass(frozen=True, slots=True)
class Glyph:
    """Glyph of one joint."""

    joint: Joint
    """Joint itself."""
    at: Vector
    """Its place in pixels."""
    along: Vector
    """Vector in pixels of the link that it moves: the range of a turning joint begins there."""
    size: float
    """Radius of its ring in pixels."""
    scale: float
    """Number of pixels in a metre."""
    step: float = STEP
    """Angle in rad between two points of an arc."""

    def lines(self) -> Iterator[Line]:
        """Yield its lines; none of a joint without an axis."""
        if self.joint.direction is None or self.joint.kind == "fixed":
            return
        axis = self.joint.direction
        one, other = _across(axis, self.along)
        lower, upper = self.joint.lower, self.joint.upper
        if lower is not None and upper is not None:
            least, most = sorted((lower, upper))
            if self.joint.kind == "prismatic":
                yield from self._track(axis, one, least, most)
            else:
                arc = self._arc(one, other, RANGE * self.size, least, most)
                yield Line("range", (self.at, *arc), closed=True)
        if self.joint.kind != "prismatic" and self.size >= SMALL:
            ring = list(self._arc(one, other, self.size, 0.0, math.tau))
            yield Line("ring", ring[:-1], closed=True)
        low, high = (_moved(self.at, axis, sign * AXIS * self.size) for sign in (-1.0, 1.0))
        back = _moved(high, axis, -HEAD * self.size)
        left, right = (_moved(back, other, sign * 0.5 * HEAD * self.size) for sign in (-1.0, 1.0))
        yield Line("axis", (low, high))
        yield Line("head", (high, left, right), closed=True)

    def _track(self, axis: Vector, one: Vector, least: float, most: float) -> Iterator[Line]:
        """Yield how far a sliding joint moves, in m: a line with a bar at each end."""
        lengths = [max(-ENDLESS, min(ENDLESS, each * self.scale)) for each in (least, most)]
        ends = [_moved(self.at, axis, each) for each in lengths]
        yield Line("range", ends)
        for end in ends:
            yield Line("end", [_moved(end, one, sign * self.size * 0.6) for sign in (-1.0, 1.0)])

    def _arc(
        self, one: Vector, other: Vector, radius: float, low: float, high: float
    ) -> Iterator[Vector]:
        """Yield points of a circle from angle *low* to *high* in rad, at most one turn of it."""
        if not high - low < math.tau:
            low, high = 0.0, math.tau
        low, span = math.remainder(low, math.tau), high - low
        count = max(1, math.ceil(span / self.step))
        for index in range(count + 1):
            angle = low + span * index / count
            toward = _moved(_moved((0.0, 0.0, 0.0), one, math.cos(angle)), other, math.sin(angle))
            yield _moved(self.at, toward, radius)


def _across(axis: Vector, along: Vector) -> tuple[Vector, Vector]:
    """Return two unit vectors perpendicular to *axis*, the first as near to *along* as can be."""
    for near in (along, (0.0, 0.0, 1.0), (1.0, 0.0, 0.0)):
        part = sum(a * b for a, b in zip(axis, near, strict=True))
        one = _moved(near, axis, -part)
        if (size := math.hypot(*one)) > 0.05 * math.hypot(*near) > 0.0:
            break
    one = _moved((0.0, 0.0, 0.0), one, 1.0 / size)
    (a, b, c), (d, e, f) = axis, one
    return one, (b * f - c * e, c * d - a * f, a * e - b * d)


def _moved(point: Vector, along: Vector, by: float) -> Vector:
    return point[0] + by * along[0], point[1] + by * along[1], point[2] + by * along[2]
