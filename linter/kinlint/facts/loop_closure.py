"""Loops of poses, positions and orientations, and the error by which they fail to close."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from itertools import count

from kinlint.facts.fact_statements import MEMBER, derived, fact, fact_node, integer, numbers
from kinlint.facts.orientation_graph import MOST_MEMBERS, OrientationGraph
from kinlint.facts.position_loops import position_loops
from kinlint.facts.spatial_relations import RelativeOrientation, RelativePosition, SpatialRelations
from kinlint.terms import RDF_TYPE, Term, Triple


@dataclass
class Cycle:
    """Loop of relations that one relation closes."""

    members: dict[Term, None] = field(default_factory=dict)
    sources: dict[Term, None] = field(default_factory=dict)
    length: int = 0
    values: list[tuple[str, float]] = field(default_factory=list)
    cause: Term | None = None

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


def cycles(relations: SpatialRelations, attitudes: OrientationGraph) -> Iterator[Triple]:
    """Yield each independent loop, under the relation that comes last in it."""
    found: dict[Term, Cycle] = {}
    turns, shifts = relations.turns, relations.shifts
    for edges, length, residual, cause in attitudes.circles():
        cycle = found.setdefault(turns[edges[0]].relation, Cycle())
        if cause is not None:
            cycle.cause = turns[cause].relation
        cycle.extend([turns[index] for index in edges], length, [("angle", residual)])
    for (edges, length, residual, cause), magnitude in position_loops(shifts, attitudes):
        cycle = found.setdefault(shifts[edges[0]].relation, Cycle())
        if cause is not None and cycle.cause is None:
            cycle.cause = shifts[cause].relation
        values = [("distance", residual), ("magnitude", magnitude)]
        cycle.extend([shifts[index] for index in edges], length, values)
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
