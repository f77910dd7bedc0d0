"""Loops of points whose relative positions are known."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kinlint.facts.common_cause import common_causes, shifted
from kinlint.facts.linear_algebra import ZERO, Vector, add, apply, length, subtract
from kinlint.facts.orientation_graph import MOST_MEMBERS, Circle, OrientationGraph
from kinlint.facts.spanning_forest import SpanningForest
from kinlint.facts.spatial_relations import RelativePosition
from kinlint.terms import Term


class PositionLoop(NamedTuple):
    """Loop of positions, with the sum in m of the lengths of its relations."""

    circle: Circle
    magnitude: float


def position_loops(
    shifts: Sequence[RelativePosition], attitudes: OrientationGraph
) -> Iterator[PositionLoop]:
    """Yield each independent loop of positions, with the distance in m that it misses.

    Vectors add up only as far as the frames that see them are parallel or their orientation is
    known.
    """
    groups: dict[Term, list[int]] = {}
    for index, shift in enumerate(shifts):
        groups.setdefault(attitudes.group(shift.seen_by), []).append(index)
    for members in groups.values():
        if len(members) > 1 or shifts[members[0]].base == shifts[members[0]].of:
            yield from _circles([shifts[index] for index in members], members, attitudes)


def _circles(
    shifts: Sequence[RelativePosition], names: Sequence[int], attitudes: OrientationGraph
) -> Iterator[PositionLoop]:
    forest = SpanningForest([(shift.base, shift.of) for shift in shifts])
    if not forest.closing:
        return
    steps = [apply(attitudes.matrix(shift.seen_by), shift.vector) for shift in shifts]
    there: dict[Term, Vector] = {}
    far: dict[Term, float] = {}
    for node in forest.order:
        if node not in forest.parent:
            there[node], far[node] = ZERO, 0.0
            continue
        above, index = forest.parent[node]
        move = add if shifts[index].of == node else subtract
        there[node] = move(there[above], steps[index])
        far[node] = far[above] + length(steps[index])
    missing = {
        index: subtract(add(there[shifts[index].base], steps[index]), there[shifts[index].of])
        for index in forest.closing
    }
    causes = common_causes(forest, [shifted(*each) for each in missing.items()])
    for index, by in missing.items():
        base, of = shifts[index].base, shifts[index].of
        magnitude = far[base] + far[of] - 2.0 * far[forest.meet(base, of)] + length(steps[index])
        way = (names[each] for each in forest.way(base, of, MOST_MEMBERS - 1))
        cause = names[causes[index]] if index in causes else None
        circle = Circle((names[index], *way), forest.between(base, of) + 1, length(by), cause)
        yield PositionLoop(circle, magnitude)
