"""Statements about matrices and scales of COLLADA that do more than to move."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import hypot

from kinlint.formats.collada.collada_elements import ColladaElement
from kinlint.formats.collada.transforms import ENTRIES
from kinlint.formats.derived_statements import DerivedStatements

Columns = Sequence[tuple[float, ...]]


def state_transforms(root: ColladaElement, said: DerivedStatements) -> None:
    """State the determinants of scales and matrices below *root*; of matrices, more.

    `lastRow` is the greatest deviation of the fourth row from 0 0 0 1, `shear` the greatest cosine
    of the angles between the axes.
    """
    for each in root.below():
        numbers = each.numbers() if each.tag in ("matrix", "scale") else []
        if each.tag == "scale" and len(numbers) == 3:  # noqa: PLR2004  x, y, z
            x, y, z = numbers
            said.number(each.node, "determinant", x * y * z)
        elif len(numbers) == ENTRIES:
            last = (*numbers[12:15], numbers[15] - 1)
            said.number(each.node, "lastRow", max(map(abs, last)))
            _state_axes([*zip(*(numbers[i : i + 3] for i in (0, 4, 8)), strict=True)], each, said)


def _state_axes(columns: Columns, matrix: ColladaElement, said: DerivedStatements) -> None:
    a, b, c = columns
    said.number(matrix.node, "determinant", _dot(_cross(a, b), c))
    cosines = list(_cosines(columns))
    if cosines:
        said.number(matrix.node, "shear", max(map(abs, cosines)))


def _cosines(columns: Columns) -> Iterator[float]:
    a, b, c = columns
    for u, v in ((a, b), (b, c), (c, a)):
        size = hypot(*u) * hypot(*v)
        if size:
            yield _dot(u, v) / size


def _dot(u: Sequence[float], v: Sequence[float]) -> float:
    return sum(x * y for x, y in zip(u, v, strict=True))


def _cross(u: Sequence[float], v: Sequence[float]) -> tuple[float, float, float]:
    return u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]
