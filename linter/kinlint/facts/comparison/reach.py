"""Reach of a robot: how far its chains extend within their limits.

The reach of a chain is the greatest distance of the farthest frame that its last joint carries from
the place of its first joint. It is found by coordinate ascent: with all other joints held, the
distance is a sinusoid of the angle of a hinge, and convex in the position of a slide, so that each
step is exact.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kinlint.facts.comparison.described_robot import DescribedRobot, MovingJoint
from kinlint.facts.linear_algebra import Vector, add, cross, dot, length, scale, subtract

SWEEPS = 200
"""Most rounds over all joints; distances converge after some ten."""
STARTS = 6
"""Configurations that the ascent begins with, against maxima that are only local."""
CHAINS = 8
"""Most chains of which the reach is computed: those that could be the longest."""
CONVERGED = 1e-10
"""Growth in m at which the ascent ends."""
GOLDEN = (math.sqrt(5.0) - 1.0) / 2.0
SIMPLE = frozenset({"revolute", "prismatic"})


class Reach(NamedTuple):
    """Chain that reaches farthest."""

    distance: float
    """Reach in m."""
    first: str
    """Name of its first joint."""
    last: str
    """Name of the body at its end."""


def reach(robot: DescribedRobot) -> Reach | None:
    """Return the reach of *robot*; None if it has none, or a chain is without bound or simple axes.

    Takes time linear in joints.
    """
    found = [_reach(robot, chain) for chain in _longest(robot)]
    known = [each for each in found if each is not None]
    if not known or len(known) < len(found):
        return None
    return max(known, key=lambda each: (each.distance, each.first))


def _longest(robot: DescribedRobot) -> Iterator[Sequence[MovingJoint]]:
    """Yield the chains with the longest links, from their first joints to their last."""
    above = {joint.child: joint for joint in robot.downward}
    bounds: dict[int, float] = {}
    for joint in robot.downward:
        before = bounds.get(joint.parent)
        step = length(joint.transform.point) if before is not None else 0.0
        travel = max(abs(each or 0.0) for each in (joint.lower, joint.upper))
        more = travel if joint.kind == "prismatic" else 0.0
        bounds[joint.child] = (before or 0.0) + step + more
    ends = [group for group in bounds if robot.sizes[group] == 0]
    for end in sorted(ends, key=lambda group: (-bounds[group], group))[:CHAINS]:
        way = []
        group = end
        while group in above:
            way.append(above[group])
            group = above[group].parent
        yield way[::-1]


def _reach(robot: DescribedRobot, chain: Sequence[MovingJoint]) -> Reach | None:
    if any(each.kind not in SIMPLE or each.axis is None for each in chain):
        return None
    if any(each.kind == "prismatic" and None in {each.lower, each.upper} for each in chain):
        return None
    last = chain[-1]
    bodies = robot.groups[last.child].bodies
    body = max(bodies, key=lambda each: length(subtract(each.pose.point, last.anchor)))
    best = max(_ascent(chain, body.pose.point, _start(chain, number)) for number in range(STARTS))
    return Reach(best, chain[0].name, body.name)


def _start(chain: Sequence[MovingJoint], number: int) -> list[float]:
    """Return a configuration: all at zero first, then spread over the ranges."""
    found = []
    for index, joint in enumerate(chain):
        lower = -math.pi if joint.lower is None else joint.lower
        upper = math.pi if joint.upper is None else joint.upper
        share = math.modf((index + 1) * number * GOLDEN)[0]
        spread = lower + share * (upper - lower)
        found.append(min(max(0.0, lower), upper) if number == 0 else spread)
    return found


def _moved(joint: MovingJoint, at: float, point: Vector) -> Vector:
    """Return where *point* of the child is, as the child's frame at zero sees it."""
    axis = joint.axis or (0.0, 0.0, 1.0)
    if joint.kind == "prismatic":
        return add(point, scale(at, axis))
    arm = subtract(point, joint.anchor)
    along = scale(dot(arm, axis), axis)
    across = subtract(arm, along)
    turned = add(scale(math.cos(at), across), scale(math.sin(at), cross(axis, arm)))
    return add(joint.anchor, add(along, turned))


def _ascent(chain: Sequence[MovingJoint], tip: Vector, at: list[float]) -> float:
    """Return the distance of *tip* from the first joint that the ascent from *at* leads to."""
    reached = 0.0
    for _ in range(SWEEPS):
        tips = [tip]
        for joint, position in zip(reversed(chain[1:]), reversed(at[1:]), strict=True):
            tips.append(joint.transform.at(_moved(joint, position, tips[-1])))
        base = chain[0].anchor
        for index, joint in enumerate(chain):
            point = tips[len(chain) - 1 - index]
            if index > 0:
                base = joint.transform.inverse.at(base)
            at[index] = _best(joint, point, base)
            base = _moved(joint, -at[index], base)
        distance = length(subtract(tip, base))
        if distance - reached < CONVERGED:
            return max(distance, reached)
        reached = distance
    return reached


def _best(joint: MovingJoint, point: Vector, base: Vector) -> float:
    """Return the position of *joint* that takes *point* of its child farthest from *base*."""
    axis = joint.axis or (0.0, 0.0, 1.0)
    if joint.kind == "prismatic":
        ends = (joint.lower or 0.0, joint.upper or 0.0)
        return max(ends, key=lambda each: length(subtract(_moved(joint, each, point), base)))
    arm, other = subtract(point, joint.anchor), subtract(base, joint.anchor)
    across = subtract(arm, scale(dot(arm, axis), axis))
    best = math.atan2(dot(other, cross(axis, arm)), dot(other, across)) + math.pi
    lower, upper = joint.lower, joint.upper
    if lower is None or upper is None:
        return best
    best += 2.0 * math.pi * math.ceil((lower - best) / (2.0 * math.pi))
    if best <= upper:
        return best
    return max((lower, upper), key=lambda each: length(subtract(_moved(joint, each, point), base)))
