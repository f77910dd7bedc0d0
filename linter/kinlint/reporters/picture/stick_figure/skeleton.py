"""Skeleton of a robot: its links as sticks and its joints as places, in pixels."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

from kinlint.light_dataclasses import dataclass
from kinlint.structure import Joint, Link, Structure, Vector

RADIUS = 160.0
"""Radius in pixels of the ball that all of a robot lies in."""
GAP = 0.25
"""Space between trees, relative to their size."""


@dataclass(frozen=True, slots=True)
class Stick:
    """Straight part of a link, from its joint to another place on it."""

    link: Link
    """Link that it is of."""
    start: Vector
    """Place where its joint is, or its origin."""
    end: Vector
    """Place of the next joint, or of the centre of mass of the last link."""
    tip: bool = False
    """True if it ends at a centre of mass."""

    @property
    def vector(self) -> Vector:
        """Vector from start to end."""
        (a, b, c), (x, y, z) = self.start, self.end
        return x - a, y - b, z - c

    @property
    def middle(self) -> Vector:
        """Middle between start and end."""
        (a, b, c), (x, y, z) = self.start, self.end
        return (a + x) / 2.0, (b + y) / 2.0, (c + z) / 2.0


class Skeleton:
    """Places of all parts of a robot that has any, in pixels from its middle, z upwards."""

    def __init__(self, structure: Structure) -> None:
        self.structure = structure
        self._carrier = {
            end: joint
            for joint in reversed(structure.joints)
            if not joint.closes
            for end in (joint.child, *joint.others)
            if end is not None
        }

    @property
    def is_stated(self) -> bool:
        """True if a joint has a place that files state, and the robot a size."""
        return any(each.placed and each.point for each in self.structure.joints) and self.size > 0.0

    def _start(self, link: Link) -> Vector | None:
        """Return where *link* begins, in m: at its joint."""
        joint = self._carrier.get(link.iri)
        if joint is None:
            return link.point
        return joint.end or joint.point or link.point

    @cached_property
    def _sticks(self) -> Sequence[Stick]:
        """Sticks of all links in m, at least one of each that has a place."""
        closing: dict[str, list[Joint]] = {}
        for joint in self.structure.loops:
            closing.setdefault(joint.child or "", []).append(joint)
        found: list[Stick] = []
        for link in self.structure.links:
            start = self._start(link)
            if start is None:
                continue
            below = self.structure.below(link.iri)
            ends = [each.point for each in below] + [each.end for each in closing.get(link.iri, ())]
            apart = dict.fromkeys(end for end in ends if end is not None and end != start)
            found += (Stick(link, start, end) for end in apart)
            if not apart:
                centre = (not below and link.centre) or start
                found.append(Stick(link, start, centre, tip=centre != start))
        return found

    @cached_property
    def _tree_of(self) -> Mapping[str, int]:
        """Number of the tree of each part."""
        found: dict[str, int] = {}
        trees = -1
        for step in self.structure.steps():
            trees += step.above < 0
            found.setdefault(step.part.iri, trees)
        return found

    @cached_property
    def _moves(self) -> Mapping[int, float]:
        """Distance in m along y by which each tree stands beside the one before."""
        spans: dict[int, tuple[float, float]] = {}
        for each in self._sticks:
            tree = self._tree_of.get(each.link.iri, 0)
            sides = each.start[1], each.end[1], *spans.get(tree, ())
            spans[tree] = min(sides), max(sides)
        least = GAP * max((math.dist(one.start, one.end) for one in self._sticks), default=0.0)
        found: dict[int, float] = {}
        at = 0.0
        for number, (tree, (low, high)) in enumerate(sorted(spans.items())):
            found[tree] = at - low if number else 0.0
            at = (at if number else low) + (high - low) + max(GAP * (high - low), least)
        return found

    def _moved(self, point: Vector, part: str) -> Vector:
        x, y, z = point
        return x, y + self._moves.get(self._tree_of.get(part, 0), 0.0), z

    @cached_property
    def _bounds(self) -> tuple[Vector, Vector]:
        """Least and greatest coordinates in m."""
        points = [
            self._moved(point, each.link.iri)
            for each in self._sticks
            for point in (each.start, each.end)
        ]
        if not points:
            return (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
        (x, y, z), (u, v, w) = (tuple(map(side, zip(*points, strict=True))) for side in (min, max))
        return (x, y, z), (u, v, w)

    @property
    def size(self) -> float:
        """Diagonal in m of the box around the robot; 0 if it has none or an endless one."""
        found = math.dist(*self._bounds)
        return found if math.isfinite(found) else 0.0

    @property
    def scale(self) -> float:
        """Number of pixels in a metre."""
        return 2.0 * RADIUS / self.size

    def pixels(self, point: Vector, part: str) -> Vector:
        """Return a point in m of the tree that *part* is in, in pixels."""
        low, high = self._bounds
        x, y, z = (
            (value - (least + most) / 2.0) * self.scale
            for value, least, most in zip(self._moved(point, part), low, high, strict=True)
        )
        return x, y, z

    @property
    def floor(self) -> float:
        """Height of the lowest point in pixels, above the middle."""
        low, high = self._bounds
        return (low[2] - high[2]) / 2.0 * self.scale

    def sticks(self) -> Iterator[Stick]:
        """Yield the sticks of all links, in pixels."""
        for each in self._sticks:
            start, end = (self.pixels(point, each.link.iri) for point in (each.start, each.end))
            yield Stick(each.link, start, end, tip=each.tip)

    def joints(self) -> Iterator[tuple[Joint, Vector]]:
        """Yield the joints that have a place, with it in pixels."""
        for joint in self.structure.joints:
            if joint.point is not None:
                yield joint, self.pixels(joint.point, joint.iri)
