"""Directions of the axes of joints."""

from __future__ import annotations

from math import hypot

from kinlint.formats.rigid_transform import Vector, inverse, rotated
from kinlint.formats.sdf.frames import Frames
from kinlint.formats.sdf.scopes import MODEL
from kinlint.formats.sdf.sdf_elements import SdfElement

AXES = ("axis", "axis2")
JOINT_FRAME = (1, 5)
"""The version since which an axis is given in the joint frame, and not in that of the model."""
UPWARD: Vector = (0.0, 0.0, 1.0)
"""Direction of an axis without `xyz`, which is the default of SDF."""


def direction(frames: Frames, joint: SdfElement, axis: SdfElement) -> Vector | None:
    """Return the unit vector that *axis* says, as the frame of *joint* sees it.

    None if it says none.
    """
    xyz = axis.first("xyz")
    if xyz is None or len(xyz.numbers) != len("xyz"):
        return None
    length = hypot(*xyz.numbers)
    if not 0 < length < float("inf"):
        return None
    x, y, z = (each / length for each in xyz.numbers)
    name = xyz.attributes.get("expressed_in", "")
    if not name and not axis.truth("use_parent_model_frame") and not _old(joint):
        return x, y, z
    seer = frames.find(name or MODEL, joint)
    seen = frames.pose_in_world(seer) if seer is not None else None
    place = frames.pose_in_world(joint)
    if seen is None or place is None:
        return None
    return rotated(inverse(place)[1], rotated(seen[1], (x, y, z)))


def _old(joint: SdfElement) -> bool:
    return () < joint.version < JOINT_FRAME


def in_world(frames: Frames, joint: SdfElement, tag: str) -> Vector | None:
    """Return the axis of *joint* called *tag*, in the zero configuration and the world's frame."""
    axis, place = joint.first(tag), frames.pose_in_world(joint)
    xyz = axis.first("xyz") if axis is not None else None
    own = direction(frames, joint, axis) if axis is not None and xyz is not None else UPWARD
    return rotated(place[1], own) if place is not None and own is not None else None
