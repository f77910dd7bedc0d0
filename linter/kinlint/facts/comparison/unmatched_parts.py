"""Parts that only one of two descriptions of a robot has, and parts that have other names."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence

from kinlint.facts.comparison.comparison import COMPOSED, Comparison
from kinlint.facts.comparison.described_robot import Body, DescribedRobot, MovingJoint
from kinlint.facts.comparison.measured import Measured, Parts
from kinlint.facts.comparison.name_matching import SHARED
from kinlint.facts.comparison.shape_differences import listed
from kinlint.terms import Term


def unmatched_parts(comparison: Comparison) -> Iterator[Measured]:
    """Yield the joints and collision shapes that only one has, and joints and bodies of two names.

    Composable models may leave joints out. Loops are closed by joints in some formats alone.
    """
    if COMPOSED in {comparison.one.form, comparison.other.form}:
        return
    found = comparison.correspondence
    one, other = comparison.one, comparison.other
    mine, yours = comparison.alone()
    groups = found.groups
    back = {there: here for here, there in groups.items()}
    changed = {groups[each.parent] for each in mine if each.parent in groups}
    changed &= {each.parent for each in yours}
    yield from _alone(comparison, mine, other, groups, changed)
    yield from _alone(comparison, yours, one, back, {back[each] for each in changed})
    yield from _renamed(comparison)
    yield from _without_shapes(comparison)


def _alone(
    comparison: Comparison,
    joints: Sequence[MovingJoint],
    twin: DescribedRobot,
    groups: Mapping[int, int],
    changed: set[int],
) -> Iterator[Measured]:
    """Yield the *joints* that *twin* has fixed, or not at all.

    *groups* are the groups of *twin* that correspond. Those at one that has other joints instead,
    as with another gripper, those further out, and several at an end, as with an arm without its
    gripper, are no omissions.
    """
    robot = comparison.one if twin is comparison.other else comparison.other
    homes = {body.name: (index, body) for index, body in twin.bodies()}
    further = Counter(groups.get(each.parent) for each in joints)
    inner = {each.parent for each in twin.joints}
    for joint in joints:
        carrier = groups.get(joint.parent)
        if carrier is None or not joint.is_complete or joint.closes:
            continue
        moved = robot.groups[joint.child].body(joint.bodies[1])
        home = homes.get(moved.name) if moved is not None else None
        if home is not None and home[0] == carrier:
            parts = Parts(joint.name, home[1].name, joint.node, home[1].node, comparison.tolerances)
            yield parts.measured(
                "movement", "", joint.kind, "fixed", differs=True, individual=False
            )
        elif (
            home is None and carrier not in changed and (carrier in inner or further[carrier] == 1)
        ):
            group = twin.groups[carrier]
            ends = joint.node, group.main.node
            parts = Parts(joint.name, group.name, *ends, comparison.tolerances, aspect="missing")
            yield parts.measured("joints", "", joint.kind, "none", differs=True, individual=False)


def _renamed(comparison: Comparison) -> Iterator[Measured]:
    """Yield the joints and bodies that are called otherwise, where most names are the same.

    What differs in more than its name may be another part.
    """
    found = comparison.correspondence
    different = {each.at for each in comparison.differences}
    joints = [
        (comparison.one.joints[mine], comparison.other.joints[yours])
        for mine, yours in sorted(found.joints.items())
    ]
    bodies = [pair for mine in sorted(found.groups) for pair in comparison.body_pairs[mine].pairs]
    solid = [pair for pair in bodies if all(each.is_solid for each in pair)]
    for what, pairs in (("joint", joints), ("body", solid)):
        yield from _names(comparison, what, pairs, different)


def _names(
    comparison: Comparison,
    what: str,
    pairs: Sequence[tuple[MovingJoint, MovingJoint]] | Sequence[tuple[Body, Body]],
    different: set[Term],
) -> Iterator[Measured]:
    if sum(here.name == there.name for here, there in pairs) < SHARED * len(pairs):
        return
    for here, there in pairs:
        if here.name != there.name and here.node not in different:
            ends = here.node, there.node
            parts = Parts(here.name, there.name, *ends, comparison.tolerances, aspect="name")
            names = here.name, there.name
            yield parts.measured(f"name of a {what}", "", *names, differs=True, individual=False)


def _without_shapes(comparison: Comparison) -> Iterator[Measured]:
    """Yield the groups that weigh in both and collide in one alone, if most collide in both."""
    pairs = [
        (comparison.one.groups[mine], comparison.other.groups[yours])
        for mine, yours in sorted(comparison.correspondence.groups.items())
    ]
    both = sum(all(each.shapes for each in pair) for pair in pairs)
    solid = [pair for pair in pairs if all(each.main.is_solid for each in pair)]
    alone = [pair for pair in solid if bool(pair[0].shapes) != bool(pair[1].shapes)]
    if both < SHARED * (both + len(alone)):
        return
    for here, there in alone:
        ends = here.main.node, there.main.node
        parts = Parts(here.name, there.name, *ends, comparison.tolerances, aspect="shape")
        kinds = listed(here.shapes), listed(there.shapes)
        yield parts.measured("collision geometry", "", *kinds, differs=True, individual=False)
