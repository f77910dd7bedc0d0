"""Differences in which joints and links there are, in how they are called, and in what moves."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from kinlint.addresses import local_name
from kinlint.facts.comparison.comparison import Comparison
from kinlint.facts.comparison.described_robot import Body, DescribedRobot, MovingJoint
from kinlint.file_format import Format
from kinlint.formats.unread_text import MalformedValue
from kinlint.robot_difference import Change, Part
from kinlint.terms import Term
from kinlint.text import Location


class Side(NamedTuple):
    """One of the descriptions."""

    name: str
    """Name of the file."""
    robot: DescribedRobot
    """The robot as numbers."""
    form: Format
    """Format of the file."""
    place: Callable[[Term], Location | None]
    """Function that returns where a node is described."""
    misread: Sequence[MalformedValue] = ()
    """Values that could not be read, and so count as not given."""

    @property
    def fixed(self) -> Mapping[str, Term]:
        """Fixed joints by their names."""
        return {local_name(joint): joint for joint in self.robot.fixed.values()}


def fixed_or_free(
    alone: tuple[Sequence[MovingJoint], Sequence[MovingJoint]], old: Side, new: Side
) -> Iterator[Change]:
    """Yield which of the joints *alone* move in one description and are fixed in the other."""
    for joints, side, other in ((alone[0], old, new), (alone[1], new, old)):
        held = other.fixed
        for each in joints:
            if each.name in held:
                kinds, places = (
                    (each.kind, "fixed"),
                    (side.place(each.node), other.place(held[each.name])),
                )
                if side is new:
                    kinds, places = kinds[::-1], places[::-1]
                yield Change("joint", each.name, each.name, "movement", "", *kinds, *places)


def name_changes(comparison: Comparison, old: Side, new: Side) -> Iterator[Change]:
    """Yield the joints and links that have another name."""
    one, other, found = comparison.one, comparison.other, comparison.correspondence

    def renamed(kind: str, at: Term, there: Term, name: str, now: str) -> Iterator[Change]:
        if name != now:
            yield Change(kind, name, now, "name", "", name, now, old.place(at), new.place(there))

    for mine, yours in sorted(found.joints.items()):
        here, there = one.joints[mine], other.joints[yours]
        yield from renamed("joint", here.node, there.node, here.name, there.name)
    for mine in sorted(found.groups):
        for body, same in comparison.body_pairs[mine].pairs:
            yield from renamed("link", body.node, same.node, body.name, same.name)
            held, now = one.fixed.get(body.name), other.fixed.get(same.name)
            if held is not None and now is not None:
                yield from renamed("joint", held, now, local_name(held), local_name(now))


def parts_without_motion(
    comparison: Comparison, old: Side, new: Side
) -> tuple[Sequence[Part], Sequence[Part]]:
    """Return the fixed links and floating joints that only the old, and only the new one has."""
    found: tuple[list[Part], list[Part]] = [], []
    names = comparison.one.body_names, comparison.other.body_names
    for mine in sorted(comparison.correspondence.groups):
        same = comparison.body_pairs[mine]
        found[0].extend(_fixed(same.gone, names[1], old))
        found[1].extend(_fixed(same.come, names[0], new))
    for parts, side, other in ((found[0], old, new), (found[1], new, old)):
        for name, joint in side.robot.floating.items():
            if name not in other.robot.floating:
                parts.append(Part("joint", name, "floating", side.place(joint)))
    return found


def _fixed(bodies: Iterable[Body], known: Iterable[str], side: Side) -> Iterator[Part]:
    for body in bodies:
        if body.name not in known:
            weight = f", {body.mass:g} kg" if body.mass else ""
            yield Part("link", body.name, f"fixed{weight}", side.place(body.node))
