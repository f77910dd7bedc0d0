"""Bodies of two rigid groups that are the same, one by one."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from kinlint.facts.comparison.described_robot import Body, Group
from kinlint.facts.comparison.frame_alignment import coincide
from kinlint.facts.comparison.pose import Pose

CROWD = 4096
"""Most pairs of bodies without a namesake whose places are compared."""


class BodyPairs(NamedTuple):
    """Bodies of two groups that correspond."""

    pairs: Sequence[tuple[Body, Body]]
    """Bodies that are the same."""
    gone: Sequence[Body]
    """Bodies of the first group without a counterpart."""
    come: Sequence[Body]
    """Bodies of the second group without a counterpart."""


def body_pairs(here: Group, there: Group, pose: Pose) -> BodyPairs:
    """Return the bodies that are the same in two groups, of which *here* sees *there* at *pose*.

    By name, or else as the only ones of their groups, where they are, or as the only frames left.
    """
    names = {body.name: body for body in there.bodies}
    pairs = [(body, names[body.name]) for body in here.bodies if body.name in names]
    common = {body.name for body, _ in pairs}
    gone = [body for body in here.bodies if body.name not in common]
    come = [body for body in there.bodies if body.name not in common]
    alone = len(here.bodies) == len(there.bodies) == 1
    for body in [*gone] if len(gone) * len(come) <= CROWD else ():
        same = next(
            (each for each in come if alone or coincide(body.pose, pose.of(each.pose))), None
        )
        if same is not None:
            pairs.append((body, same))
            gone.remove(body)
            come.remove(same)
    if len(gone) == len(come) == 1 and not any(each.is_solid for each in (*gone, *come)):
        return BodyPairs([*pairs, (gone[0], come[0])], [], [])
    return BodyPairs(pairs, gone, come)
