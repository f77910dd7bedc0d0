"""Loops of joints that turn only: their sides are lengths that no motion changes.

A side is the distance of two attachments of one body, or the origin offset of a joint. Whatever the
angles of the joints, a polygon of such sides closes only if the longest is not above the sum of the
others (for four bars: Grashof 1883, Theoretische Maschinenlehre).
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import NamedTuple

from kinlint.facts.fact_statements import fact, numbers
from kinlint.facts.joint_trees import Edge
from kinlint.facts.linear_algebra import length, subtract
from kinlint.facts.mechanism import Mechanism
from kinlint.facts.spanning_forest import SpanningForest
from kinlint.facts.spatial_relations import RelativePosition, SpatialRelations
from kinlint.terms import Term, Triple

TURNING = frozenset({"revolute", "universal", "spherical"})
"""Joints that leave the points of their attachments at one distance."""
MOST = 64
"""Most joints of a loop that is looked at."""
PAIR = 2
"""The bodies and the attachments of a joint, and the attachments of a body of a loop."""


class Side(NamedTuple):
    """A length of a loop."""

    length: float
    """The length in m."""
    source: Term
    """Coordinates that state it."""


def stretched_loops(mechanism: Mechanism, relations: SpatialRelations) -> Iterator[Triple]:
    """Yield each independent loop with a side that is longer than all its others together.

    Loops with a joint that slides, or with an unknown side, are left out.
    """
    told = set[Term]()
    for joint, sides in _Linkage(mechanism, relations).loops():
        longest = max(sides)
        rest = sum(each.length for each in sides) - longest.length
        if longest.length > rest * (1.0 + 1e-6) + 1e-6 and longest.source not in told:
            told.add(longest.source)
            yield longest.source, fact("closing-joint"), joint
            lengths = [("side-length", longest.length), ("other-sides", rest)]
            yield from numbers(longest.source, lengths)


class _Linkage:
    """Bodies and joints as a graph, and the distances between points of the bodies."""

    def __init__(self, mechanism: Mechanism, relations: SpatialRelations) -> None:
        self.mechanism = mechanism
        self.relations = relations

    def loops(self) -> Iterator[tuple[Term, Sequence[Side]]]:
        """Yield the joint that closes each loop, and the sides of the loop."""
        edges = [each for each in self.mechanism.edges if len(each.ends) == PAIR]
        forest = SpanningForest([(each.ends[0], each.ends[1]) for each in edges])
        for closing in forest.closing:
            one, other = edges[closing].ends
            if forest.between(one, other) < MOST:
                loop = [edges[closing], *(edges[at] for at in forest.way(one, other, MOST))]
                sides = self._sides(loop)
                if sides is not None:
                    yield edges[closing].joint, sides

    def _sides(self, loop: Sequence[Edge]) -> Sequence[Side] | None:
        if any(self.mechanism.kind(each.joint) not in TURNING for each in loop):
            return None
        points: dict[Term, list[Term]] = {}
        sides: list[Side | None] = []
        for edge in loop:
            ends = self.mechanism.attachments(edge.joint)
            if len(ends) != PAIR:
                return None
            one, other = map(self.relations.point, ends)
            sides.append(self._distance(one, other))
            for end in ends:
                body = self.mechanism.carrier.get(end, end)
                points.setdefault(body, []).append(self.relations.point(end))
        for found in points.values():
            if len(found) != PAIR:
                return None
            sides.append(self._distance(*found))
        known = [each for each in sides if each is not None]
        return known if len(known) == len(sides) else None

    def _distance(self, one: Term, other: Term) -> Side | None:
        """Return how far two points of a body are apart; None if that is not stated."""
        for first, second in ((one, other), (other, one)):
            for shift in self._shifts.get(first, ()):
                if shift.base == second:
                    return Side(length(shift.vector), shift.source)
        for shift in self._shifts.get(one, ()):
            for mate in self._shifts.get(other, ()):
                if (shift.base, shift.seen_by) == (mate.base, mate.seen_by):
                    return Side(length(subtract(shift.vector, mate.vector)), shift.source)
        return None

    @cached_property
    def _shifts(self) -> Mapping[Term, Sequence[RelativePosition]]:
        """The positions of each point."""
        found: dict[Term, list[RelativePosition]] = {}
        for shift in self.relations.shifts:
            found.setdefault(shift.of, []).append(shift)
        return found
