"""Relations to blame for several loops that fail to close by the same error."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from kinlint.facts.linear_algebra import Matrix, Vector
from kinlint.facts.spanning_forest import SpanningForest
from kinlint.terms import Term

LEAST = 1e-4
"""Errors of loops below this, in rad or m, come from rounding of written numbers.

No cause is sought.
"""

ALIKE = 0.1
"""Largest spread of errors about their mean, as a part of it, at which they count as the same.

Two relations that are wrong independently seldom agree to a tenth.
"""

SEVERAL = 2
"""Fewest loops that tell a cause: a single one may fail because of any of its relations."""

MOST_CAUSES = 8


class Miss(NamedTuple):
    """Closing error of a loop, by the index of its closing edge, as numbers that are added up."""

    edge: int
    """Index of the closing edge."""
    odd: tuple[float, ...]
    """Numbers that change their sign if the loop is walked the other way."""
    even: tuple[float, ...] = ()
    """Numbers that do not."""

    @property
    def square(self) -> float:
        """Squared size of the error."""
        return sum(each * each for each in (*self.odd, *self.even))


def shifted(edge: int, by: Vector) -> Miss:
    """Return the error of a loop of positions, which misses by a vector in m."""
    return Miss(edge, by)


def turned(edge: int, by: Matrix) -> Miss:
    """Return the error of a loop of orientations, which misses by a rotation.

    Its size is the Frobenius norm of the difference from the identity matrix.
    """
    (a, b, c), (d, e, f), (g, h, i) = by
    root = math.sqrt(0.5)
    odd = tuple(root * each for each in (h - f, c - g, d - b))
    even = (a - 1.0, e - 1.0, i - 1.0, *(root * each for each in (h + f, c + g, d + b)))
    return Miss(edge, odd, even)


def common_causes(forest: SpanningForest, misses: Sequence[Miss]) -> Mapping[int, int]:
    """Return the edge to blame for each closing edge whose error has a common cause.

    An edge is to blame if two or more loops go through it and all of them miss by the same. Sums
    over subtrees find it: each of at most `MOST_CAUSES` takes time linear in the forest.
    """
    found: dict[int, int] = {}
    rest = list(misses)
    for _ in range(MOST_CAUSES):
        if sum(miss.square > LEAST * LEAST for miss in rest) < SEVERAL:
            break
        node = _blamed(forest, rest)
        if node is None:
            break
        inside = _below(forest, node)
        for miss in rest:
            base, of = forest.edges[miss.edge]
            if (base in inside) != (of in inside):
                found[miss.edge] = forest.parent[node][1]
        rest = [miss for miss in rest if miss.edge not in found]
    return found


def _blamed(forest: SpanningForest, misses: Sequence[Miss]) -> Term | None:
    """Return the lower end of the edge with most loops, among those whose loops miss alike."""
    odd, even = len(misses[0].odd), len(misses[0].even)
    sums: dict[Term, list[float]] = {}

    def put(node: Term, sign: float, times: float, miss: Miss) -> None:
        row = sums.setdefault(node, [0.0] * (odd + even + 2))
        numbers = (
            *(sign * each for each in miss.odd),
            *(times * each for each in (*miss.even, miss.square, 1.0)),
        )
        for place, number in enumerate(numbers):
            row[place] += number

    for miss in misses:
        base, of = forest.edges[miss.edge]
        put(of, 1.0, 1.0, miss)
        put(base, -1.0, 1.0, miss)
        put(forest.meet(base, of), 0.0, -2.0, miss)
    best: tuple[float, int, Term] | None = None
    for node in reversed(forest.order):
        row = sums.get(node)
        if row is None or node not in forest.parent:
            continue
        above, index = forest.parent[node]
        if _alike(row) and (best is None or (-row[-1], index, node) < best):
            best = -row[-1], index, node
        higher = sums.setdefault(above, [0.0] * len(row))
        for place, number in enumerate(row):
            higher[place] += number
    return None if best is None else best[2]


def _alike(row: Sequence[float]) -> bool:
    *mean, square, times = row
    if round(times) < SEVERAL:
        return False
    size = sum(each * each for each in mean) / (times * times)
    return size > LEAST * LEAST and square / times - size <= ALIKE * ALIKE * size


def _below(forest: SpanningForest, top: Term) -> set[Term]:
    inside = {top}
    for node in forest.order:
        if node in forest.parent and forest.parent[node][0] in inside:
            inside.add(node)
    return inside
