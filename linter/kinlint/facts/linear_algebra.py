"""Vectors and matrices of three dimensions, as plain tuples; a matrix is a tuple of its rows."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import TypeAlias

Vector: TypeAlias = tuple[float, float, float]
Matrix: TypeAlias = tuple[Vector, Vector, Vector]

ZERO: Vector = (0.0, 0.0, 0.0)
IDENTITY: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
EXACT = 1e-14
"""Largest deviation from orthonormality of a rotation that rounding in doubles explains."""

ROUNDS = 6
"""Newton's iteration doubles the digits with each round: six take 0.05 below rounding."""
SWEEPS = 12
"""Jacobi's method doubles the digits with each sweep; six are enough for a double."""
HUGE = 2.0**500
"""Squares of larger numbers overflow. A power of two, so that dividing by it is exact."""


def add(a: Vector, b: Vector) -> Vector:
    """Return the sum of two vectors."""
    return a[0] + b[0], a[1] + b[1], a[2] + b[2]


def subtract(a: Vector, b: Vector) -> Vector:
    """Return the difference of two vectors."""
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def scale(factor: float, a: Vector) -> Vector:
    """Return a multiple of a vector."""
    return factor * a[0], factor * a[1], factor * a[2]


def dot(a: Vector, b: Vector) -> float:
    """Return the scalar product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    """Return the vector product."""
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def length(a: Vector) -> float:
    """Return the Euclidean norm, without overflow."""
    return math.hypot(*a)


def transpose(m: Matrix) -> Matrix:
    """Return the rows as columns; of a rotation, its inverse."""
    (a, b, c), (d, e, f), (g, h, i) = m
    return (a, d, g), (b, e, h), (c, f, i)


def apply(m: Matrix, a: Vector) -> Vector:
    """Return the product of a matrix and a column."""
    return dot(m[0], a), dot(m[1], a), dot(m[2], a)


def product(m: Matrix, n: Matrix) -> Matrix:
    """Return the product of two matrices."""
    x, y, z = transpose(n)
    a, b, c = m
    return (
        (dot(a, x), dot(a, y), dot(a, z)),
        (dot(b, x), dot(b, y), dot(b, z)),
        (dot(c, x), dot(c, y), dot(c, z)),
    )


def difference(m: Matrix, n: Matrix) -> Matrix:
    """Return the difference of two matrices."""
    return subtract(m[0], n[0]), subtract(m[1], n[1]), subtract(m[2], n[2])


def determinant(m: Matrix) -> float:
    """Return the signed volume that the rows span."""
    (a, b, c), (d, e, f), (g, h, i) = m
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


@lru_cache(maxsize=4096)
def orthonormality(m: Matrix) -> float:
    """Return the largest absolute entry of MᵀM - 1: zero for a rotation or reflection."""
    x, y, z = transpose(m)
    return max(
        abs(dot(x, x) - 1.0),
        abs(dot(y, y) - 1.0),
        abs(dot(z, z) - 1.0),
        abs(dot(x, y)),
        abs(dot(y, z)),
        abs(dot(z, x)),
    )


def angle(m: Matrix) -> float:
    """Return the angle in rad by which a rotation turns, in [0, π].

    By its sine and cosine, atan2(|v|, tr M - 1) with the vector v of the antisymmetric part: exact
    for small angles too, where the cosine alone loses half of the digits.
    """
    (a, b, c), (d, e, f), (g, h, i) = m
    return math.atan2(math.hypot(h - f, c - g, d - b), a + e + i - 1.0)


def rigid(m: Matrix) -> Matrix:
    """Return the rotation next to a matrix that is one up to rounding.

    By the Newton-Schulz iteration for the polar decomposition, M ← M (3 - MᵀM) / 2 (Higham,
    Functions of Matrices, 2008, on the polar decomposition).
    """
    for _ in range(ROUNDS):
        if orthonormality(m) < EXACT:
            break
        correction = product(m, product(transpose(m), m))
        a, b, c = (
            subtract(scale(1.5, row), scale(0.5, other))
            for row, other in zip(m, correction, strict=True)
        )
        m = a, b, c
    return m


def eigenvalues(m: Matrix) -> Vector:
    """Return the eigenvalues of a symmetric matrix in ascending order.

    By cyclic Jacobi rotations (Golub and Van Loan, Matrix Computations, on Jacobi methods).
    """
    size = max(abs(each) for row in m for each in row)
    if HUGE < size < math.inf:
        a, b, c = (scale(1.0 / HUGE, row) for row in m)
        return scale(HUGE, eigenvalues((a, b, c)))
    rows = [list(row) for row in m]
    for _ in range(SWEEPS):
        if max(abs(rows[0][1]), abs(rows[0][2]), abs(rows[1][2])) <= 1e-300 + 1e-18 * size:
            break
        for p, q in ((0, 1), (0, 2), (1, 2)):
            _annihilate(rows, p, q)
    least, middle, greatest = sorted(rows[index][index] for index in range(3))
    return least, middle, greatest


def _annihilate(rows: list[list[float]], p: int, q: int) -> None:
    """Rotate the symmetric matrix *rows* so that its entry p, q vanishes."""
    off = rows[p][q]
    if off == 0.0:
        return
    theta = (rows[q][q] - rows[p][p]) / (2.0 * off)
    t = math.copysign(1.0, theta) / (abs(theta) + math.hypot(theta, 1.0))
    c = 1.0 / math.hypot(t, 1.0)
    s = t * c
    rows[p][p] -= t * off
    rows[q][q] += t * off
    rows[p][q] = rows[q][p] = 0.0
    r = 3 - p - q
    one, other = rows[r][p], rows[r][q]
    rows[r][p] = rows[p][r] = c * one - s * other
    rows[r][q] = rows[q][r] = s * one + c * other
