"""Loops of poses, positions and orientations, and the error by which they fail to close."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import count
from typing import NamedTuple

from kinlint.facts.common_cause import common_causes, shifted
from kinlint.facts.fact_statements import MEMBER, derived, fact, fact_node, integer, numbers
from kinlint.facts.linear_algebra import ZERO, Vector, add, apply, length, subtract
from kinlint.facts.orientation_graph import MOST_MEMBERS, Loop, OrientationGraph
from kinlint.facts.spanning_forest import SpanningForest
from kinlint.facts.spatial_relations import RelativeOrientation, RelativePosition, SpatialRelations
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import RDF_TYPE, Term, Triple


@dataclass
class Cycle:
    """Loop of relations that one relation closes."""

    members: dict[Term, None] = field(default_factory=dict)
    """Relations of the loop, in its order."""
    sources: dict[Term, None] = field(default_factory=dict)
    """Coordinates that state them."""
    length: int = 0
    """Number of relations of the longest loop."""
    values: list[tuple[str, float]] = field(default_factory=list)
    """Closing errors, by the name of the fact that states each."""
    cause: Term | None = None
    """Relation that explains the errors of several loops; None if none does."""

    def extend(
        self,
        edges: Iterable[RelativeOrientation | RelativePosition],
        length: int,
        values: Iterable[tuple[str, float]],
    ) -> None:
        """Add the loop of orientations or that of positions."""
        for edge in edges:
            self.members[edge.relation] = None
            self.sources[edge.source] = None
        self.length = max(self.length, length)
        self.values += values


def cycles(relations: SpatialRelations, orientations: OrientationGraph) -> Iterator[Triple]:
    """Yield each independent loop, under the relation that comes last in it."""
    found: dict[Term, Cycle] = {}
    turns, shifts = relations.turns, relations.shifts
    for edges, size, residual, cause in orientations.loops():
        cycle = found.setdefault(turns[edges[0]].relation, Cycle())
        if cause is not None:
            cycle.cause = turns[cause].relation
        cycle.extend([turns[index] for index in edges], size, [("angle", residual)])
    for (edges, size, residual, cause), magnitude in position_loops(shifts, orientations):
        cycle = found.setdefault(shifts[edges[0]].relation, Cycle())
        if cause is not None and cycle.cause is None:
            cycle.cause = shifts[cause].relation
        values = [("distance", residual), ("magnitude", magnitude)]
        cycle.extend([shifts[index] for index in edges], size, values)
    names = count(1)
    for relation, cycle in found.items():
        node = fact_node("cycle", next(names))
        yield node, RDF_TYPE, fact("Cycle")
        yield node, fact("closed-by"), relation
        yield node, fact("length"), integer(cycle.length)
        if cycle.cause is not None:
            yield node, fact("traced-to"), cycle.cause
        yield from numbers(node, cycle.values)
        for member in list(cycle.members)[:MOST_MEMBERS]:
            yield node, MEMBER, member
        yield from derived(node, list(cycle.sources)[:MOST_MEMBERS])


class PositionLoop(NamedTuple):
    """Loop of positions, with the sum in m of the lengths of its relations."""

    circle: Loop
    """The loop."""
    magnitude: float
    """Sum of the lengths of its relations in m."""


def position_loops(
    shifts: Sequence[RelativePosition], orientations: OrientationGraph
) -> Iterator[PositionLoop]:
    """Yield each independent loop of positions, with the distance in m that it misses.

    Vectors add up only as far as the frames that see them are parallel or their orientation is
    known.
    """
    groups: dict[Term, list[int]] = {}
    for index, shift in enumerate(shifts):
        groups.setdefault(orientations.group(shift.seen_by), []).append(index)
    for members in groups.values():
        if len(members) > 1 or shifts[members[0]].base == shifts[members[0]].of:
            yield from _cycles([shifts[index] for index in members], members, orientations)


def _cycles(
    shifts: Sequence[RelativePosition], names: Sequence[int], orientations: OrientationGraph
) -> Iterator[PositionLoop]:
    forest = SpanningForest([(shift.base, shift.of) for shift in shifts])
    if not forest.closing:
        return
    steps = [apply(orientations.matrix(shift.seen_by), shift.vector) for shift in shifts]
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
        circle = Loop((names[index], *way), forest.between(base, of) + 1, length(by), cause)
        yield PositionLoop(circle, magnitude)
