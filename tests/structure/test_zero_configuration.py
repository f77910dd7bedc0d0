"""Where parts of robots are with all joints at zero, whatever the format says it in."""

from __future__ import annotations

import json
import math

import pytest
from structured import sample, structures, urdf

from kinlint.facts.joint_meetings import rotation_of
from kinlint.facts.linear_algebra import apply, determinant, orthonormality
from kinlint.structure import Joint, Link, Structure

ARM = """<robot name="arm"><link name="base"/>
  <link name="upper"><inertial><origin xyz="0 0 0.5"/><mass value="1"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="lower"/>
  <joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/>
    <origin xyz="1 0 0" rpy="0 1.5707963267948966 0"/><axis xyz="0 0 2"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
  <joint name="elbow" type="prismatic"><parent link="upper"/><child link="lower"/>
    <origin xyz="0 0 2"/><axis xyz="1 0 0"/>
    <limit lower="0" upper="1" effort="1" velocity="1"/></joint>
</robot>"""
SDF = """<sdf version="1.9"><model name="arm">
  <link name="base"/>
  <link name="upper"><pose>1 0 1 0 0 0</pose></link>
  <joint name="hinge" type="revolute"><pose>0 0 -1 0 0 0</pose>
    <parent>base</parent><child>upper</child><axis><xyz>0 1 0</xyz></axis></joint>
</model></sdf>"""


def link(structure: Structure, name: str) -> Link:
    return next(each for each in structure.links if each.name == name)


def joint(structure: Structure, name: str) -> Joint:
    return next(each for each in structure.joints if each.name == name)


def test_poses_of_joints_add_up() -> None:
    (arm,) = structures(arm_urdf=ARM)
    assert link(arm, "upper").point == pytest.approx((1, 0, 0))
    assert link(arm, "upper").centre == pytest.approx((1.5, 0, 0))
    assert joint(arm, "elbow").point == pytest.approx((3, 0, 0))
    assert joint(arm, "elbow").end == pytest.approx((3, 0, 0))
    assert link(arm, "lower").point == pytest.approx((3, 0, 0))
    assert all(each.placed for each in arm.joints)


def test_axes_turn_with_their_frames() -> None:
    (arm,) = structures(arm_urdf=ARM)
    assert joint(arm, "shoulder").direction == pytest.approx((1, 0, 0))
    assert joint(arm, "elbow").direction == pytest.approx((0, 0, -1))


def test_a_joint_with_a_pose_on_its_child() -> None:
    (arm,) = structures(arm_sdf=SDF)
    assert joint(arm, "hinge").point == pytest.approx((1, 0, 0))
    assert link(arm, "upper").point == pytest.approx((1, 0, 1))
    assert joint(arm, "hinge").direction == pytest.approx((0, 1, 0))


def test_offsets_and_coinciding_vectors_of_a_composable_model() -> None:
    (arm,) = sample("one-dof").structures
    assert joint(arm, "joint1").point == pytest.approx((0.1, 0, 0.3))
    assert joint(arm, "joint1").end == pytest.approx((-0.32, 0, 0.3))
    assert joint(arm, "joint1").direction == pytest.approx((-1, 0, 0))
    assert link(arm, "link2").centre == pytest.approx((-0.34, 0, 0.45))


def test_a_loop_that_is_open_at_zero_has_two_ends() -> None:
    (linkage,) = sample("four-bar").structures
    (closing,) = linkage.loops
    assert closing.point is not None
    assert closing.end is not None
    assert math.dist(closing.point, closing.end) == pytest.approx(0.2)
    assert all(each.point == each.end for each in linkage.joints if not each.closes)


def test_joints_without_a_stated_place_are_told() -> None:
    (arm,) = structures(
        arm_jsonld=json.dumps(
            {
                "@context": [
                    "https://w3id.org/kinlint/composable.json",
                    {"ex": "https://example.org/arm#"},
                ],
                "@graph": [
                    {
                        "@id": f"ex:{name}",
                        "@type": ["RigidBody", "SimplicialComplex"],
                        "simplices": [f"ex:{name}-{end}" for end in ("root", "end")],
                    }
                    for name in ("base", "upper")
                ]
                + [
                    {"@id": f"ex:{name}-{end}", "@type": "Frame"}
                    for name in ("base", "upper")
                    for end in ("root", "end")
                ]
                + [
                    {
                        "@id": "ex:hinge",
                        "@type": ["Joint", "RevoluteJoint"],
                        "between-attachments": ["ex:base-end", "ex:upper-root"],
                    }
                ],
            }
        )
    )
    hinge = joint(arm, "hinge")
    assert hinge.point == (0.0, 0.0, 0.0)
    assert not hinge.placed


def test_each_tree_is_seen_from_its_own_root() -> None:
    (arm,) = structures(arm_urdf=urdf("a>b", "c>d"))
    assert link(arm, "a").point == link(arm, "c").point == (0.0, 0.0, 0.0)


def test_numbers_that_overflow_have_no_place() -> None:
    text = ARM.replace('xyz="1 0 0" rpy', 'xyz="1e308 0 0" rpy').replace("0 0 2", "0 0 1e308")
    (arm,) = structures(arm_urdf=text)
    assert joint(arm, "elbow").point is None


X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


@pytest.mark.parametrize(
    "pairs",
    [
        [],
        [(X, X)],
        [(X, Y)],
        [(X, (-1.0, 0.0, 0.0))],
        [(X, Y), (Y, Z)],
        [(Z, Z), (X, (0.6, 0.8, 0.0))],
        [(Z, Z), (Z, Z), (X, Y)],
    ],
)
def test_a_rotation_takes_one_vector_of_each_pair_to_the_other(pairs) -> None:
    turn = rotation_of(pairs)
    assert orthonormality(turn) < 1e-12
    assert determinant(turn) == pytest.approx(1.0)
    for one, other in pairs:
        assert apply(turn, other) == pytest.approx(one)
