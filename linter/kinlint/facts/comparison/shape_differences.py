"""Differences of the collision shapes of rigid groups that correspond."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from operator import or_

from kinlint.facts.comparison.described_robot import Group, Shape
from kinlint.facts.comparison.measured import Measured, Parts
from kinlint.facts.comparison.pose import Pose
from kinlint.facts.comparison.tolerances import EXPORTED, Tolerances
from kinlint.facts.linear_algebra import Vector, angle, cross, length, product, subtract, transpose
from kinlint.light_dataclasses import replace

FEW = 64
"""Most collision shapes of a group that are compared one by one."""
AXIAL = frozenset({"cylinder", "capsule"})
"""Shapes that look alike however they are turned about their z axis."""


def shape_differences(
    here: Group, there: Group, pose: Pose, tolerances: Tolerances
) -> Iterator[Measured]:
    """Yield what is measured of collision shapes, of which *here* sees those *there* at *pose*.

    Shapes of one kind are paired, the nearest first. Nothing is if one group has none.
    """
    yours = [each._replace(pose=pose.of(each.pose)) for each in there.shapes]
    if not here.shapes or not yours or max(len(here.shapes), len(yours)) > FEW:
        return
    ends = here.main.node, there.main.node
    parts = Parts(here.name, there.name, *ends, tolerances, aspect="shape")
    kinds = [listed(each) for each in (here.shapes, yours)]
    yield parts.measured(
        "collision geometry", "", kinds[0], kinds[1], differs=kinds[0] != kinds[1], individual=False
    )
    for one, other in _paired(here.shapes, yours):
        sided = replace(parts, sides=(one.node, other.node))
        if one.kind == "mesh":
            yield sided.measured(
                "mesh", "", one.file, other.file, differs=one.file != other.file, individual=False
            )
            if one.file != other.file:
                continue
        yield from _sizes(sided, one, other)
        yield from _placed(sided, _ordered(one), _ordered(other))


def listed(shapes: Sequence[Shape]) -> str:
    """Return the kinds of *shapes* with their numbers, such as `2 box, 1 mesh`, or `none`."""
    kinds = sorted(each.kind for each in shapes)
    return ", ".join(f"{kinds.count(kind)} {kind}" for kind in dict.fromkeys(kinds)) or "none"


def _paired(mine: Sequence[Shape], yours: Sequence[Shape]) -> Iterator[tuple[Shape, Shape]]:
    distances = sorted(
        (length(subtract(a.pose.point, b.pose.point)) + _unlike(a, b), at, to)
        for at, a in enumerate(mine)
        for to, b in enumerate(yours)
        if a.kind == b.kind
    )
    done: set[int] = set()
    taken: set[int] = set()
    for _, at, to in distances:
        if at not in done and to not in taken:
            done.add(at)
            taken.add(to)
            yield mine[at], yours[to]


def _unlike(one: Shape, other: Shape) -> float:
    """Return how much the sizes of two shapes differ, in m; meshes of other files, 1 m."""
    sizes = zip(_edges(one), _edges(other), strict=True)
    return sum(abs(a - b) for a, b in sizes) + (one.file != other.file)


def _edges(shape: Shape) -> tuple[float, ...]:
    """Return the sizes of a shape, of a box in ascending order."""
    return tuple(sorted(shape.sizes)) if shape.kind == "box" else shape.sizes


def _sizes(parts: Parts, one: Shape, other: Shape) -> Iterator[Measured]:
    """Yield the sizes of two shapes of one kind."""
    if one.kind in {"box", "mesh"}:
        what, unit = ("size of the box", "m") if one.kind == "box" else ("scale of the mesh", "")
        pairs = zip(_edges(one), _edges(other), strict=True)
        differs = any(parts.tolerances.apart(a, b) for a, b in pairs)
        here, there = ((x, y, z) for x, y, z in (one.sizes, other.sizes))
        told = replace(parts, aspect=_aspect(one, other))
        yield told.measured(what, unit, here, there, differs=differs, individual=False)
        return
    parts = replace(parts, aspect=_aspect(one, other))
    for what, a, b in zip(("radius", "length"), one.sizes, other.sizes, strict=False):
        yield parts.number(f"{what} of the {one.kind}", "m", a, b, individual=False)


def _aspect(one: Shape, other: Shape) -> str:
    """Return `halved` if sizes of primitives are twice those of the other, and none is else."""
    if one.kind == "mesh":
        return "shape"
    pairs = [sorted(each) for each in zip(_edges(one), _edges(other), strict=True)]
    halves = [not EXPORTED.apart(2.0 * small, large) for small, large in pairs]
    equal = [not EXPORTED.apart(*each) for each in pairs]
    if one.kind == "box":
        return "halved" if all(halves) else "shape"
    return "halved" if any(halves) and all(map(or_, halves, equal)) else "shape"


def _placed(parts: Parts, one: Shape, other: Shape) -> Iterator[Measured]:
    """Yield the placement of two shapes of one kind."""
    place = f"place of the {one.kind}"
    away = parts.tolerances.away(one.pose.point, other.pose.point)
    yield parts.measured(
        place, "m", one.pose.point, other.pose.point, differs=away, individual=False
    )
    turned = _turned(one, other)
    yield parts.measured(
        f"orientation of the {one.kind}",
        "rad",
        0.0,
        turned,
        differs=turned > parts.tolerances.angle,
        individual=False,
    )


def _turned(one: Shape, other: Shape) -> float:
    """Return the greatest angle in rad between axes of two shapes, but for their symmetries."""
    mine, yours = transpose(one.pose.turn), transpose(other.pose.turn)
    if one.kind == "sphere":
        return 0.0
    if one.kind in AXIAL:
        return _between(mine[2], yours[2])
    if one.kind == "box":
        pair = (one.sizes, other.sizes)
        alone = [at for at in range(3) if all(each.count(each[at]) == 1 for each in pair)]
        return max((_between(mine[each], yours[each]) for each in alone), default=0.0)
    return angle(product(transpose(one.pose.turn), other.pose.turn))


def _between(one: Vector, other: Vector) -> float:
    """Return the angle in rad between two lines."""
    return math.asin(min(length(cross(one, other)), 1.0))


def _ordered(shape: Shape) -> Shape:
    """Return a box with its edges in ascending order, whichever axes they are along."""
    if shape.kind != "box":
        return shape
    axes = transpose(shape.pose.turn)
    order = sorted(range(3), key=lambda each: shape.sizes[each])
    x, y, z = (axes[each] for each in order)
    sizes = tuple(shape.sizes[each] for each in order)
    return shape._replace(sizes=sizes, pose=Pose(shape.pose.point, transpose((x, y, z))))
