"""Real SRDF files and their robots: what is found in them is wrong with them."""

import pytest
from data import locate_data
from support.linting import findings

from kinlint.configuration.settings import Choice, FileSettings

FANUC = (
    "srdf/moveit_resources/fanuc_moveit_config/config/fanuc.srdf",
    "urdf/moveit_resources/fanuc_description/urdf/fanuc.urdf",
)
PR2 = (
    "srdf/srdfdom/test/resources/pr2_desc.3.srdf",
    "urdf/example_robot_data/robots/pr2_description/urdf/pr2.urdf",
)
DUAL_ARM = ("srdf/moveit_resources/dual_arm_panda_moveit_config/config/panda.srdf",)


def found(*paths):
    """The codes of what is found in the first of *paths*, with the lines."""
    files = [locate_data("robots", path) for path in paths]
    composition = FileSettings(choices=(Choice(select=("CMP",)),))
    every = findings({str(file): file.read_bytes() for file in files}, default=composition)
    return [
        (each.rule.code, each.location.start.line)
        for each in every
        if each.location.source.name == str(files[0])
    ]


@pytest.mark.parametrize(
    ("paths", "expected"),
    [
        (FANUC, []),
        (FANUC[:1], [("CMP019", 6)]),
        (PR2, [("CMP026", 2), ("CMP004", 19), ("CMP001", 75)]),
        (DUAL_ARM, [("CMP019", 7), ("CMP001", 42), ("CMP001", 43)]),
    ],
)
def test_what_is_wrong_with_a_real_one(paths, expected):
    """A joint made up for a test, a state of half the joints, groups that nobody states."""
    assert found(*paths) == expected
