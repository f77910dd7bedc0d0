"""What the queries for URDF make of it, case by case."""

from __future__ import annotations

import math

import pytest
from robot import GEOM, REL, Robot, name
from support.linting import document

from kinlint.engine.lifting import lift
from kinlint.engine.store import Store
from kinlint.terms import iri, iri_value, literal_value
from kinlint.vocabulary import KIN, SRC

DOCUMENT = "urn:kinlint:document:robot.urdf"
QUARTER = "0 0 0.7071067811865476 0.7071067811865476"


def lifted(inside: str, version: str = "") -> Robot:
    """The links a and b with *inside* beside them."""
    attribute = f' version="{version}"' if version else ""
    text = f'<robot name="r"{attribute}><link name="a"/><link name="b"/>{inside}</robot>'
    store = Store()
    store.load([document(text, "robot.urdf")])
    lift(store)
    return Robot(store.lifted())


def joint(inside: str, kind: str = "revolute", version: str = "") -> Robot:
    """A joint j from a to b with *inside*."""
    ends = '<parent link="a"/><child link="b"/>'
    return lifted(f'<joint name="j" type="{kind}">{ends}{inside}</joint>', version)


def node(path: str) -> str:
    return iri(f"{DOCUMENT}#{path}")


def numbers(robot: Robot, path: str, *names: str) -> tuple[float, ...]:
    return robot.numbers(node(path), *(KIN + each for each in names))


@pytest.mark.parametrize(
    ("kind", "types"),
    [
        ("revolute", {"Joint", "RevoluteJoint", "RevoluteJointWithPolarity"}),
        ("continuous", {"Joint", "RevoluteJoint", "RevoluteJointWithPolarity"}),
        ("prismatic", {"Joint", "PrismaticJoint", "JointWithPolarity"}),
        ("fixed", {"Joint", "FixedJoint"}),
        ("floating", {"Joint", "FloatingJoint"}),
        ("planar", {"Joint", "PlanarJoint"}),
        ("Revolute", {"Joint"}),
    ],
)
def test_kinds_of_joints(kind, types):
    robot = joint("", kind)
    assert {iri_value(each).partition("#")[2] for each in robot.kinds(node("joint/j"))} == types


def test_nodes_come_from_the_smallest_element_with_their_values():
    robot = joint('<origin xyz="1 0 0"/><limit lower="1" effort="2"/>')
    for path, element in (
        ("joint/j", "joint/j"),
        ("joint/j/frame", "joint/j"),
        ("joint/j/pose/position", "joint/j/origin"),
        ("joint/j/position-limit", "joint/j/limit"),
        ("joint/j/axis", "joint/j"),
        ("link/a/frame", "link/a"),
    ):
        assert robot.values(node(path), f"{SRC}from") == [iri(f"{DOCUMENT}#/{element}")]


def test_every_node_says_where_it_comes_from():
    robot = joint('<limit lower="1" upper="2" effort="2" velocity="1"/><mimic joint="k"/>')
    made = [each for each in robot.out if each.startswith(f"<{DOCUMENT}#") and "#/" not in each]
    assert [each for each in made if not robot.values(each, f"{SRC}from")] == []


def test_what_is_not_written_is_what_the_format_says():
    robot = joint('<mimic joint="k"/>')
    assert robot.joints["j"].axis == (1.0, 0.0, 0.0)
    assert robot.poses[node("joint/j/frame")][1].shift == (0.0, 0.0, 0.0)
    assert numbers(robot, "joint/j/coupling", "multiplier", "offset") == (1.0, 0.0)
    assert robot.value(node("joint/j/coupling"), f"{KIN}leader") == node("joint/k")


def test_bounds_are_as_written():
    robot = joint('<limit upper="2" effort="-1" velocity="3"/>')
    assert robot.values(node("joint/j/position-limit"), f"{KIN}lower") == []
    assert numbers(robot, "joint/j/position-limit", "upper") == (2.0,)
    assert numbers(robot, "joint/j/force-limit", "upper") == (-1.0,)
    assert robot.values(node("joint/j/force-limit"), f"{KIN}lower") == []


@pytest.mark.parametrize("kind", ["continuous", "fixed", "planar", "floating"])
def test_only_joints_with_ends_have_a_range(kind):
    robot = joint('<limit lower="-1" upper="2" effort="1" velocity="3"/>', kind)
    assert robot.instances(f"{KIN}JointPositionLimit") == []
    assert len(robot.instances(f"{KIN}Actuator")) == (kind == "continuous")


def test_acceleration():
    robot = joint('<limit effort="1" velocity="3" acceleration="7"/>', version="1.2")
    assert numbers(robot, "joint/j/acceleration-limit", "upper") == (7.0,)


@pytest.mark.parametrize(
    ("inside", "path"),
    [
        ('<origin xyz="1 2"/>', "joint/j/pose/position"),
        ('<origin rpy="1 2 x"/>', "joint/j/pose/orientation"),
        ('<limit lower="x" upper="1"/>', "joint/j/position-limit"),
        ('<limit effort="x"/>', "joint/j/force-limit"),
        ('<axis xyz="0 0"/>', "joint/j/axis"),
        ("<axis/>", "joint/j/axis"),
    ],
)
def test_nothing_is_made_of_malformed_values(inside, path):
    robot = joint(inside)
    assert robot.kinds(node(path)) == frozenset()
    assert robot.kinds(node("joint/j"))


