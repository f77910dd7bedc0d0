"""The motions that joints of COLLADA are made of: their kinds and units."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import hypot, pi

from kinlint.formats.collada.asset_units import metres
from kinlint.formats.collada.collada_elements import ColladaElement
from kinlint.formats.collada.kinematics import Joint, Model

DEGREE = pi / 180
ORDER = ("revolute", "prismatic")
KINDS = {
    ("revolute",): "revolute",
    ("prismatic",): "prismatic",
    ("revolute", "prismatic"): "cylindrical",
    ("revolute", "revolute"): "universal",
    ("revolute", "revolute", "revolute"): "spherical",
    ("revolute", "prismatic", "prismatic"): "planar",
}
"""Kinds of joints by their motions, those that turn first."""
PARALLEL = 1e-6


def joint_uses(models: Sequence[Model]) -> Mapping[ColladaElement, list[Joint]]:
    """Return the joints made of each element of a joint, and of each of its motions."""
    uses: dict[ColladaElement, list[Joint]] = {}
    for model in models:
        for joint in model.joints:
            for each in (joint.element, *joint.primitives):
                uses.setdefault(each, []).append(joint)
    return uses


def turns(joint: Joint) -> bool:
    """Tell whether the first motion of *joint* is a rotation."""
    return joint.primitives[0].tag == "revolute"


def unit_of(joint: Joint) -> float:
    """Return the radians or the metres in the unit of the one motion of *joint*."""
    return DEGREE if turns(joint) else metres(joint.primitives[0])


def kind_of(joint: Joint) -> str:
    """Return the kind of *joint* by its motions; empty if it is none that has a name."""
    motions = joint.primitives
    kind = KINDS.get(tuple(sorted((each.tag for each in motions), key=ORDER.index)), "")
    if kind == "cylindrical" and not _parallel(*motions):
        return ""
    return kind


def _parallel(a: ColladaElement, b: ColladaElement) -> bool:
    axes = [each.first("axis") for each in (a, b)]
    u, v = (each.numbers() if each is not None else [] for each in axes)
    if len(u) != len(v) or len(u) != 3:  # noqa: PLR2004  x, y, z
        return False
    crossed = hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    return crossed <= PARALLEL * hypot(*u) * hypot(*v)
