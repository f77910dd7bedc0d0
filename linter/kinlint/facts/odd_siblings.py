"""The one of four or more wheels, legs or fingers that is placed, turned or shaped otherwise.

Siblings are joints of one kind whose names differ by left, right, front and rear alone. A robot of
left and right is taken as mirrored across the axis that `plane_of` tells.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from urllib.parse import unquote

from kinlint.facts.body_shapes import BodyShapes
from kinlint.facts.drawn_symmetry import ALIKE, NEAR, TURNING, Drawn, DrawnSymmetry, plane_of
from kinlint.facts.fact_statements import fact, numbers
from kinlint.facts.joint_numbers import Gearing
from kinlint.facts.laterality import is_left, sideless, without_side
from kinlint.facts.linear_algebra import dot, length
from kinlint.facts.mirror_symmetry import split_name
from kinlint.terms import Term, Triple

DIGITS = re.compile(r"[0-9]+")
MOST = 3
"""Fewest siblings that agree while another differs."""
UP = 2
"""The axis that points up, by REP 103."""
APART = 0.01
"""The part of a length by which two differ at least, beside a `NEAR` or two."""


def odd_siblings(drawn: DrawnSymmetry, shapes: BodyShapes) -> Iterator[Triple]:
    """Yield each joint in the place of a sibling, or unlike at least three siblings.

    In its place, its sense or its wheel.
    """
    for joints in drawn.robots.values():
        yield from _sharing(joints, drawn.kind, drawn.numbers.gearings)
        plane = plane_of([*drawn.pairs(joints)])
        siblings: dict[tuple[str, str], list[Drawn]] = {}
        for joint, each in joints.items():
            _, name = split_name(joint)
            if without_side(name) != unquote(name):
                # What a joint is in may have names of sides, too.
                key = (sideless(joint), drawn.kind(joint))
                siblings.setdefault(key, []).append(each)
        for group in siblings.values():
            if len(group) > MOST:
                yield from _placed(group, plane)
                yield from _turned(group, drawn)
                yield from _shaped(group, shapes)


def _sharing(
    drawn: Mapping[Term, Drawn],
    kind: Callable[[Term], str],
    gearings: Mapping[Term, Sequence[Gearing]],
) -> Iterator[Triple]:
    """Yield each joint in the place of an earlier one whose name differs by side or number.

    Both have one parent and parallel axes of one sense. A follower counts if its leader moves it
    into its own place; of other joints those that turn, and not in the origin.
    """
    found: dict[tuple[object, ...], Drawn] = {}
    for joint, each in drawn.items():
        key = _place(each)
        if each.axis is None or key is None:
            continue
        if joint in gearings:
            gearing = gearings[joint][0]
            first = drawn.get(gearing.leader, each)
            same = gearing.multiplier == 1.0 and not gearing.offset and _place(first) == key
            if not same or kind(joint) != kind(gearing.leader):
                continue
        elif kind(joint) not in TURNING or length(each.step) < NEAR:
            continue
        else:
            first = found.setdefault(key, each)
        if first is not each and first.axis and dot(first.axis, each.axis) > ALIKE:
            yield joint, fact("in-place-of"), first.edge.joint


def _place(each: Drawn) -> tuple[object, ...] | None:
    """Return the parent, the name without side and number, and the place on a grid of `NEAR`."""
    if not math.isfinite(length(each.step) / NEAR):
        return None
    bare = DIGITS.sub("", without_side(each.edge.joint))
    return each.edge.parent, bare, *(round(at / NEAR) for at in each.step)


def _placed(group: Sequence[Drawn], plane: int) -> Iterator[Triple]:
    """Yield the joint whose step from its parent has another component than the others.

    With the step that it would have like them. Which of four is in front, no sign tells.
    """
    for at in range(3):
        steps = [each.step[at] for each in group]
        signs = [_side(each) if at == plane else 1.0 for each in group]
        slack = 2.0 * NEAR + APART * max(length(each.step) for each in group)
        signed = [a * b for a, b in zip(steps, signs, strict=True)]
        for values in ([signed] if at in (plane, UP) else []) + [[*map(abs, steps)]]:
            odd = _odd(values, lambda one, other: abs(one - other) <= NEAR)
            if odd is None:
                continue
            other = (odd + 1) % len(group)
            if abs(values[odd] - values[other]) > slack:
                joint = group[odd].edge.joint
                usual = signs[odd] * values[other]
                if values is not signed:
                    usual = math.copysign(values[other], steps[odd])
                yield joint, fact("placed-unlike"), group[other].edge.joint
                yield from numbers(joint, [("own-step", steps[odd]), ("usual-step", usual)])
                return


def _turned(group: Sequence[Drawn], drawn: DrawnSymmetry) -> Iterator[Triple]:
    """Yield the joint that turns against all others, or against those of its side.

    Then those of the other side agree. Joints with limits have the same, which fit both senses.
    """
    joints = [each.edge.joint for each in group]
    kind = drawn.kind(joints[0])
    ranges = {drawn.numbers.limits.get(each) for each in joints} if kind == "revolute" else ()
    first = group[0].axis
    if first is None or kind not in TURNING or not all(map(_is_even, ranges)) or len(ranges) > 1:
        return
    senses = [dot(first, each.axis) if each.axis is not None else 0.0 for each in group]
    if min(map(abs, senses)) < ALIKE:
        return
    mirrored = [sense * _side(each) for sense, each in zip(senses, group, strict=True)]
    for values in (senses, mirrored) if len(group) > MOST + 1 else (senses,):
        odd = _odd(values, lambda one, other: (one > 0.0) == (other > 0.0))
        if odd is not None:
            yield joints[odd], fact("turns-against"), joints[(odd + 1) % len(group)]
            return


def _is_even(limits: tuple[float | None, float | None] | None) -> bool:
    """Tell whether a joint may turn as far one way as the other."""
    low, high = limits or (None, None)
    return low is not None and high is not None and low == -high


def _shaped(group: Sequence[Drawn], shapes: BodyShapes) -> Iterator[Triple]:
    """Yield the only shape of a body whose sizes differ from those of the others."""
    known = [shapes.sole(each.edge.child) if each.edge.child else None for each in group]
    found = [each for each in known if each is not None]
    if len(found) < len(group) or len({each.kind for each in found}) > 1:
        return
    for at in range(len(found[0].sizes)):
        sizes = [each.sizes[at] for each in found]
        odd = _odd(sizes, lambda one, other: abs(one - other) <= APART * other)
        if odd is not None:
            other = found[(odd + 1) % len(group)]
            yield found[odd].node, fact("shaped-unlike"), other.node
            yield from numbers(
                found[odd].node, [("own-size", sizes[odd]), ("usual-size", other.sizes[at])]
            )
            return


def _odd(values: Sequence[float], alike: Callable[[float, float], bool]) -> int | None:
    """Return the place of the one value that differs from all others, which are alike."""
    for odd in range(len(values)):
        others = [value for at, value in enumerate(values) if at != odd]
        if all(alike(each, others[0]) for each in others) and not alike(values[odd], others[0]):
            return odd
    return None


def _side(each: Drawn) -> float:
    """Return 1 for what is on the left, and -1 for what is on the right, by its name."""
    return -1.0 if is_left(split_name(each.edge.joint)[1]) is False else 1.0
