"""The links, joints and loops of robots, whatever the format says them in."""

from __future__ import annotations

import itertools
import json
import math
from pathlib import Path

import pytest
from structured import linted, sample, structures, tree, urdf
from support.linting import lint

from kinlint.structure import Origin, Structure

CONTEXT = ["https://w3id.org/kinlint/composable.json", {"ex": "https://example.org/arm#"}]


def only(found: tuple[Structure, ...]) -> Structure:
    (structure,) = found
    return structure


def test_a_chain_hangs_from_its_root() -> None:
    arm = only(structures(arm_urdf=urdf("a>b", "b>c")))
    assert (arm.name, arm.files, arm.loops) == ("arm", ("arm.urdf",), ())
    assert tree(arm) == ["a", "  a-b", "    b", "      b-c", "        c"]
    assert [joint.kind for joint in arm.joints] == ["fixed", "fixed"]


def test_parts_of_collada_are_called_by_their_names() -> None:
    """Not by the way to them."""
    arm = only(sample("broken/kinematics-not-instanced.dae").structures)
    assert tree(arm) == ["base", "  elbow", "    forearm"]


def test_parts_know_where_they_are_written() -> None:
    text = urdf("a>b")
    arm = only(structures(arm_urdf=text))
    link = arm.links[0]
    assert link.location is not None
    assert link.whole is not None
    assert text[slice(*link.location.span)] == "a"
    assert text[slice(*link.whole.span)] == '<link name="a"/>'


def test_the_second_joint_that_carries_a_link_closes_a_loop() -> None:
    assert tree(only(structures(arm_urdf=urdf("a>b", "a>c", "c>b")))) == [
        *("a", "  a-b", "    b", "  a-c", "    c", "      c-b closes"),
    ]


def test_a_circle_without_a_root_begins_with_its_first_link() -> None:
    assert tree(only(structures(arm_urdf=urdf("a>b", "b>c", "c>a")))) == [
        *("a", "  a-b", "    b", "      b-c", "        c", "          c-a closes"),
    ]


def test_a_joint_from_a_link_to_itself_closes_a_loop() -> None:
    assert tree(only(structures(arm_urdf=urdf("a>a")))) == ["a", "  a-a closes"]


def test_a_link_that_is_not_there_is_drawn_as_absent() -> None:
    arm = only(structures(arm_urdf=urdf("a>b", "ghost>c", links="abc")))
    assert tree(arm) == ["a", "  a-b", "    b", "ghost absent", "  ghost-c", "    c"]


def test_joints_may_lack_a_side() -> None:
    arm = only(structures(arm_urdf=urdf("a>", ">b", ">")))
    assert tree(arm) == ["a", "  a-", "-b", "  b", "-"]
    assert [joint.parent is None for joint in arm.joints] == [False, True, True]


def test_trees_apart_are_one_robot_of_one_file() -> None:
    arm = only(structures(arm_urdf=urdf("a>b", links="abcd")))
    assert len(arm.roots) == 3


def test_each_file_of_urdf_is_a_robot() -> None:
    found = structures(one_urdf=urdf("a>b", name="one"), two_urdf=urdf("a>b", name="two"))
    assert [each.name for each in found] == ["one", "two"]


def test_a_robot_without_links_and_joints_is_none() -> None:
    assert structures(arm_urdf='<robot name="arm"/>') == ()
    assert structures() == ()


def test_names_in_urdf_keep_what_addresses_escape() -> None:
    arm = only(structures(arm_urdf=urdf("größe/1>a b", name="über")))
    assert arm.name == "über"
    assert [link.name for link in arm.links] == ["größe/1", "a b"]


def test_joints_of_the_world_hang_from_it() -> None:
    model = """<sdf version="1.9"><world name="w"><model name="door"><link name="frame"/>
        <joint name="bolt" type="fixed"><parent>world</parent><child>frame</child></joint>
        </model></world></sdf>"""
    door = only(structures(door_sdf=model))
    assert (door.name, tree(door)) == ("door", ["world", "  bolt", "    frame"])


def test_an_sdf_joint_may_name_what_is_not_there() -> None:
    model = """<sdf version="1.9"><model name="door"><link name="frame"/>
        <joint name="bolt" type="fixed"><parent>wall</parent><child>frame</child></joint>
        </model></sdf>"""
    assert tree(only(structures(door_sdf=model))) == ["wall absent", "  bolt", "    frame"]


def test_each_model_of_a_world_is_a_robot() -> None:
    models = "".join(f'<model name="{name}"><link name="l"/></model>' for name in "ab")
    found = structures(w_sdf=f'<sdf version="1.9"><world name="w">{models}</world></sdf>')
    assert [each.name for each in found] == ["a", "b"]


def test_models_in_models_are_one_robot() -> None:
    arm = only(sample("sdf/six-axis.sdf").structures)
    assert "tool::hand" in {link.name for link in arm.links}
    assert (len(arm.links), len(arm.joints), len(arm.roots)) == (8, 7, 1)


def test_a_composable_chain_hangs_from_what_is_no_ones_child() -> None:
    arm = only(sample("one-dof").structures)
    assert tree(arm) == ["link1", "  joint1", "    link2"]


def test_a_linkage_is_a_tree_with_one_loop() -> None:
    linkage = only(sample("four-bar").structures)
    assert [joint.name for joint in linkage.loops] == ["joint-c"]
    assert len(tree(linkage)) == len(linkage.links) + len(linkage.joints)


@pytest.mark.slow
def test_two_loops_of_a_delta_robot() -> None:
    assert len(only(sample("delta").structures).loops) == 2


