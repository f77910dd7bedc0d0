"""Differences between two descriptions of a robot, with their places, for reports."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from typing import Any

from kinlint.addresses import local_name
from kinlint.engine.lifting import lifts
from kinlint.facts.comparison.comparison import COMPOSED, Comparison
from kinlint.facts.comparison.described_robot import HINGE, Group, MovingJoint
from kinlint.facts.comparison.frame_alignment import total_mass
from kinlint.facts.comparison.joint_differences import LINEAR
from kinlint.facts.comparison.measured import Measured
from kinlint.facts.comparison.part_changes import (
    Side,
    fixed_or_free,
    name_changes,
    parts_without_motion,
)
from kinlint.facts.comparison.reach import reach
from kinlint.facts.comparison.tolerances import EXACT, Tolerances
from kinlint.facts.metamodel_terms import inertia, kin
from kinlint.robot_difference import Change, Part, RobotDifference, Unstated
from kinlint.terms import Term

OF_JOINTS = frozenset(
    {"position limit", "effort limit", "speed limit", "mimic", "axis of the loop"}
)


def robot_difference(old: Side, new: Side, tolerances: Tolerances) -> RobotDifference:
    """Return how the robot of *new* differs from that of *old*."""
    revisions = old.form == new.form and tolerances is EXACT
    comparison = Comparison(old.robot, new.robot, tolerances, each_body=revisions)
    found = comparison.correspondence
    alone = comparison.alone()
    names = found.by_name and old.form == new.form
    changes = [
        *(_change(each, old, new) for each in comparison.differences),
        *_gearings(comparison, old, new),
        *(name_changes(comparison, old, new) if names or revisions else ()),
        *fixed_or_free(alone, old, new),
    ]
    whole = list(_whole(old, new, tolerances, found.groups))
    moving = [
        [each for each in joints if each.name not in held]
        for joints, held in zip(alone, (new.fixed, old.fixed), strict=True)
    ]
    gone, come = ([*_parts(each, side)] for each, side in zip(moving, (old, new), strict=True))
    if revisions:
        without, with_them = parts_without_motion(comparison, old, new)
        gone += without
        come += with_them
    known = [[*found.groups], [*found.groups.values()]]
    for groups, joints in zip(known, alone, strict=True):
        groups += [joint.child for joint in joints]
    return RobotDifference(
        old.name,
        new.name,
        "names" if found.by_name else "structure",
        (len(found.joints), len(old.robot.joints), len(new.robot.joints)),
        [*whole, *_misread(old, new), *(c for c in changes if not _follows(c, old, new))],
        [*gone, *_groups(old, frozenset(known[0]))],
        [*come, *_groups(new, frozenset(known[1]))],
        list(_unstated(comparison, old, new)),
    )


def _misread(old: Side, new: Side) -> Iterator[Change]:
    """Yield the values that could not be read in one description and are not in the other."""
    before, now = ({each[:2]: each for each in side.misread} for side in (old, new))
    for name, text in (each for each in before if each not in now):
        place = before[name, text].place
        yield Change("value", "", "", name, "", text, "", place)
    for name, text in (each for each in now if each not in before):
        place = now[name, text].place
        yield Change("value", "", "", name, "", "", text, None, place)


def _follows(each: Change, old: Side, new: Side) -> bool:
    """Tell whether a bound is missing where some value could not be read."""
    return bool((each.old is None and old.misread) or (each.new is None and new.misread))


def _is_weighed(group: Group) -> bool:
    return any(body.mass is not None for body in group.bodies)


def _change(each: Measured, old: Side, new: Side) -> Change:
    kind = "link" if each.aspect in {"mass", "shape", "halved"} else "joint"
    at, there = each.sides or (each.at, each.there)
    return Change(
        kind,
        each.part,
        each.other_part,
        each.quantity,
        each.unit,
        each.here,
        each.other,
        old.place(at) or old.place(each.at),
        new.place(there) or new.place(each.there),
    )


def _whole(
    old: Side, new: Side, tolerances: Tolerances, alike: Mapping[int, int]
) -> Iterator[Change]:
    """Yield what differs of the robots as wholes: their mass, and how far they reach.

    *alike* are the groups that correspond. Where one of two states a mass and the other none, as if
    it is computed from a mesh, the mass of the whole is not known. Robots that stand on different
    links do not reach equally far, and those with loops are no chains.
    """
    mass, now = (sum(map(total_mass, each.robot.groups)) for each in (old, new))
    pairs = ((old.robot.groups[one], new.robot.groups[other]) for one, other in alike.items())
    known = all(_is_weighed(one) == _is_weighed(other) for one, other in pairs)
    if known and min(mass, now) > 0.0 and tolerances.apart(mass, now):
        yield Change("robot", "", "", "mass", "kg", mass, now)
    closed = any(joint.closes for each in (old, new) for joint in each.robot.joints)
    standing = (
        not closed and old.robot.roots and alike.get(old.robot.roots[0]) in new.robot.roots[:1]
    )
    reaches = [reach(each.robot) if standing else None for each in (old, new)]
    if reaches[0] is not None and reaches[1] is not None:
        near, far = reaches[0].distance, reaches[1].distance
        if abs(near - far) > tolerances.distance:
            yield Change("robot", "", "", "reach", "m", near, far)


def _parts(joints: Sequence[MovingJoint], side: Side) -> Iterator[Part]:
    for each in joints:
        detail = f"{each.kind}, closes a loop" if each.closes else each.kind
        yield Part("joint", each.name, detail, side.place(each.node))


def _groups(side: Side, known: Collection[int]) -> Iterator[Part]:
    """Yield the links with a mass or a shape that are in none of the groups *known*."""
    for index, group in enumerate(side.robot.groups):
        if index not in known and (total_mass(group) > 0.0 or group.shapes):
            yield Part("link", group.name, "", side.place(group.bodies[0].node))


def _unstated(comparison: Comparison, old: Side, new: Side) -> Iterator[Unstated]:
    """Yield the quantities of common parts that only one description states."""
    found = comparison.correspondence
    joints = [
        (comparison.one.joints[a], comparison.other.joints[b]) for a, b in found.joints.items()
    ]
    groups = [solid[:2] for mine in found.groups for solid in comparison.solids(mine)]
    for quantity, term, stated in _STATED:
        pairs = [
            (stated(a), stated(b), a.name, b.name)
            for a, b in (joints if quantity in OF_JOINTS else groups)
        ]
        for old_states, side in ((True, new), (False, old)):
            names = [
                (mine if old_states else yours)
                for a, b, mine, yours in pairs
                if a is old_states and b is (not old_states)
            ]
            if quantity == "position limit" and COMPOSED != side.robot.form:
                continue
            if names:
                can = not side.form.is_tree or term in lifts([side.form])
                same = can and old.form == new.form and not side.misread
                yield Unstated(quantity, old_states, names, can, side.form.title, counts=same)


def _gearings(comparison: Comparison, old: Side, new: Side) -> Iterator[Change]:
    """Yield how the dependencies of joints on others differ, where both state one."""
    one, other, found = comparison.one, comparison.other, comparison.correspondence
    numbers = [{each.node: at for at, each in enumerate(robot.joints)} for robot in (one, other)]
    for mine, yours in sorted(found.joints.items()):
        here, there = one.joints[mine], other.joints[yours]
        a, b = here.gearing, there.gearing
        if a is None or b is None:
            continue
        places = old.place(a.node) or old.place(here.node), new.place(b.node)
        leader = numbers[0].get(a.leader, -1)
        if found.joints.get(leader, -1) != numbers[1].get(b.leader, -1):
            names = local_name(a.leader), local_name(b.leader)
            yield Change("joint", here.name, there.name, "leader", "", *names, *places)
        unit = "m" if here.kind == LINEAR else "rad"
        for quantity, symbol, before, after in (
            ("multiplier", "", a.multiplier, b.multiplier),
            ("offset", unit, a.offset, b.offset),
        ):
            if (
                before is not None
                and after is not None
                and comparison.tolerances.apart(before, after)
            ):
                yield Change(
                    "joint", here.name, there.name, quantity, symbol, before, after, *places
                )


def _weighs(group: Group) -> bool:
    return any(body.mass is not None for body in group.bodies)


def _hinged(joint: MovingJoint) -> bool | None:
    return False if joint.is_point else joint.kind == HINGE or None


def _has_tensor(group: Group) -> bool:
    return any(body.tensor is not None for body in group.bodies)


_STATED: tuple[tuple[str, Term, Callable[[Any], bool | None]], ...] = (
    ("position limit", kin("JointPositionLimit"), lambda each: each.lower is not None),
    ("effort limit", kin("ActuatorForceLimit"), lambda each: each.effort is not None),
    ("speed limit", kin("ActuatorVelocityLimit"), lambda each: each.speed is not None),
    ("mimic", kin("JointCoupling"), lambda each: each.gearing is not None),
    ("axis of the loop", kin("RevoluteJoint"), _hinged),
    ("mass", inertia("mass"), _weighs),
    ("inertia", inertia("ixx"), _has_tensor),
    ("collision shape", kin("CollisionGeometry"), lambda each: bool(each.shapes)),
)
"""Quantities that may be left out, the term that each is lifted to, and whether it is stated."""
