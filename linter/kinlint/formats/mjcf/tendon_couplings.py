"""Joints that an equality of fixed tendons couples.

The length of a fixed tendon is the sum of the positions of its joints, each times a coefficient,
and an equality is about what lengths differ from those of the model as drawn.
"""

from __future__ import annotations

from typing import NamedTuple

from kinlint.formats.mjcf.mjcf_elements import MjcfElement

PAIR = 2


class TendonCoupling(NamedTuple):
    """The position of a joint is a multiple of that of another one, and an offset."""

    follower: str
    """Name of the joint."""
    leader: str
    """Name of the other joint."""
    multiplier: float
    """Multiplier."""
    offset: float
    """Offset in radians or metres."""


def tendon_coupling(equality: MjcfElement, root: MjcfElement) -> TendonCoupling | None:
    """Return what an *equality* of one tendon of two joints, or of two of one joint, comes to.

    None for all others. The tendons are those of the model below *root*.
    """
    first = _joints(equality.text("tendon1"), root)
    second = _joints(equality.text("tendon2"), root)
    given = equality.numbers("polycoef")
    constant, factor = (*given, *(0.0, 1.0)[len(given) :])[:2]
    if any(given[2:]):
        return None
    if not equality.text("tendon2") and len(first) == PAIR:
        (follower, own), (leader, other) = first
        factor = -1.0
    elif len(first) == len(second) == 1:
        ((follower, own),), ((leader, other),) = first, second
    else:
        return None
    if not own:
        return None
    return TendonCoupling(follower, leader, factor * other / own, constant / own + 0.0)


def _joints(name: str, root: MjcfElement) -> list[tuple[str, float]]:
    """Return the names and coefficients of the joints of the fixed tendon called *name*."""
    tendons = (each for section in root.all("tendon") for each in section.all("fixed"))
    found = next((each for each in tendons if name and each.name == name), None)
    if found is None:
        return []
    return [(each.text("joint"), each.number("coef")) for each in found.all("joint")]
