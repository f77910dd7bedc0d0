"""Joints and bodies of two descriptions that have the same name, as spelling goes."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

from kinlint.facts.comparison.described_robot import DescribedRobot

WORDS = re.compile(r"[a-z]+|[0-9]+")
SHARED = 2.0 / 3.0
"""Least share of common joints from which names tell what corresponds.

A variant of a robot with another gripper or base still shares two thirds.
"""


def same_names(one: DescribedRobot, other: DescribedRobot) -> Mapping[int, int]:
    """Return the joints with the same name, by their indices."""
    return _common(_unique(_names(one)), _unique(_names(other)))


def similar_names(one: DescribedRobot, other: DescribedRobot) -> Mapping[int, int]:
    """Return the joints whose names differ only in case, separators, and what all names share.

    `panda_joint1` of a robot is similar to `Joint-1` of another.
    """
    return _common(_unique(_keys(_names(one))), _unique(_keys(_names(other))))


def are_enough(named: Mapping[int, int], one: DescribedRobot, other: DescribedRobot) -> bool:
    """Tell whether the joints *named* alike are most of those of one of the robots."""
    return bool(named) and len(named) >= SHARED * min(len(one.joints), len(other.joints))


def first_word(name: str) -> str:
    """Return the first word of *name* in lower case, such as `left`; empty if it has none."""
    found = WORDS.search(name.casefold())
    return found.group() if found is not None else ""


def _names(robot: DescribedRobot) -> list[str]:
    return [joint.name for joint in robot.joints]


def _keys(names: Sequence[str]) -> list[str]:
    """Return the words of each name without those at its ends that all names share."""
    words = [WORDS.findall(name.casefold()) for name in names]
    if len(words) > 1:
        for end in (0, -1):
            while all(len(each) > 1 for each in words) and len({each[end] for each in words}) == 1:
                for each in words:
                    del each[end]
    return [" ".join(each) for each in words]


def _unique(names: Iterable[str]) -> Mapping[str, int]:
    """Return the indices of names that occur once."""
    found: dict[str, int] = {}
    repeated = set()
    for index, name in enumerate(names):
        if found.setdefault(name, index) != index:
            repeated.add(name)
    return {name: index for name, index in found.items() if name and name not in repeated}


def _common(one: Mapping[str, int], other: Mapping[str, int]) -> Mapping[int, int]:
    return {index: other[name] for name, index in one.items() if name in other}
