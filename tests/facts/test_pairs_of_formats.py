"""One arm in each format: the same robot in each pair, and one change is told once."""

from functools import cache
from itertools import permutations

import pytest
from arm_in_formats import FORMATS, Arm
from compared import described

from kinlint.facts.comparison.comparison import Comparison
from kinlint.facts.comparison.tolerances import EXPORTED

CHANGES = {
    "nothing": ("base", {}, []),
    "mass": ("upper", {"mass": 2.4}, [("mass", "upper")]),
    "centre": (
        "forearm",
        {"centre": 0.19},
        [("centre of mass", "forearm"), ("place of the cylinder", "forearm")],
    ),
    "moments": ("hand", {"moments": (0.002,) * 3}, [("moments of inertia", "hand")]),
    "size": ("base", {"size": (0.2, 0.3, 0.16)}, [("size of the box", "base")]),
    "shape": ("hand", {"kind": "box", "size": (0.1,) * 3}, [("collision geometry", "hand")]),
    "height": ("elbow", {"height": 0.45}, [("origin", "elbow")]),
    "axis": ("elbow", {"axis": (1, 0, 0)}, [("axis", "elbow")]),
    "lower": ("shoulder", {"lower": -1.7}, [("lower limit", "shoulder")]),
    "upper": ("wrist", {"upper": 0.15}, [("upper limit", "wrist")]),
    "movement": ("elbow", {"kind": "prismatic"}, [("movement", "elbow")]),
    "effort": ("elbow", {"effort": 33}, [("effort limit", "elbow")]),
    "speed": ("elbow", {"speed": 4}, [("speed limit", "elbow")]),
}
"""The part that is changed, its new values, and what is told then."""
SILENT = {"effort": {"dae"}, "speed": {"xml", "usda", "dae"}}
"""Suffixes of the files that do not say what is changed."""


@cache
def robot(suffix, change):
    part, values, _ = CHANGES[change]
    return described(FORMATS[suffix](Arm().with_change(part, **values)), f"arm.{suffix}")


def told(old, new, change):
    found = Comparison(robot(old, "nothing"), robot(new, change), EXPORTED)
    assert not any(found.alone())
    return [(each.quantity, each.part) for each in found.differences]


@pytest.mark.parametrize("suffix", FORMATS)
def test_the_arm_is_the_same_in_each_format(suffix):
    """Half sizes, degrees, frames of shapes and cylinders along y included."""
    assert told("urdf", suffix, "nothing") == []


@pytest.mark.slow
@pytest.mark.parametrize(("old", "new"), list(permutations(FORMATS, 2)))
def test_a_change_is_told_once_from_each_format_to_each(old, new):
    """Unless one of the two does not say it."""
    for change, (_, _, expected) in CHANGES.items():
        is_silent = not {old, new}.isdisjoint(SILENT.get(change, ()))
        assert told(old, new, change) == ([] if is_silent else expected)
