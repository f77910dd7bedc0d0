"""Completion in YAML of ROS, in texts that need not be YAML at the moment."""

import pytest
from completing import Typing

URDF = """<robot name="leg">
  <link name="hip"/>
  <link name="shin"/>
  <joint name="knee" type="continuous"><parent link="hip"/><child link="shin"/></joint>
</robot>
"""
SRDF = '<robot name="leg"><group name="all"><joint name="knee"/></group></robot>\n'
CONFIG = """controller:
  ros__parameters:
    # here
    joints: [one, two]
    more:
      joints:
        - three
    base_frame_id: four
    move_group_name: "five"
    other: six
joint_limits:
  seven: {}
"""


@pytest.fixture(scope="module")
def leg(tmp_path_factory):
    files = {"leg.urdf": URDF, "leg.srdf": SRDF, "leg.yaml": CONFIG}
    return Typing(tmp_path_factory.mktemp("leg"), files)


@pytest.mark.parametrize(
    ("where", "names"),
    [
        ("[one, two] => [|", ["knee"]),
        ("[one, two] => [one, kn|ee", ["knee"]),
        ("- three => - |", ["knee"]),
        ("four => |", ["hip", "shin"]),
        ('"five" => "|"', ["all"]),
        ("seven => kn|: {}\n  s", ["knee"]),
        ("six => |", []),
    ],
)
def test_names_by_the_key(leg, where, names):
    """In lists of one line and several, as a value, and as keys of a table of joints."""
    assert leg.labels(f"leg.yaml: {where}") == names


def test_a_name_replaces_the_one_that_is_there(leg):
    leg.labels("leg.yaml: [one, two] => [one, kn|ee")
    assert leg.text[leg.span.start : leg.span.end] == "knee"


def test_rules_in_a_comment(leg):
    """The words, and the codes in them."""
    assert leg.labels("leg.yaml: here => |") == ["kinlint: file-ignore[]", "kinlint: ignore[]"]
    assert "CMP001" in leg.labels("leg.yaml: here => kinlint: ignore[|")
