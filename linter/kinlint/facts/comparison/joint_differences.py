"""Differences of joints that correspond: movement, placement, axis and limits."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.facts.comparison.described_robot import MovingJoint
from kinlint.facts.comparison.frame_alignment import line_distance
from kinlint.facts.comparison.measured import Measured, Parts
from kinlint.facts.comparison.pose import Pose
from kinlint.facts.comparison.tolerances import EXPORTED, Tolerances
from kinlint.facts.linear_algebra import angle, product, scale, transpose
from kinlint.light_dataclasses import replace

LINEAR = "prismatic"
TURNING = {"revolute": "place of the axis", "spherical": "place of the centre"}
"""Movements about a line, along which the origin of the joint may be anywhere, or about a point."""


def joint_differences(  # noqa: PLR0913
    here: MovingJoint,
    there: MovingJoint,
    near: Pose | None,
    beyond: Pose | None,
    tolerances: Tolerances,
    *,
    ranged: bool,
) -> Iterator[Measured]:
    """Yield what is measured of a joint in two descriptions.

    *near* is the pose of the frame of its other parent as its parent sees it, and *beyond* that of
    its other child as its child does; None where they do not correspond. If not *ranged*, a joint
    without limits may have some.
    """
    parts = Parts(here.name, there.name, here.node, there.node, tolerances)
    yield parts.measured(
        "movement", "", here.kind, there.kind, differs=here.kind != there.kind, individual=False
    )
    if here.kind != there.kind:
        return
    mirrored = False
    if near is not None and beyond is not None:
        axes = list(_axes(parts, here, there, beyond))
        yield from axes
        mirrored = any(_is_opposite(each) for each in axes)
        moved = any(each.differs for each in axes)
        placed = replace(parts, aspect="placement")
        yield from _placements(placed, here, there, near, beyond, moved=moved)
    yield from _limits(parts, here, there, mirrored=mirrored, ranged=ranged)


def _axes(parts: Parts, here: MovingJoint, there: MovingJoint, beyond: Pose) -> Iterator[Measured]:
    """Yield the directions of the axis, as the child sees them."""
    if here.axis is not None and there.axis is not None:
        other = beyond.along(there.axis)
        differs = parts.tolerances.turned(here.axis, other)
        yield parts.measured("axis", "", here.axis, other, differs=differs, individual=False)


def _is_opposite(axes: Measured) -> bool:
    if not axes.differs or not isinstance(axes.here, tuple) or not isinstance(axes.other, tuple):
        return False
    return not EXPORTED.turned(axes.here, scale(-1.0, axes.other))


def _placements(  # noqa: PLR0913
    parts: Parts, here: MovingJoint, there: MovingJoint, near: Pose, beyond: Pose, *, moved: bool
) -> Iterator[Measured]:
    """Yield where the parent sees the joint and how the child is turned, and where the child does.

    The first is one point of the child, at which the first description has the joint, so that
    another choice of the origin on the axis, or of the frame of a link, does not count.
    """
    transform = near.of(there.transform).of(beyond.inverse)
    yield from parts.point("origin", here.transform.at(here.anchor), transform.at(here.anchor))
    turned = angle(product(transpose(here.transform.turn), transform.turn))
    yield parts.measured(
        "orientation", "rad", 0.0, turned, differs=turned > parts.tolerances.angle, individual=False
    )
    if here.kind in TURNING and not moved:
        other = beyond.at(there.anchor)
        if line_distance(here.anchor, here.axis, other) > parts.tolerances.distance:
            yield from parts.point(TURNING[here.kind], here.anchor, other)


def _limits(
    parts: Parts, here: MovingJoint, there: MovingJoint, *, mirrored: bool, ranged: bool
) -> Iterator[Measured]:
    """Yield the limits of position, force and speed that both state.

    Those of a *mirrored* axis are turned with it, unless they are the same numbers: then only the
    axis differs. None of position is stated to be unlimited if *ranged*.
    """
    position, force = ("m", "N") if here.kind == LINEAR else ("rad", "N m")
    mine, yours = (here.lower, here.upper), (there.lower, there.upper)
    nodes = (here.limit_node or here.node, there.limit_node or there.node)
    ranges = Parts(parts.part, parts.other_part, parts.at, parts.there, parts.tolerances, nodes)
    if mirrored and any(
        ranges.bound("", position, *each).differs for each in zip(mine, yours, strict=True)
    ):
        yours = (_negated(there.upper), _negated(there.lower))
    for what, a, b in zip(("lower limit", "upper limit"), mine, yours, strict=True):
        if (a is not None or b is not None) and (ranged or None not in {a, b}):
            yield ranges.bound(what, position, a, b)
    speed = f"{position}/s"
    for what, unit, a, b in (
        ("effort limit", force, here.effort, there.effort),
        ("speed limit", speed, here.speed, there.speed),
    ):
        if a is not None and b is not None:
            yield ranges.number(what, unit, a, b, individual=False)


def _negated(bound: float | None) -> float | None:
    return None if bound is None else -bound
