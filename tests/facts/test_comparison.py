"""Single changes of a robot, each of which is told once, and nothing else."""

from __future__ import annotations

import pytest
from compared import ARM, comparison, differences, mujoco_export

CHANGES = {
    ('<mass value="2.5"/>', '<mass value="2.6"/>'): [("mass", "upper")],
    ('<mass value="1.5"/>', '<mass value="1.6"/>'): [("mass", "stand")],
    ('<origin xyz="0.1 0.01 0"/>', '<origin xyz="0.1 0.02 0"/>'): [("centre of mass", "fore")],
    ('ixx="0.0005"', 'ixx="0.0006"'): [("moments of inertia", "hand")],
    ('ixz="0.001"', 'ixz="0.002"'): [("products of inertia", "upper")],
    ('xyz="0 0 0.2" rpy="0 0.1 0"', 'xyz="0 0 0.23" rpy="0 0.1 0"'): [("origin", "shoulder")],
    ('rpy="1.2 0 0.4"', 'rpy="1.2 0 0.5"'): [("orientation", "elbow")],
    ('rpy="0 0.7 0"', 'rpy="0 0.8 0"'): [("orientation", "wrist")],
    ('<origin xyz="0.25 0 0"', '<origin xyz="0.27 0 0"'): [("origin", "wrist")],
    ('upper="2.8"', 'upper="2.9"'): [("upper limit", "shoulder")],
    ('lower="-1.5"', 'lower="-1.4"'): [("lower limit", "elbow")],
    ('effort="60"', 'effort="70"'): [("effort limit", "elbow")],
    ('velocity="2.5"', 'velocity="3"'): [("speed limit", "elbow")],
    ('<axis xyz="0 0 1"/>', '<axis xyz="0 0.6 0.8"/>'): [("axis", "shoulder")],
    ('<box size="0.2 0.3 0.1"/>', '<box size="0.2 0.3 0.2"/>'): [("size of the box", "base")],
    ('<sphere radius="0.05"/>', '<box size="1 1 1"/>'): [("collision geometry", "fore")],
    ('type="revolute"><parent link="upper"', 'type="prismatic"><parent link="upper"'): [
        ("movement", "elbow")
    ],
}


@pytest.mark.parametrize(("change", "told"), CHANGES.items(), ids=lambda each: str(each[0]))
def test_one_change_is_told_once(change: tuple[str, str], told: list[tuple[str, str]]):
    """With the part that it is about; without it there is no difference."""
    assert ARM.count(change[0]) == 1
    assert differences(ARM, ARM) == []
    assert differences(ARM, ARM.replace(*change)) == told


def renamed(text: str) -> str:
    """Return *text* with other names for all joints and links."""
    names = ("base", "stand", "upper", "fore", "hand", "left", "right")
    joints = ("mount", "shoulder", "elbow", "wrist", "grip_left", "grip_right")
    for at, name in enumerate((*names, *joints)):
        text = text.replace(f'"{name}"', f'"part-{at * 7 % 13}x"')
    return text


UNNAMED = {change: told for change, told in CHANGES.items() if told[0] != ("orientation", "wrist")}
"""The changes without those of a fixed link, which has no counterpart without a common name."""
del UNNAMED['<origin xyz="0.25 0 0"', '<origin xyz="0.27 0 0"']


@pytest.mark.parametrize(("change", "told"), UNNAMED.items(), ids=lambda each: str(each[0]))
def test_one_change_of_a_robot_with_other_names_is_told_once(
    change: tuple[str, str], told: list[tuple[str, str]]
):
    """Structure and numbers tell which joints are the same."""
    assert differences(ARM, renamed(ARM)) == []
    assert differences(ARM, renamed(ARM.replace(*change))) == told


def test_a_reversed_axis_is_told_once():
    """Its range is mirrored with it, so that the limits are the same."""
    turned = ARM.replace('<axis xyz="0 0 1"/>', '<axis xyz="0 0 -1"/>')
    turned = turned.replace('lower="-2.9" upper="2.8"', 'lower="-2.8" upper="2.9"')
    assert differences(ARM, turned) == [("axis", "shoulder")]


def test_an_axis_that_is_reversed_alone_is_told_once():
    """Its limits have the same numbers, so they are no second difference."""
    turned = ARM.replace('<axis xyz="0 0 1"/>', '<axis xyz="0 0 -1"/>')
    assert differences(ARM, turned) == [("axis", "shoulder")]


def test_links_that_one_file_merges_are_no_difference():
    """Masses and inertias of links that are fixed to each other count together."""
    one = '<link name="hand">'
    split = ARM.replace(one, '<link name="plate"/>' + one).replace(
        '<child link="hand"/>\n    <origin xyz="0.25 0 0" rpy="0 0.7 0"/></joint>',
        '<child link="plate"/>\n    <origin xyz="0.2 0 0"/></joint>'
        '<joint name="flange" type="fixed"><parent link="plate"/><child link="hand"/>'
        '<origin xyz="0.05 0 0" rpy="0 0.7 0"/></joint>',
    )
    found = [each for each in differences(ARM, split) if each != ("origin", "hand")]
    assert split != ARM
    assert found == []


