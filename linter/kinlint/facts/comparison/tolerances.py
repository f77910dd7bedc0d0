"""Differences of numbers that do not count, by unit."""

from __future__ import annotations

from kinlint.facts.linear_algebra import Matrix, Vector, length, subtract
from kinlint.light_dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Tolerances:
    """Largest differences that do not count."""

    relative: float
    """Of masses, inertias, limits and sizes, as a share of the greater one."""
    distance: float
    """Of points, in m."""
    angle: float
    """Of directions and rotations, in rad."""

    def apart(self, one: float, other: float) -> bool:
        """Tell whether two numbers differ."""
        return abs(one - other) > self.relative * max(abs(one), abs(other)) + FLOOR

    def away(self, one: Vector, other: Vector) -> bool:
        """Tell whether two points in m differ."""
        return length(subtract(one, other)) > self.distance

    def turned(self, one: Vector, other: Vector) -> bool:
        """Tell whether two unit vectors differ."""
        return length(subtract(one, other)) > self.angle

    def unlike(self, one: Matrix, other: Matrix) -> bool:
        """Tell whether two tensors differ in an entry by a share of the greatest moment."""
        greatest = max(abs(m[at][at]) for m in (one, other) for at in range(3))
        rows = zip(one, other, strict=True)
        apart = (abs(a - b) for row in rows for a, b in zip(*row, strict=True))
        return max(apart) > self.relative * greatest + FLOOR * FLOOR


FLOOR = 1e-9
"""Difference of numbers without regard to their size that rounding in doubles explains."""
EXPORTED = Tolerances(0.01, 1e-3, 2e-3)
"""Tolerances for files of different formats: exporters round to two digits, or π to 3.14."""
EXACT = Tolerances(1e-9, 1e-9, 1e-9)
"""Tolerances for two revisions of one file, of which every change counts."""
