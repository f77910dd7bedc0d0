"""Hinges that the gearboxes of SDF couple.

A gearbox relates two angles: of its parent and of its child, each measured from the reference body.
The hinges between these bodies have the same angles, but for their signs.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import starmap
from typing import NamedTuple, TypeAlias

from kinlint.formats.rigid_transform import Vector
from kinlint.formats.sdf.axis import in_world
from kinlint.formats.sdf.frames import Frames
from kinlint.formats.sdf.sdf_elements import SdfElement

HINGES = ("revolute", "continuous")
ALIGNED = 1e-6
"""Tolerance of the scalar product of two unit vectors of the same direction."""

Ends: TypeAlias = tuple[SdfElement | None, SdfElement | None]


class GearCoupling(NamedTuple):
    """Two hinges that a gearbox couples."""

    gearbox: SdfElement
    """The gearbox."""
    leader: SdfElement
    """The hinge between the reference body and the parent."""
    follower: SdfElement
    """The hinge between the reference body and the child."""
    sense: float
    """1 or -1, by which minus the ratio is multiplied."""


def gears(frames: Frames, joints: Iterable[SdfElement]) -> Iterator[GearCoupling]:
    """Yield the couplings of gearboxes among *joints* whose axes two hinges turn about."""
    every = [*joints]
    boxes = [each for each in every if each.attributes.get("type") == "gearbox"]
    if not boxes:
        return
    hinges: dict[frozenset[SdfElement | None], SdfElement] = {}
    for each in every:
        if each.attributes.get("type") in HINGES:
            hinges.setdefault(frozenset(_ends(frames, each)), each)
    for box in boxes:
        body = box.first("gearbox_reference_body")
        name = body.text.strip() if body else ""
        held = frames.find(name, box) if name else None
        reference = frames.body(held) if held is not None else None
        parent, child = _ends(frames, box)
        leader = hinges.get(frozenset((reference, parent)))
        follower = hinges.get(frozenset((reference, child)))
        if reference is None or leader is None or follower is None or leader is follower:
            continue
        senses = [
            _sense(frames, box, tag, hinge, reference)
            for tag, hinge in (("axis", leader), ("axis2", follower))
        ]
        if 0.0 not in senses:
            yield GearCoupling(box, leader, follower, senses[0] * senses[1])


def _ends(frames: Frames, joint: SdfElement) -> Ends:
    found = (frames.end(joint, tag) for tag in ("parent", "child"))
    parent, child = (frames.body(each) if each is not None else None for each in found)
    return parent, child


def _sense(
    frames: Frames, box: SdfElement, tag: str, hinge: SdfElement, reference: SdfElement
) -> float:
    """Return 1 if *hinge* turns as the axis *tag* of *box* counts, -1 if the other way, else 0."""
    own, other = in_world(frames, box, tag), in_world(frames, hinge, "axis")
    if own is None or other is None:
        return 0.0
    along = _product(own, other)
    if abs(along) < 1 - ALIGNED:
        return 0.0
    parent, _ = _ends(frames, hinge)
    return (1.0 if along > 0 else -1.0) * (1.0 if parent is reference else -1.0)


def _product(a: Vector, b: Vector) -> float:
    return sum(starmap(float.__mul__, zip(a, b, strict=True)))