def test_another_root_is_no_difference():
    """A chain written from its other end has the same joints."""
    links = (f'<link name="{name}">{{{at}}}</link>' for at, name in enumerate("abc"))
    chain = f'<robot name="r">{"".join(links)}'
    weights = [
        f'<inertial><origin xyz="0 0 {at}"/><mass value="{at + 1}"/>'
        f'<inertia ixx="{at + 1}" iyy="{at + 1}" izz="{at + 1}" ixy="0" ixz="0" iyz="0"/>'
        "</inertial>"
        for at in range(3)
    ]
    limit = '<limit lower="-1" upper="2" effort="1" velocity="1"/>'
    step = '<joint name="{}" type="revolute"><parent link="{}"/><child link="{}"/>' + limit
    down = (
        step.format("p", "a", "b")
        + '<origin xyz="0 0 1"/><axis xyz="0 0 1"/></joint>'
        + step.format("q", "b", "c")
        + '<origin xyz="1 0 0"/><axis xyz="1 0 0"/></joint></robot>'
    )
    up = (
        step.format("q", "c", "b")
        + '<origin xyz="-1 0 0"/><axis xyz="-1 0 0"/></joint>'
        + step.format("p", "b", "a")
        + '<origin xyz="0 0 -1"/><axis xyz="0 0 -1"/></joint></robot>'
    )
    texts = [chain.format(*weights) + rest for rest in (down, up)]
    assert differences(texts[0], texts[1]) == []
    other = texts[1].replace('name="p"', 'name="x1"').replace('name="q"', 'name="x2"')
    for name, new in (("a", "k"), ("b", "l"), ("c", "m")):
        other = other.replace(f'"{name}"', f'"{new}"')
    found = comparison(texts[0], other)
    assert len(found.correspondence.joints) == 2
    assert found.differences == []


GRIPPER = [
    f"{what} grip_{side}" for side in ("left", "right") for what in ("origin", "orientation")
]
LUMPED = {
    "mass stand": [],
    "moments of inertia hand": [],
    "speed limit elbow": [],
    "orientation wrist": [*GRIPPER, "centre of mass hand"],
    "origin wrist": [*GRIPPER[::2], "centre of mass hand"],
}
"""Differences from what MuJoCo exports: where links are lumped, or nothing is said."""


@pytest.mark.external
@pytest.mark.parametrize(("change", "told"), CHANGES.items(), ids=lambda each: str(each[0]))
def test_one_change_shows_against_the_robot_that_mujoco_exports(
    change: tuple[str, str], told: list[tuple[str, str]]
):
    """MuJoCo lumps fixed links, and has its own frames for inertias; there is no speed limit."""
    exported = mujoco_export(ARM)
    names = ("a.urdf", "b.xml")
    assert differences(ARM, exported, names) == []
    found = [" ".join(each) for each in differences(ARM.replace(*change), exported, names)]
    expected = [" ".join(each) for each in told]
    assert found == LUMPED.get(expected[0], expected)


def test_a_joint_at_another_link_is_told():
    """One finger carries the other in the second description."""
    moved = ARM.replace(
        '<parent link="hand"/><child link="right"/>', '<parent link="left"/><child link="right"/>'
    )
    assert ("parent link", "grip_right") in differences(ARM, moved)


def test_a_robot_drawn_with_another_axis_up_is_the_same():
    """All frames are turned, so that files share no direction; names do not help either."""
    legs = [(1, 1), (1, -1), (-1, 1.2), (-1, -1)]

    def robot(origins: list[str], axis: str) -> str:
        links = "".join(f'<link name="l{at}"/>' for at in range(len(legs)))
        joints = "".join(
            f'<joint name="j{at}" type="revolute"><parent link="b"/><child link="l{at}"/>'
            f'<origin xyz="{origin}"/><axis xyz="{axis}"/>'
            '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
            for at, origin in enumerate(origins)
        )
        return f'<robot name="r"><link name="b"/>{links}{joints}</robot>'

    upright = robot([f"{x} {y} 0" for x, y in legs], "0 0 1")
    lying = robot([f"{x} 0 {-y}" for x, y in legs], "0 1 0")
    for at in range(len(legs)):
        lying = lying.replace(f'"l{at}"', f'"k{at}"').replace(f'"j{at}"', f'"i{at}x"')
    lying = lying.replace('"b"', '"c"')
    found = comparison(upright, lying)
    assert len(found.correspondence.joints) == len(legs)
    assert found.differences == []
