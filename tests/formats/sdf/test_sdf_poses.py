"""Poses in SDF come to what the specification says, by whatever frames they are given."""

from math import pi, sqrt

import pytest
from reading_sdf import model, numbers, paths, said

JOINT = "/model/arm/joint/j"
AXIS = "<axis><xyz{}>{}</xyz>{}</axis>"
POSE = ("x", "y", "z", "qx", "qy", "qz", "qw")


def arm(base="", tip="", joint="", axis="", version="1.9", rest=""):  # noqa: PLR0913, PLR0917
    return model(
        f'<link name="base">{base}</link><link name="tip">{tip}</link>{rest}'
        f'<joint name="j" type="revolute">{joint}<parent>base</parent>'
        f"<child>tip</child>{axis}</joint>",
        version,
    )


def on_parent(read):
    return numbers(read, JOINT, "parent-", *POSE)


def test_a_joint_without_a_pose_is_where_its_child_is():
    read = arm("<pose>0 0 1 0 0 0</pose>", "<pose>0 0 3 0 0 0</pose>")
    assert on_parent(read) == [0, 0, 2, 0, 0, 0, 1]
    assert paths(read, said(read, JOINT, "childFrame")) == ["/model/arm/link/tip"]


def test_a_pose_of_a_joint_is_seen_by_the_child():
    read = arm("", "<pose>0 0 3 0 0 0</pose>", "<pose>0 0 -1 0 0 0</pose>")
    assert on_parent(read)[:3] == [0, 0, 2]
    assert paths(read, said(read, JOINT, "childFrame")) == [JOINT]


@pytest.mark.parametrize(
    "pose",
    [
        f"<pose>1 0 0 0 0 {pi / 2}</pose>",
        '<pose degrees="true">1 0 0 0 0 90</pose>',
        '<pose rotation_format="quat_xyzw">1 0 0 0 0 1 1</pose>',
        '<pose relative_to="base">0 1 0 0 0 0</pose>',
        '<pose relative_to="aside">0 1 0 0 0 0</pose>',
        '<pose relative_to="__model__" degrees="1">1 0 0 0 0 90</pose>',
    ],
)
def test_poses_may_be_given_in_different_ways(pose):
    """The base is turned by a quarter about z; so is the tip, a metre along x of the model."""
    rest = '<frame name="aside" attached_to="base"><pose>0 -1 0 0 0 0</pose></frame>'
    read = arm(f"<pose>1 1 0 0 0 {pi / 2}</pose>", pose, rest=rest)
    seen = on_parent(read)
    if "relative_to" in pose and "__model__" not in pose:
        assert seen == pytest.approx([0, 0 if "aside" in pose else 1, 0, 0, 0, 0, 1], abs=1e-12)
    else:
        assert seen == pytest.approx([-1, 0, 0, 0, 0, 0, 1], abs=1e-12)


def test_roll_pitch_and_yaw_are_about_fixed_axes():
    read = arm(tip=f"<pose>0 0 0 {pi / 2} 0 {pi / 2}</pose>")
    assert on_parent(read)[3:] == pytest.approx([0.5, 0.5, 0.5, 0.5], abs=1e-12)


def test_a_pose_of_a_model_moves_all_in_it():
    read = model(
        '<link name="base"/><model name="hand"><pose>0 0 2 0 0 0</pose><link name="palm">'
        "<pose>0 1 0 0 0 0</pose></link></model>"
        '<joint name="j" type="fixed"><parent>base</parent><child>hand::palm</child></joint>'
    )
    assert on_parent(read)[:3] == [0, 1, 2]


def test_a_placement_frame_is_what_the_pose_of_a_model_places():
    read = model(
        '<link name="base"/><model name="hand" placement_frame="mount"><pose>0 0 2 0 0 0</pose>'
        '<link name="palm"/><frame name="mount"><pose>0 1 0 0 0 0</pose></frame></model>'
        '<joint name="j" type="fixed"><parent>base</parent><child>hand::palm</child></joint>'
    )
    assert on_parent(read)[:3] == [0, -1, 2]


def test_nothing_is_placed_by_a_frame_that_is_not_there():
    read = arm(tip='<pose relative_to="nowhere">0 0 1 0 0 0</pose>')
    assert not said(read, JOINT, "parent-x")


def test_nothing_is_placed_by_a_pose_that_is_malformed():
    assert not said(arm(tip="<pose>0 0 1</pose>"), JOINT, "parent-x")


@pytest.mark.parametrize(
    ("axis", "version", "expected"),
    [
        (AXIS.format("", "0 0 2", ""), "1.9", (0, 0, 1)),
        (AXIS.format("", "1 0 1", ""), "1.9", (sqrt(0.5), 0, sqrt(0.5))),
        (AXIS.format(' expressed_in="base"', "0 0 1", ""), "1.9", (0, 1, 0)),
        (AXIS.format(' expressed_in="__model__"', "0 0 1", ""), "1.9", (0, 1, 0)),
        (
            AXIS.format("", "0 0 1", "<use_parent_model_frame>1</use_parent_model_frame>"),
            "1.6",
            (0, 1, 0),
        ),
        (AXIS.format("", "0 0 1", ""), "1.6", (0, 0, 1)),
        (AXIS.format("", "0 0 1", ""), "1.4", (0, 1, 0)),
    ],
)
def test_an_axis_is_given_in_the_joint_frame(axis, version, expected):
    """Whatever frame it is expressed in; before version 1.5 that is the frame of the model."""
    read = arm(tip=f"<pose>0 0 0 {pi / 2} 0 0</pose>", axis=axis, version=version)
    assert numbers(read, f"{JOINT}/axis/xyz", "", "x", "y", "z") == pytest.approx(
        expected, abs=1e-12
    )


def test_an_axis_of_no_length_has_no_direction():
    assert not said(arm(axis=AXIS.format("", "0 0 0", "")), f"{JOINT}/axis/xyz", "x")


def test_a_shape_seen_by_another_body_is_placed_on_its_own():
    visual = '<visual name="v"><pose relative_to="base">0 0 1 0 0 0</pose></visual>'
    read = arm("<pose>0 0 1 0 0 0</pose>", f"<pose>0 0 5 0 0 0</pose>{visual}")
    part = "/model/arm/link/tip/visual/v"
    assert paths(read, said(read, part, "placedOn")) == ["/model/arm/link/tip"]
    assert numbers(read, part, "placed-", "x", "y", "z") == [0, 0, -3]
