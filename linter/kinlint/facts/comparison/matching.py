"""Correspondence of the joints and rigid groups of two descriptions of one robot.

By the names of joints where enough are shared, else by structure and numbers: from groups that
correspond, such as the roots, joints of one kind about the same line lead to groups that correspond
in turn. A joint may be written from either of its ends, so that descriptions may have other roots.
Takes time linear in joints, but for groups of many joints.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TypeAlias

from kinlint.facts.comparison.described_robot import DescribedRobot, MovingJoint
from kinlint.facts.comparison.frame_alignment import (
    Alignment,
    line_distance,
    on_parent,
    tilt,
    total_mass,
)
from kinlint.facts.comparison.name_matching import are_enough, same_names, similar_names
from kinlint.facts.comparison.pose import HERE, Pose
from kinlint.facts.comparison.tolerances import EXPORTED
from kinlint.facts.linear_algebra import Vector, subtract
from kinlint.light_dataclasses import dataclass, field

CROWD = 10_000
"""Most pairs of joints at one group that are compared one by one."""
UNLIKE = 10.0
"""Cost of a match of joints of different kinds, in m of distance between their axes."""
ANCHORS = 4
"""Most pairs of groups of one unmistakable mass from which a match is tried."""

Pair: TypeAlias = tuple[int, int]


@dataclass
class Correspondence:
    """Parts of one robot that are parts of the other, by their indices."""

    joints: dict[int, int] = field(default_factory=dict)
    """Joints that are the same."""
    groups: dict[int, int] = field(default_factory=dict)
    """Rigid groups that are the same."""
    poses: dict[int, Pose] = field(default_factory=dict)
    """Pose of the frame of the other group as each group sees it."""
    by_name: bool = False
    """True if the names of joints tell which are the same."""


def correspondence(one: DescribedRobot, other: DescribedRobot) -> Correspondence:
    """Return which parts of both robots are the same."""
    named = same_names(one, other)
    if are_enough(named, one, other):
        found = Matching(one, other, named).grow(_voted(one, other, named))
        found.by_name = True
        return found
    tries: list[Correspondence] = []
    named = similar_names(one, other)
    if are_enough(named, one, other):
        tries.append(Matching(one, other, named).grow(_voted(one, other, named)))
    anchors = list(_anchors(one, other))
    if one.roots and other.roots:
        seeds = [(one.roots[0], other.roots[0]), *anchors]
        tries.append(Matching(one, other, {}).grow(seeds))
    if not tries or max(_fit(one, other, each) for each in tries) < len(one.joints):
        tries += (Matching(one, other, {}).grow([pair, *anchors]) for pair in anchors)
    return max(tries, key=lambda each: _fit(one, other, each), default=Correspondence())


def _voted(one: DescribedRobot, other: DescribedRobot, named: Mapping[int, int]) -> Sequence[Pair]:
    """Return the pairs of groups that joints and bodies of the same name speak for, best first."""
    votes: dict[Pair, int] = {}
    for mine, yours in named.items():
        a, b = one.joints[mine], other.joints[yours]
        for pair in ((a.parent, b.parent), (a.child, b.child)):
            if min(pair) >= 0:
                votes[pair] = votes.get(pair, 0) + 1
    homes = {body.name: index for index, body in other.bodies()}
    for index, body in one.bodies():
        if body.name in homes:
            pair = (index, homes[body.name])
            votes[pair] = votes.get(pair, 0) + 2
    depth = {group: at for at, group in enumerate(_order(one))}
    return sorted(votes, key=lambda pair: (-min(votes[pair], 3), depth.get(pair[0], 0), pair))


def _order(robot: DescribedRobot) -> Iterator[int]:
    yield from robot.roots
    yield from (joint.child for joint in robot.downward)


def _anchors(one: DescribedRobot, other: DescribedRobot) -> Iterator[Pair]:
    """Yield pairs of groups that may be the same, whatever the roots are.

    Those of a mass that no other group has, the heaviest first.
    """
    masses = [_distinct(each) for each in (one, other)]
    common = sorted(masses[0].keys() & masses[1].keys(), reverse=True)
    yield from ((masses[0][mass], masses[1][mass]) for mass in common[:ANCHORS])


def _distinct(robot: DescribedRobot) -> Mapping[float, int]:
    """Return the groups by their masses, to three digits, that only one has."""
    found: dict[float, list[int]] = {}
    for index, group in enumerate(robot.groups):
        if (mass := total_mass(group)) > 0.0:
            found.setdefault(float(f"{mass:.2e}"), []).append(index)
    return {mass: groups[0] for mass, groups in found.items() if len(groups) == 1}


def _fit(one: DescribedRobot, other: DescribedRobot, found: Correspondence) -> float:
    """Return the number of joints that correspond, those whose placement agrees in full."""
    fit = 0.0
    for mine, yours in found.joints.items():
        a, b = one.joints[mine], other.joints[yours]
        pose, beyond = found.poses.get(a.parent), found.poses.get(a.child)
        if pose is None or beyond is None or found.groups.get(a.parent) not in (b.parent, b.child):
            continue
        if found.groups[a.parent] != b.parent:
            b = b.reversed
        there = pose.at(b.transform.at(beyond.inverse.at(a.anchor)))
        fit += 0.5 + 0.5 * (not EXPORTED.away(a.transform.at(a.anchor), there))
    return fit


def _rounded(point: Vector) -> tuple[int, ...]:
    return tuple(round(each / EXPORTED.distance) for each in point)


def _child_poses(here: MovingJoint, there: MovingJoint, pose: Pose) -> Sequence[Pose]:
    """Return where the child of *there* may be as the child of *here* sees it, the likeliest first.

    The files draw its frame alike; or turned as at zero, with the origins of the joints together;
    or exactly where it is at zero.
    """
    beyond = here.transform.inverse.of(pose).of(there.transform)
    hinged = Pose(subtract(here.anchor, beyond.along(there.anchor)), beyond.turn)
    if pose.turn == HERE.turn and here.axis is not None:
        return HERE, hinged, beyond
    return hinged, beyond, HERE


class Matching:
    """Growth of a correspondence; *named* are joints that are taken to be the same."""

    def __init__(
        self, one: DescribedRobot, other: DescribedRobot, named: Mapping[int, int]
    ) -> None:
        self.one = one
        self.other = other
        self.named = named
        self.alignment = Alignment(one, other, named)
        self.found = Correspondence()
        self.taken: set[int] = set()
        self.reached: set[int] = set()

    def grow(self, seeds: Iterable[Pair]) -> Correspondence:
        """Return what corresponds if the groups of each of *seeds* do."""
        for mine, yours in seeds:
            if self._are_free(mine, yours):
                self._join(mine, yours, self.alignment.pose(mine, yours, [HERE], searching=True))
                waiting = deque([mine])
                while waiting:
                    waiting.extend(self._spread(waiting.popleft()))
        for mine, yours in self.named.items():
            if mine not in self.found.joints and yours not in self.taken:
                self._pair(mine, yours)
        self._join_ends()
        return self.found

    def _join_ends(self) -> None:
        """Match the joints that are left between groups that correspond, whatever their kind."""
        left: dict[frozenset[int], list[int]] = {}
        for index, joint in enumerate(self.other.joints):
            if index not in self.taken and joint.is_complete:
                left.setdefault(frozenset((joint.parent, joint.child)), []).append(index)
        for index, joint in enumerate(self.one.joints):
            ends = [self.found.groups.get(each, -1) for each in (joint.parent, joint.child)]
            if index not in self.found.joints and (there := left.pop(frozenset(ends), None)):
                self._pair(index, there[0])

    def _are_free(self, mine: int, yours: int) -> bool:
        return mine not in self.found.groups and yours not in self.reached

    def _join(self, mine: int, yours: int, pose: Pose) -> None:
        self.found.groups[mine] = yours
        self.found.poses[mine] = pose
        self.reached.add(yours)

    def _pair(self, mine: int, yours: int) -> None:
        self.found.joints[mine] = yours
        self.taken.add(yours)

    def _spread(self, mine: int) -> Iterator[int]:
        """Match the joints at a group that corresponds; yield the groups behind them."""
        yours, pose = self.found.groups[mine], self.found.poses[mine]
        for a, b in self._assigned(mine, yours, pose):
            here, there = self.one.seen_from(a, mine), self.other.seen_from(b, yours)
            known = self.found.groups.get(here.child)
            if known is None and there.child not in self.reached:
                self._pair(a, b)
                guesses = _child_poses(here, there, pose)
                aligned = self.alignment.pose(here.child, there.child, guesses, searching=False)
                self._join(here.child, there.child, aligned)
                yield here.child
            elif known == there.child:
                self._pair(a, b)

    def _assigned(self, mine: int, yours: int, pose: Pose) -> Iterator[Pair]:
        """Yield joints at two groups that correspond: those of one name, then the nearest ones."""
        near = frozenset(self.other.around[yours])
        left = []
        for index in self.one.around[mine]:
            if index in self.found.joints:
                continue
            if index not in self.named:
                left.append(index)
            elif self.named[index] in near and self.named[index] not in self.taken:
                yield index, self.named[index]
        partners = frozenset(self.named.values())
        free = sorted(near - partners - self.taken)
        if len(left) * len(free) > CROWD:
            yield from self._exactly_placed(mine, yours, left, free, pose)
            return
        here = {each: self.one.seen_from(each, mine) for each in left}
        there = {each: self.other.seen_from(each, yours) for each in free}
        costs = sorted((self._cost(here[a], there[b], pose), a, b) for a in left for b in free)
        done: set[int] = set()
        for cost, a, b in costs:
            if cost < UNLIKE and a not in done and b not in self.taken:
                done.add(a)
                yield a, b

    def _exactly_placed(
        self, mine: int, yours: int, left: Iterable[int], free: Iterable[int], pose: Pose
    ) -> Iterator[Pair]:
        """Yield the joints whose origins are the same to a millimetre, if only these two are."""
        places: dict[tuple[int, ...], list[int]] = {}
        for b in free:
            point = pose.at(on_parent(self.other.seen_from(b, yours))[0])
            places.setdefault(_rounded(point), []).append(b)
        for a in left:
            found = places.pop(_rounded(on_parent(self.one.seen_from(a, mine))[0]), [])
            if len(found) == 1:
                yield a, found[0]

    def _cost(self, here: MovingJoint, there: MovingJoint, pose: Pose) -> float:
        """Return how unlike two joints are that groups with frames in *pose* carry, in m."""
        cost = UNLIKE * (here.kind != there.kind)
        point, axis = on_parent(here)
        other, direction = on_parent(there)
        cost += line_distance(point, axis, pose.at(other))
        cost += 0.1 * line_distance(point, None, pose.at(other))
        if axis is not None and direction is not None:
            cost += 0.3 * tilt(axis, pose.along(direction))
        sizes = self.one.sizes[here.child], self.other.sizes[there.child]
        return cost + 0.5 * abs(sizes[0] - sizes[1]) / (1 + max(sizes))