def test_of_several_the_first_counts():
    robot = joint(
        '<origin xyz="1 0 0"/><origin xyz="2 0 0"/><axis xyz="0 1 0"/><axis xyz="0 0 1"/>'
    )
    assert robot.poses[node("joint/j/frame")][1].shift == (1.0, 0.0, 0.0)
    assert robot.joints["j"].axis == (0.0, 1.0, 0.0)


@pytest.mark.parametrize(
    ("version", "turned"), [("", 0.0), ("1.0", 0.0), ("1.1", 1.0), ("1.2", 1.0)]
)
def test_quaternions_count_from_a_version_on(version, turned):
    inertial = f'<inertial><origin quat_xyzw="{QUARTER}"/><mass value="1"/></inertial>'
    shape = f'<geometry><sphere radius="1"/></geometry><origin quat_xyzw="{QUARTER}"/>'
    robot = lifted(
        f'<link name="c">{inertial}<visual>{shape}</visual><visual>{shape}</visual></link>'
        f'<joint name="j" type="fixed"><parent link="a"/><child link="c"/>'
        f'<origin xyz="0 0 1" quat_xyzw="{QUARTER}"/></joint>',
        version,
    )
    frames = ["joint/j", "link/c/visual", "link/c/visual;2"]
    for frame in (*(f"{each}/frame" for each in frames), "link/c/inertia-frame"):
        base, motion = robot.poses[node(frame)]
        assert base == node("link/a/frame" if "joint" in frame else "link/c/frame")
        assert math.isclose(motion.turn[1][0], turned, abs_tol=1e-15)


def test_both_orientations_are_stated_where_both_are_written():
    robot = joint(f'<origin rpy="0 0 1" quat_xyzw="{QUARTER}"/>', version="1.1")
    assert f"<{KIN}EulerAngles>" in robot.kinds(node("joint/j/pose/orientation"))
    assert f"<{KIN}Quaternion>" in robot.kinds(node("joint/j/pose/quaternion"))


def test_capsules_are_there_from_a_version_on():
    capsule = '<geometry><capsule radius="1" length="2"/></geometry>'
    link = f'<link name="c"><collision>{capsule}</collision></link>'
    assert lifted(link).instances(f"{KIN}Capsule") == []
    assert lifted(link, "1.1").instances(f"{KIN}Capsule") == [node("link/c/collision")]


def test_shapes_are_where_their_origin_is():
    box = '<geometry><box size="1 2 3"/></geometry>'
    robot = lifted(
        f'<link name="c"><visual>{box}</visual>'
        f'<collision>{box}<origin xyz="1 0 0"/></collision></link>'
    )
    visual, collision = node("link/c/visual"), node("link/c/collision")
    assert robot.value(visual, f"{KIN}attached-to") == node("link/c/frame")
    assert robot.value(collision, f"{KIN}attached-to") == node("link/c/collision/frame")
    assert robot.listed(visual, f"{KIN}size") == (1.0, 2.0, 3.0)
    assert robot.poses[node("link/c/collision/frame")][1].shift == (1.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("filename", "uri"),
    [
        ("package://arm/meshes/a b.stl", "package://arm/meshes/a%20b.stl"),
        ("file:///opt/a%20b.stl", "file:///opt/a%20b.stl"),
        ("meshes/a#1.stl", "file:meshes/a%231.stl"),
        ("C:\\arm.stl", "file:C:/arm.stl"),
    ],
)
def test_meshes_are_referred_to_by_uri(filename, uri):
    mesh = f'<geometry><mesh filename="{filename}"/></geometry>'
    robot = lifted(f'<link name="c"><visual>{mesh}</visual></link>')
    assert robot.value(node("link/c/visual"), f"{KIN}mesh") == iri(uri)
    assert robot.listed(node("link/c/visual"), f"{KIN}scale") == (1.0, 1.0, 1.0)


def test_names_are_told_from_paths():
    robot = lifted(
        '<link name="x/y z"/>'
        '<joint name="j" type="fixed"><parent link="a"/><child link="x/y z"/></joint>'
    )
    assert name(node("link/x%2Fy%20z")) == "x/y z"
    assert robot.body_of[robot.joints["j"].rider] == node("link/x%2Fy%20z")


def test_what_names_share_is_one_and_what_is_twice_is_two():
    robot = lifted('<link name="a"/><joint name="j" type="fixed"><parent link="a"/></joint>')
    bodies = set(robot.instances(f"{GEOM}RigidBody"))
    assert bodies == {node("link/a"), node("link/a;2"), node("link/b")}
    assert robot.body_of[node("joint/j/frame")] == node("link/a")


def test_joints_of_extensions_are_none():
    robot = lifted(
        '<transmission name="t"><joint name="j"/></transmission><gazebo><joint/></gazebo>'
    )
    assert robot.instances(f"{REL}Pose") == []
    assert robot.joints == {}


def test_orientations_are_about_fixed_axes():
    robot = joint('<origin rpy="0.1 0.2 0.3"/>')
    coordinates = node("joint/j/pose/orientation")
    assert literal_value(robot.value(coordinates, f"{KIN}axes-sequence")) == "xyz"
    assert numbers(robot, "joint/j/pose/orientation", "alpha", "beta", "gamma") == (0.1, 0.2, 0.3)