@pytest.mark.slow
def test_robots_that_are_bolted_together_are_one() -> None:
    robot = only(sample("mobile-manipulator").structures)
    assert (len(robot.links), len(robot.joints), len(robot.roots)) == (13, 12, 1)
    assert len(robot.files) > 3


def composable(*nodes: dict[str, object]) -> str:
    return json.dumps({"@context": CONTEXT, "@graph": nodes})


def body(name: str) -> dict[str, object]:
    parts = [f"ex:{name}-frame"]
    return {"@id": f"ex:{name}", "@type": ["RigidBody", "SimplicialComplex"], "simplices": parts}


def joint(name: str, *bodies: str) -> dict[str, object]:
    ends = [f"ex:{each}-frame" for each in bodies]
    return {"@id": f"ex:{name}", "@type": "Joint", "between-attachments": ends}


def test_two_robots_may_share_a_file() -> None:
    text = composable(*map(body, "abcd"), joint("j", "a", "b"), joint("k", "c", "d"))
    assert [tree(each) for each in structures(arm_jsonld=text)] == [
        ["a", "  j", "    b"],
        ["c", "  k", "    d"],
    ]


def test_bodies_that_nothing_joins_belong_to_the_robot_of_their_file() -> None:
    text = composable(*map(body, "abc"), joint("j", "a", "b"))
    assert tree(only(structures(arm_jsonld=text))) == ["a", "  j", "    b", "c"]


def test_bodies_alone_are_a_robot() -> None:
    assert tree(only(structures(arm_jsonld=composable(*map(body, "ab"))))) == ["a", "b"]


def test_a_joint_may_join_three_bodies() -> None:
    text = composable(*map(body, "abc"), joint("j", "a", "b", "c"))
    assert tree(only(structures(arm_jsonld=text))) == ["a", "  j", "    b", "    c"]


def test_an_attachment_on_no_body_stands_for_one() -> None:
    text = composable(body("a"), joint("j", "a", "lost"))
    arm = only(structures(arm_jsonld=text))
    assert tree(arm) == ["a", "  j", "    lost-frame absent"]


def test_composable_joints_are_turned_round_to_make_one_tree() -> None:
    text = composable(*map(body, "abc"), joint("j", "b", "a"), joint("k", "b", "c"))
    assert tree(only(structures(arm_jsonld=text))) == ["b", "  j", "    a", "  k", "    c"]


@pytest.mark.parametrize("folder", ["gripper", "urdf/gripper.urdf"])
def test_numbers_are_the_same_in_all_formats(folder: str) -> None:
    gripper = only(sample(folder).structures)
    left, right = gripper.joints
    assert left.kind == right.kind == "prismatic"
    assert left.origin is not None
    assert left.origin.xyz == pytest.approx((0.0, 0.004, 0.072))
    assert left.axis == pytest.approx((0.0, 0.0, 1.0))
    assert (left.lower, left.upper) == (0.0, 0.042)
    (mimic,) = gripper.couplings
    assert (mimic.leader, mimic.follower, mimic.multiplier) == (left.iri, right.iri, 1.0)


def test_angles_stay_as_they_are_written() -> None:
    text = urdf("a>b").replace("</joint>", '<origin rpy="0 1.5708 0"/></joint>')
    arm = only(structures(arm_urdf=text))
    assert arm.joints[0].origin == Origin((0.0, 0.0, 0.0), (0.0, 1.5708, 0.0))


def test_angles_are_worked_out_where_none_are_written() -> None:
    arm = only(sample("six-axis").structures)
    turns = [joint.origin.rpy for joint in arm.joints if joint.origin and joint.origin.rpy]
    assert any(math.isclose(abs(angle), math.pi / 2) for turn in turns for angle in turn)


def test_findings_belong_to_the_part_that_they_are_about() -> None:
    report = sample("broken/undefined-link-reference.urdf")
    arm = only(report.structures)
    owned = {arm.owner(finding.focus) for finding in report.findings}
    assert arm.joints[0].iri in owned


def test_findings_about_numbers_belong_to_what_has_them() -> None:
    report = sample("broken/inverted-limit.jsonld")
    arm = only(report.structures)
    (finding,) = report.findings
    assert arm.owner(finding.focus) == arm.joints[0].iri


def test_rules_that_are_not_asked_leave_the_picture_as_it_is() -> None:
    text = urdf("a>b").replace("</joint>", '<origin xyz="1 2 3"/></joint>')
    (arm,) = structures(arm_urdf=text)
    assert arm.joints[0].origin is not None
    assert arm.joints[0].origin.xyz == (1.0, 2.0, 3.0)


@pytest.mark.slow
def test_a_long_chain_needs_no_recursion() -> None:
    names = [f"l{number}" for number in range(1500)]
    text = urdf(*(f"{one}>{two}" for one, two in itertools.pairwise(names)))
    arm = only(structures(arm_urdf=text))
    assert max(step.depth for step in arm.steps()) == 2 * (len(names) - 1)


def test_who_draws_nothing_pays_nothing() -> None:
    assert lint(urdf("a>b")).structures == ()


def test_samples_have_robots() -> None:
    samples = Path(__file__).resolve().parents[2] / "samples"
    file = samples / "urdf" / "six-axis.urdf"
    assert len(linted({file.name: file.read_text("utf-8")}).structures) == 1


def test_a_joint_with_a_pose_may_have_a_child_that_is_not_there() -> None:
    model = """<sdf version="1.9"><model name="door"><link name="frame"/>
        <joint name="bolt" type="fixed"><pose>0 0 1 0 0 0</pose>
        <parent>frame</parent><child>leaf</child></joint></model></sdf>"""
    assert tree(only(structures(door_sdf=model))) == ["frame", "  bolt", "    leaf absent"]
