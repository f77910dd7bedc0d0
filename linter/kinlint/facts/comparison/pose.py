"""Poses of frames: rigid transformations of three dimensions."""

from __future__ import annotations

from typing import NamedTuple

from kinlint.facts.linear_algebra import (
    IDENTITY,
    ZERO,
    Matrix,
    Vector,
    add,
    apply,
    product,
    subtract,
    transpose,
)


class Pose(NamedTuple):
    """Rigid transformation of the coordinates of a frame to those of another."""

    point: Vector = ZERO
    """Origin of the frame in m."""
    turn: Matrix = IDENTITY
    """Rotation of its axes."""

    def of(self, other: Pose) -> Pose:
        """Return the pose *other*, which this frame sees, as it is seen here."""
        return Pose(self.at(other.point), product(self.turn, other.turn))

    def at(self, point: Vector) -> Vector:
        """Return a point of the frame as it is seen here."""
        return add(self.point, apply(self.turn, point))

    def along(self, direction: Vector) -> Vector:
        """Return a direction in the frame as it is seen here."""
        return apply(self.turn, direction)

    def tensor(self, tensor: Matrix) -> Matrix:
        """Return a tensor, seen by the frame, along the axes here."""
        return product(product(self.turn, tensor), transpose(self.turn))

    @property
    def inverse(self) -> Pose:
        """The pose of this frame's observer, as the frame sees it."""
        back = transpose(self.turn)
        return Pose(subtract(ZERO, apply(back, self.point)), back)


HERE = Pose()
"""Pose of a frame that coincides with its observer."""
