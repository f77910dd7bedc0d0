"""Rotations that coordinates and frames state, and how far they are from being rigid."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from itertools import combinations

from kinlint.facts.fact_statements import numbers
from kinlint.facts.linear_algebra import (
    IDENTITY,
    Matrix,
    Vector,
    angle,
    determinant,
    orthonormality,
    product,
    rigid,
    transpose,
)
from kinlint.facts.metamodel_terms import coord, kin
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.quantity import AXES, Quantities
from kinlint.terms import Term, Triple, literal_value

LOOSEST = 0.05
"""Largest deviation from orthonormality that rounding to two digits explains.

A matrix beyond it is no rotation that anything could be computed with.
"""

LOCKED = 1e-6
"""Sine between the first and the last axis of Euler angles below which they are in gimbal lock."""

QUATERNION = tuple(kin(name) for name in ("qx", "qy", "qz", "qw"))
ABOUT = {"x": (0, 1, 2), "y": (1, 2, 0), "z": (2, 0, 1)}


def columns(x: Vector, y: Vector, z: Vector) -> Matrix:
    """Return the matrix of components along axes *x*, *y*, *z* into those of their frame."""
    return transpose((x, y, z))


def from_quaternion(x: float, y: float, z: float, w: float) -> Matrix:
    """Return the rotation matrix of a quaternion, times the square of its norm.

    Source: Shuster, A Survey of Attitude Representations, 1993.
    """
    return (
        (w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
    )


def from_axis(axis: str, angle: float) -> Matrix:
    """Return the rotation by *angle* in rad about one of the axes x, y and z."""
    own, one, other = ABOUT[axis]
    rows = [[0.0] * 3 for _ in range(3)]
    rows[own][own] = 1.0
    rows[one][one] = rows[other][other] = math.cos(angle)
    rows[other][one] = math.sin(angle)
    rows[one][other] = -math.sin(angle)
    a, b, c = ((row[0], row[1], row[2]) for row in rows)
    return a, b, c


def from_euler(sequence: str, angles: Sequence[float], *, intrinsic: bool) -> Matrix:
    """Return three rotations in the order of *sequence*, about the moved or the fixed axes.

    The rpy of URDF and SDF is extrinsic xyz: fixed-axis roll, pitch and yaw, as in REP 103.
    """
    if not any(angles):
        return IDENTITY
    one, two, three = (from_axis(axis, by) for axis, by in zip(sequence, angles, strict=True))
    if intrinsic:
        return product(product(one, two), three)
    return product(product(three, two), one)


def quaternion(m: Matrix) -> tuple[float, float, float, float]:
    """Return one of the two unit quaternions x, y, z, w of a rotation.

    Source: Shepperd, Quaternion from rotation matrix, 1978, which never divides by what is small.
    """
    (a, b, c), (d, e, f), (g, h, i) = m
    rows = (
        (1 + a - e - i, b + d, c + g, h - f),
        (b + d, 1 - a + e - i, f + h, c - g),
        (c + g, f + h, 1 - a - e + i, d - b),
        (h - f, c - g, d - b, 1 + a + e + i),
    )
    x, y, z, w = max(rows, key=lambda row: math.hypot(*row))
    norm = math.hypot(x, y, z, w)
    return x / norm, y / norm, z / norm, w / norm


def euler(sequence: str, m: Matrix, near: Sequence[float], *, intrinsic: bool) -> tuple[float, ...]:
    """Return the angles in rad of a rotation in the order of *sequence*, those nearest to *near*.

    None in gimbal lock, where the first and the last turn about one axis: only their sum is known.
    """
    if not intrinsic:
        return euler(sequence[::-1], m, near[::-1], intrinsic=True)[::-1]
    i, j, k = (ABOUT[axis][0] for axis in sequence)
    last = 3 - i - j
    sense = 1.0 if ABOUT[sequence[0]][1] == j else -1.0
    if i == k:
        sine = math.hypot(m[i][j], m[i][last])
        middle, mirrored = math.atan2(sine, m[i][i]), -math.atan2(sine, m[i][i])
        one = math.atan2(m[j][i], -sense * m[last][i])
        three = math.atan2(m[i][j], sense * m[i][last])
    else:
        sine = math.hypot(m[i][i], m[i][j])
        middle = math.atan2(sense * m[i][k], sine)
        mirrored = math.pi - middle
        one = math.atan2(-sense * m[j][k], m[k][k])
        three = math.atan2(-sense * m[i][j], m[i][i])
    if sine < LOCKED:
        return ()
    ways = ((one, middle, three), (one + math.pi, mirrored, three + math.pi))
    wound = [
        tuple(by + math.tau * round((at - by) / math.tau) for by, at in zip(way, near, strict=True))
        for way in ways
    ]
    return min(wound, key=lambda way: math.dist(way, near))


class Rotations:
    """Matrices that coordinates of a model state, as they are written."""

    def __init__(self, scan: PredicateIndex, quantities: Quantities) -> None:
        self.scan = scan
        self.quantities = quantities

    @cached_property
    def stated(self) -> Mapping[Term, Matrix]:
        """Matrix of each coordinates node; of several representations on one node, the first."""
        return {**self._by_euler, **self._by_entries}

    @cached_property
    def _by_entries(self) -> Mapping[Term, Matrix]:
        """Matrices that may be no rotations; those of Euler angles are, whatever the angles."""
        return {**self._by_quaternion, **self._by_cosines}

    @cached_property
    def proper(self) -> Mapping[Term, Matrix]:
        """Proper rotations, freed of rounding; no matrix that shears, scales or reflects."""
        return {
            **{node: each for node, each in self._by_euler.items() if node not in self._by_entries},
            **_rigid(self._by_entries),
        }

    @cached_property
    def spread(self) -> Mapping[Term, float]:
        """Largest angle in rad between two representations of rotation on one node."""
        found: dict[Term, float] = {}
        for one, other in combinations(self.ways.values(), 2):
            for node in one.keys() & other.keys():
                apart = angle(product(transpose(one[node]), other[node]))
                found[node] = max(found.get(node, 0.0), apart)
        return found

    @cached_property
    def ways(self) -> Mapping[str, Mapping[Term, Matrix]]:
        """Proper rotation of each node by each representation that it has."""
        return {
            "cosines": _rigid(self._by_cosines),
            "quaternion": _rigid(self._by_quaternion),
            "euler": self._by_euler,
        }

    @cached_property
    def _by_cosines(self) -> Mapping[Term, Matrix]:
        x, y, z = (self.scan.lists(coord(f"direction-cosine-{axis}"), 3) for axis in AXES)
        return {
            node: columns(_vector(x[node]), _vector(y[node]), _vector(z[node]))
            for node in x
            if node in y and node in z
        }

    @cached_property
    def _quaternions(self) -> Mapping[Term, tuple[float, float, float, float]]:
        x, y, z, w = (self.scan.numbers(each) for each in QUATERNION)
        return {
            node: (x[node], y[node], z[node], w[node])
            for node in x
            if node in y and node in z and node in w
        }

    @cached_property
    def _by_quaternion(self) -> Mapping[Term, Matrix]:
        return {node: from_quaternion(*each) for node, each in self._quaternions.items()}

    @cached_property
    def _by_euler(self) -> Mapping[Term, Matrix]:
        sequences = self.scan.single(kin("axes-sequence"))
        if not sequences:
            return {}
        alpha, beta, gamma = (self.quantities.angles[name] for name in ("alpha", "beta", "gamma"))
        intrinsic, extrinsic = map(self.scan.instances, (kin("Intrinsic"), kin("Extrinsic")))
        return {
            node: from_euler(
                sequence,
                (alpha[node], beta[node], gamma[node]),
                intrinsic=node in intrinsic,
            )
            for node, term in sequences.items()
            if node in alpha and node in beta and node in gamma
            if (node in intrinsic) != (node in extrinsic)
            if term[0] == '"' and _turns(sequence := literal_value(term))
        }

    def facts(self) -> Iterator[Triple]:
        """Yield how far each matrix is from a rotation, if it may be none."""
        for node, matrix in self._by_entries.items():
            yield from residuals(node, matrix)
        for node, quaternion in self._quaternions.items():
            yield from numbers(node, [("norm", math.hypot(*quaternion))])
        for node, apart in sorted(self.spread.items()):
            yield from numbers(node, [("spread", apart)])


def _rigid(stated: Mapping[Term, Matrix]) -> dict[Term, Matrix]:
    return {
        node: rigid(matrix)
        for node, matrix in stated.items()
        if orthonormality(matrix) <= LOOSEST and determinant(matrix) > 0.0
    }


def residuals(node: Term, matrix: Matrix) -> Iterator[Triple]:
    """Return the determinant of *matrix*, and by how much its columns miss being orthonormal."""
    return numbers(
        node, [("determinant", determinant(matrix)), ("orthonormality", orthonormality(matrix))]
    )


def _turns(sequence: str) -> bool:
    """Tell whether *sequence* names three axes of which no two in a row are the same."""
    return (
        len(sequence) == len(AXES)
        and set(sequence) <= set(AXES)
        and sequence[0] != sequence[1] != sequence[2]
    )


def _vector(row: tuple[float, ...]) -> Vector:
    return row[0], row[1], row[2]
