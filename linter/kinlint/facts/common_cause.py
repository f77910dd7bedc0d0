"""Which one relation is to blame where several cycles miss alike."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from kinlint.facts.linear_algebra import Matrix, Vector
from kinlint.facts.spanning_forest import SpanningForest
from kinlint.terms import Term

LEAST = 1e-4
"""What misses by less, in rad or m, has no cause to search for: rounding is enough."""

ALIKE = 0.1
"""How far misses may spread about their mean, as a part of it, to count as one and the same."""

SEVERAL = 2
"""One cycle that misses may do so because of any of its relations."""

MOST_CAUSES = 8


class Miss(NamedTuple):
    """By what a closing edge misses: numbers that change sign with its direction, and others."""

    edge: int
    odd: tuple[float, ...]
    even: tuple[float, ...] = ()

    @property
    def square(self) -> float:
        """Its size, squared."""
        return sum(each * each for each in (*self.odd, *self.even))


def shifted(edge: int, by: Vector) -> Miss:
    """A miss by a vector."""
    return Miss(edge, by)


def turned(edge: int, by: Matrix) -> Miss:
    """A miss by a rotation; its size is the norm of the difference from none."""
    (a, b, c), (d, e, f), (g, h, i) = by
    root = math.sqrt(0.5)
    odd = tuple(root * each for each in (h - f, c - g, d - b))
    even = (a - 1.0, e - 1.0, i - 1.0, *(root * each for each in (h + f, c + g, d + b)))
    return Miss(edge, odd, even)


def common_causes(forest: SpanningForest, misses: Sequence[Miss]) -> Mapping[int, int]:
    """The edge to blame for each closing edge that misses like all others that cross that edge.

    An edge is to blame if two or more cycles go through it and all of them miss by the same. Each
    of at most `MOST_CAUSES` takes time linear in the forest.
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
    """The lower end of the edge that most cycles go through, of those where all miss alike."""
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
