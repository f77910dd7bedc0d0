"""Rotations: what coordinates and frames say of orientation, and how far that is from one."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from itertools import combinations

from kinlint.facts.linear import (
    Matrix,
    Vector,
    angle,
    determinant,
    orthonormality,
    product,
    rigid,
    transpose,
)
from kinlint.facts.names import coord, kin
from kinlint.facts.quantity import AXES, Quantities
from kinlint.facts.scan import Scan
from kinlint.facts.statement import numbers
from kinlint.terms import Term, Triple, literal_value

LOOSEST = 0.05
"""What misses orthonormality by more is no rotation that anything could be computed with."""

QUATERNION = tuple(kin(name) for name in ("qx", "qy", "qz", "qw"))
ABOUT = {"x": (0, 1, 2), "y": (1, 2, 0), "z": (2, 0, 1)}


def columns(x: Vector, y: Vector, z: Vector) -> Matrix:
    """The matrix that turns components along axes *x*, *y*, *z* into those of their frame."""
    return transpose((x, y, z))


def from_quaternion(x: float, y: float, z: float, w: float) -> Matrix:
    """The rotation of a quaternion, times the square of its norm."""
    return (
        (w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z),
    )


def from_axis(axis: str, angle: float) -> Matrix:
    """The rotation by *angle* in rad about one of the axes x, y and z."""
    own, one, other = ABOUT[axis]
    rows = [[0.0] * 3 for _ in range(3)]
    rows[own][own] = 1.0
    rows[one][one] = rows[other][other] = math.cos(angle)
    rows[other][one] = math.sin(angle)
    rows[one][other] = -math.sin(angle)
    a, b, c = ((row[0], row[1], row[2]) for row in rows)
    return a, b, c


def from_euler(sequence: str, angles: Sequence[float], *, intrinsic: bool) -> Matrix:
    """Three rotations in the order of *sequence*, each about the moved or the fixed axes."""
    one, two, three = (from_axis(axis, by) for axis, by in zip(sequence, angles, strict=True))
    if intrinsic:
        return product(product(one, two), three)
    return product(product(three, two), one)


class Rotations:
    """The matrices that coordinates of a model state, as they are written."""

    def __init__(self, scan: Scan, quantities: Quantities) -> None:
        self.scan = scan
        self.quantities = quantities

    @cached_property
    def stated(self) -> Mapping[Term, Matrix]:
        """The matrix of each coordinates node; several representations on one node: the first."""
        return {**self._by_euler, **self._by_quaternion, **self._by_cosines}

    @cached_property
    def proper(self) -> Mapping[Term, Matrix]:
        """Those that turn rigidly, freed of rounding; none that shears, scales or reflects."""
        return _rigid(self.stated)

    @cached_property
    def spread(self) -> Mapping[Term, float]:
        """The largest angle in rad between two representations of rotation on one node."""
        ways = [_rigid(way) for way in (self._by_cosines, self._by_quaternion, self._by_euler)]
        found: dict[Term, float] = {}
        for one, other in combinations(ways, 2):
            for node in one.keys() & other.keys():
                apart = angle(product(transpose(one[node]), other[node]))
                found[node] = max(found.get(node, 0.0), apart)
        return found

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
        """How far each matrix is from a rotation."""
        for node, matrix in self.stated.items():
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
    """The determinant of *matrix*, and by how much its columns miss being orthonormal."""
    return numbers(
        node, [("determinant", determinant(matrix)), ("orthonormality", orthonormality(matrix))]
    )


def _turns(sequence: str) -> bool:
    """Whether *sequence* names three axes of which no two in a row are the same."""
    return (
        len(sequence) == len(AXES)
        and set(sequence) <= set(AXES)
        and sequence[0] != sequence[1] != sequence[2]
    )


def _vector(row: tuple[float, ...]) -> Vector:
    return row[0], row[1], row[2]
