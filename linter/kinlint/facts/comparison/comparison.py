"""Comparison of two descriptions of one robot: what both say, and what only one of them has."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from functools import cached_property

from kinlint.addresses import local_name
from kinlint.facts.comparison.body_pairs import BodyPairs, body_pairs
from kinlint.facts.comparison.described_robot import Body, DescribedRobot, Group, MovingJoint
from kinlint.facts.comparison.frame_alignment import coincide
from kinlint.facts.comparison.joint_differences import joint_differences
from kinlint.facts.comparison.mass_differences import mass_differences
from kinlint.facts.comparison.matching import Correspondence, correspondence
from kinlint.facts.comparison.measured import Measured, Parts
from kinlint.facts.comparison.pose import Pose
from kinlint.facts.comparison.shape_differences import shape_differences
from kinlint.facts.comparison.tolerances import Tolerances
from kinlint.facts.linear_algebra import angle, product, transpose
from kinlint.terms import Term

COMPOSED = "composed"
"""Format of composable models, where what is not stated is not known."""
AGREEING = 0.5
"""Least share of equal numbers in two descriptions of one robot that only its names suggest."""
FEW = 4
"""Least count of masses, centres and origins, or else of joints, in common that are evidence."""


class Comparison:
    """Two descriptions of one robot, compared with *tolerances*.

    Bodies that are welded to each other count as one, unless *each_body* counts by itself.
    """

    def __init__(
        self,
        one: DescribedRobot,
        other: DescribedRobot,
        tolerances: Tolerances,
        *,
        each_body: bool = False,
    ) -> None:
        self.one = one
        self.other = other
        self.tolerances = tolerances
        self.each_body = each_body

    @cached_property
    def correspondence(self) -> Correspondence:
        """The parts that are the same."""
        return correspondence(self.one, self.other)

    @cached_property
    def measured(self) -> Sequence[Measured]:
        """Quantities of parts that are the same, in the order of the first description."""
        return [*self._joints(), *self._groups()]

    @property
    def differences(self) -> Sequence[Measured]:
        """Quantities of which both say something else."""
        return [each for each in self.measured if each.differs]

    def _joints(self) -> Iterator[Measured]:
        found = self.correspondence
        ranged = COMPOSED not in {self.one.form, self.other.form}
        for mine in sorted(found.joints):
            here, there = self.one.joints[mine], self.other.joints[found.joints[mine]]
            is_turned = found.groups.get(here.parent) == there.child
            if is_turned:
                there = there.reversed
            here, there = here.completed_by(there), there.completed_by(here)
            ends = ((here.parent, there.parent), (here.child, there.child))
            # Composable models state no order of the bodies that a positive direction counts from.
            either = [there] if ranged or not is_turned else [there, there.mirrored]
            tries = [
                list(joint_differences(here, each, near, beyond, self.tolerances, ranged=ranged))
                for each in either
                for near in self._aligned(*ends[0], here.bodies[0], there.bodies[0])
                for beyond in self._aligned(*ends[1], here.bodies[1], there.bodies[1])
            ]
            yield from min(tries, key=lambda each: sum(one.differs for one in each))
            if here.is_complete and there.is_complete:
                yield from self._ends(here, there)

    def _ends(self, here: MovingJoint, there: MovingJoint) -> Iterator[Measured]:
        """Yield the links that a joint joins where one has no counterpart on the other joint."""
        found = self.correspondence
        parts = Parts(here.name, there.name, here.node, there.node, self.tolerances)
        for what, mine, yours, body, other in (
            ("parent link", here.parent, there.parent, here.bodies[0], there.bodies[0]),
            ("child link", here.child, there.child, here.bodies[1], there.bodies[1]),
        ):
            names = local_name(body or here.node), local_name(other or there.node)
            if found.groups.get(mine, yours) != yours and names[0] != names[1]:
                yield parts.measured(what, "", *names, differs=True, individual=False)

    def _aligned(
        self, mine: int, yours: int, body: Term | None, other: Term | None
    ) -> Sequence[Pose | None]:
        """Return the poses of the frame of a group for the corresponding one.

        That of the whole, and if that is another one, that of two bodies of one name in them.
        """
        found = self.correspondence
        if found.groups.get(mine, -1) != yours:
            return [None]
        whole = found.poses[mine]
        here, there = self.one.groups[mine].body(body), self.other.groups[yours].body(other)
        if here is None or there is None or here.name != there.name:
            return [whole]
        own = here.pose.of(there.pose.inverse)
        return [whole] if coincide(whole, own) else [whole, own]

    def _groups(self) -> Iterator[Measured]:
        for mine in sorted(self.correspondence.groups):
            solids = list(self.solids(mine))
            for here, there, poses in solids:
                yield from self._least(mass_differences, here, there, poses)
            yield from self._fixed(mine)
            for here, there, poses in solids:
                yield from self._least(shape_differences, here, there, poses)

    def _least(
        self,
        measure: Callable[[Group, Group, Pose, Tolerances], Iterator[Measured]],
        here: Group,
        there: Group,
        poses: Sequence[Pose],
    ) -> Sequence[Measured]:
        """Return what is measured with the one of *poses* with which least differs."""
        tries = [list(measure(here, there, pose, self.tolerances)) for pose in poses]
        return min(tries, key=lambda each: sum(one.differs for one in each))

    def solids(self, mine: int) -> Iterator[tuple[Group, Group, Sequence[Pose]]]:
        """Yield what is compared of the group with this index, and where it may be seen.

        Its bodies one by one if each counts, else the whole, but for the bodies that a joint moves
        in one description and that are fixed in the other.
        """
        found = self.correspondence
        here, there = self.one.groups[mine], self.other.groups[found.groups[mine]]
        pose, same = found.poses[mine], self.body_pairs[mine]
        if not same.pairs:
            yield here, there, [pose]
        elif not self.each_body:
            yield (
                _without(here, same.gone, self.other.body_names),
                _without(there, same.come, self.one.body_names),
                [pose],
            )
        else:
            for body, other in same.pairs:
                own = body.pose.of(other.pose.inverse)
                poses = [pose] if coincide(pose, own) else [pose, own]
                yield Group((body,)), Group((other,)), poses

    @cached_property
    def body_pairs(self) -> Mapping[int, BodyPairs]:
        """The bodies that are the same in groups that are, by the index of the first group."""
        found = self.correspondence
        return {
            mine: body_pairs(self.one.groups[mine], self.other.groups[yours], found.poses[mine])
            for mine, yours in found.groups.items()
        }

    def _fixed(self, mine: int) -> Iterator[Measured]:
        """Yield where bodies of one name are that are welded to others."""
        found = self.correspondence
        here, there = self.one.groups[mine], self.other.groups[found.groups[mine]]
        names = {body.name: body for body in there.bodies}
        for body in here.bodies:
            other = names.get(body.name)
            joints = self.one.fixed.get(body.name), self.other.fixed.get(body.name)
            if other is None or None in joints:
                continue
            pose = found.poses[mine].of(other.pose)
            ends = joints[0] or body.node, joints[1] or other.node
            titles = local_name(ends[0]), local_name(ends[1])
            parts = Parts(*titles, *ends, self.tolerances, aspect="placement")
            yield from parts.point("origin", body.pose.point, pose.point)
            turned = angle(product(transpose(body.pose.turn), pose.turn))
            yield parts.measured(
                "orientation",
                "rad",
                0.0,
                turned,
                differs=turned > self.tolerances.angle,
                individual=False,
            )

    def alone(self) -> tuple[Sequence[MovingJoint], Sequence[MovingJoint]]:
        """Return the joints that only the first, and only the second description has."""
        found = self.correspondence.joints
        taken = frozenset(found.values())
        return (
            [each for at, each in enumerate(self.one.joints) if at not in found],
            [each for at, each in enumerate(self.other.joints) if at not in taken],
        )

    def agreement(self, *, alone: bool = True) -> str:
        """Return how many numbers agree; empty if too few do for descriptions of one robot.

        Unless both are *alone* in a run, axes and limits of a joint or two are evidence of nothing.
        """
        individual = [each for each in self.measured if each.individual]
        enough = len(individual) >= FEW
        if not (enough or alone or len(self.correspondence.joints) >= FEW):
            return ""
        telling = individual if enough else self.measured
        what = "masses, centres and origins" if enough else "numbers"
        agreeing = sum(not each.differs for each in telling)
        share = f"{agreeing} of {len(telling)} {what} agree"
        return share if agreeing >= AGREEING * len(telling) else ""

    def bodies(self) -> Iterator[tuple[Body, Body]]:
        """Yield the bodies that lend their frames to groups that are the same."""
        for mine, yours in sorted(self.correspondence.groups.items()):
            yield self.one.groups[mine].bodies[0], self.other.groups[yours].bodies[0]


def _without(group: Group, alone: Sequence[Body], known: Collection[str]) -> Group:
    """Return *group* without those of the bodies *alone* whose names are *known*."""
    left = [each for each in alone if each.name in known]
    return Group(tuple(each for each in group.bodies if each not in left)) if left else group
