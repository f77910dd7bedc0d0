"""Principal axes of a symmetric matrix, by the rotations of Jacobi."""

from __future__ import annotations

from collections.abc import Sequence
from math import atan2, cos, sin

from kinlint.formats.mjcf.orientation import UNTURNED, multiplied
from kinlint.formats.rigid_transform import Quaternion

SWEEPS = 50
PAIRS = ((0, 1, 2), (0, 2, 1), (1, 2, 0))
"""The rows that a rotation mixes, and the axis that it is about."""


def principal(tensor: Sequence[float]) -> tuple[list[float], Quaternion]:
    """Return the moments of *tensor* and the rotation of the frame in which it has no products.

    The tensor is Ixx, Iyy, Izz, Ixy, Ixz, Iyz.
    """
    xx, yy, zz, xy, xz, yz = tensor
    m = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    turned = UNTURNED
    for _ in range(SWEEPS):
        if not any(m[p][q] for p, q, _ in PAIRS):
            break
        for p, q, about in PAIRS:
            if m[p][q]:
                angle = atan2(2 * m[p][q], m[p][p] - m[q][q]) / 2
                _rotate(m, p, q, angle)
                # About y the rotation that takes the first of the two to the second is backwards.
                signed = -angle if about == 1 else angle
                axis = [0.0, 0.0, 0.0]
                axis[about] = sin(signed / 2)
                turned = multiplied(turned, (axis[0], axis[1], axis[2], cos(signed / 2)))
    return [m[0][0], m[1][1], m[2][2]], turned


def _rotate(m: list[list[float]], p: int, q: int, angle: float) -> None:
    """Turn the frame of *m* by *angle* in the plane of the axes *p* and *q*."""
    c, s = cos(angle), sin(angle)
    for row in m:
        row[p], row[q] = c * row[p] + s * row[q], c * row[q] - s * row[p]
    for k in range(3):
        m[p][k], m[q][k] = c * m[p][k] + s * m[q][k], c * m[q][k] - s * m[p][k]
    m[p][q] = m[q][p] = 0.0
