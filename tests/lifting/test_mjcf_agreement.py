"""A robot written as MJCF and as URDF is the same robot in the domain vocabulary."""

from __future__ import annotations

import random
from math import pi, radians
from pathlib import Path

import pytest
from lifted import robot
from robot import Robot
from test_robot_agreement import SAMPLES

from kinlint.terms import Term, iri, literal_value
from kinlint.vocabulary import KIN, QUDT

CLOSE = 1e-12
WORLD = "worldbody"
UNIT = iri(f"{QUDT}unit")


@pytest.fixture(scope="module", params=["six-axis", "gripper"])
def pair(request: pytest.FixtureRequest) -> tuple[Robot, Robot]:
    """A robot by its MJCF file, and by its URDF file."""
    return mjcf(request.param), robot(SAMPLES / "urdf" / f"{request.param}.urdf")


@pytest.fixture(scope="module")
def four_bar() -> Robot:
    """The four-bar linkage of the samples."""
    return mjcf("four-bar")


def mjcf(name: str) -> Robot:
    """The robot of a sample, which includes others from its folder."""
    with pytest.MonkeyPatch.context() as context:
        context.chdir(SAMPLES / "mjcf")
        return robot(Path(f"{name}.xml"))


def frame(described: Robot, body: str) -> Term:
    return f"{described.bodies[body][:-1]}/frame>"


def test_bodies_and_moving_joints_have_the_same_names_and_kinds(pair: tuple[Robot, Robot]) -> None:
    ours, theirs = pair
    assert set(ours.bodies) == {*theirs.bodies, WORLD}
    moving = {key: joint for key, joint in theirs.joints.items() if joint.axis is not None}
    assert moving
    for key, joint in moving.items():
        assert ours.joints[key].kinds == joint.kinds


def test_bodies_are_in_the_same_places_wherever_joints_are(pair: tuple[Robot, Robot]) -> None:
    ours, theirs = pair
    numbers = random.Random(20261123)  # noqa: S311
    root = next(iter(theirs.bodies))
    for _ in range(5):
        positions = {key: [numbers.uniform(-2.0, 2.0)] for key in theirs.joints}
        here = ours.places(frame(ours, root), positions)
        there = theirs.places(frame(theirs, root), positions)
        for key in theirs.bodies:
            one, other = here[frame(ours, key)], there[frame(theirs, key)]
            assert one.shift == pytest.approx(other.shift, abs=CLOSE)
            if key not in ("hand", "flange"):
                for mine, your in zip(one.turn, other.turn, strict=True):
                    assert mine == pytest.approx(your, abs=CLOSE)


def test_inertias_are_equal(pair: tuple[Robot, Robot]) -> None:
    ours, theirs = pair
    assert theirs.inertias
    for key, inertia in theirs.inertias.items():
        own = ours.inertias[key]
        assert own.mass == inertia.mass
        assert own.centre == pytest.approx(inertia.centre, abs=CLOSE)
        for mine, your in zip(own.tensor, inertia.tensor, strict=True):
            assert mine == pytest.approx(your, abs=CLOSE)


def limits(described: Robot, kind: str) -> dict[Term, tuple[float, float, Term]]:
    """Bounds and unit of each limit of a *kind*, by what it is of."""
    found = {}
    for node in described.instances(f"{KIN}{kind}"):
        (of,) = described.values(node, f"{KIN}of-joint") or described.values(
            node, f"{KIN}of-actuator"
        )
        low, high = described.numbers(node, f"{KIN}lower", f"{KIN}upper")
        found[of] = low, high, described.out[node][UNIT][0]
    return found


def test_ranges_are_equal_in_the_unit_of_the_file(pair: tuple[Robot, Robot]) -> None:
    ours, theirs = pair
    mine, yours = (limits(each, "JointPositionLimit") for each in pair)
    assert len(mine) == len(yours) > 0
    assert sorted(mine.values()) == sorted(yours.values())
    assert ours.bodies.keys() > theirs.bodies.keys()


def test_a_limit_of_force_is_one_of_the_drive() -> None:
    read = mjcf("six-axis")
    efforts = limits(read, "ActuatorForceLimit")
    assert sorted(high for _, high, _ in efforts.values()) == [34, 76, 76, 320, 640, 640]
    driven = [read.value(each, f"{KIN}actuates") for each in efforts]
    assert sorted(driven) == sorted(
        joint.node for joint in read.joints.values() if joint.axis is not None
    )


def test_a_coupling_of_two_joints_is_a_line() -> None:
    read = mjcf("gripper")
    (coupling,) = read.instances(f"{KIN}JointCoupling")
    assert read.numbers(coupling, f"{KIN}multiplier", f"{KIN}offset") == (1.0, 0.0)
    assert read.value(coupling, f"{KIN}leader") == read.joints["left-slide"].node
    assert read.value(coupling, f"{KIN}follower") == read.joints["right-slide"].node


def test_sizes_are_whole_ones() -> None:
    read = mjcf("gripper")
    (box,) = read.instances(f"{KIN}Box")
    assert read.listed(box, f"{KIN}size") == (0.06, 0.14, 0.075)
    (cylinder,) = read.instances(f"{KIN}Cylinder")
    assert read.numbers(cylinder, f"{KIN}radius", f"{KIN}length") == (0.032, 0.014)


def test_a_connect_closes_the_loop_where_the_model_is_drawn(four_bar: Robot) -> None:
    loop = four_bar.joints["loop"]
    assert iri(f"{KIN}SphericalJoint") in loop.kinds
    bodies = [four_bar.body_of[each] for each in (loop.base, loop.rider)]
    assert bodies == [four_bar.bodies["coupler"], four_bar.bodies["rocker"]]
    still = {key: [0.0] for key in four_bar.joints}
    tree = Robot(())
    tree.__dict__.update(four_bar.__dict__)
    tree.__dict__["joints"] = {k: j for k, j in four_bar.joints.items() if k != "loop"}
    where = tree.places(frame(four_bar, WORLD), still)
    assert where[loop.base].shift == pytest.approx(where[loop.rider].shift, abs=CLOSE)


def test_an_angle_is_in_degrees_where_the_compiler_says_nothing(four_bar: Robot) -> None:
    (found,) = limits(four_bar, "JointPositionLimit").values()
    assert found == (-80, 80, iri("http://qudt.org/vocab/unit/DEG"))
    assert radians(found[1]) < pi


def test_the_gear_and_the_speed_of_a_servo_are_the_drive_s(four_bar: Robot) -> None:
    (drive,) = four_bar.instances(f"{KIN}Actuator")
    assert four_bar.number(drive, f"{KIN}gear-ratio") == 10
    (speed,) = limits(four_bar, "ActuatorVelocityLimit").values()
    assert speed[:2] == (-4, 4)


def test_a_keyframe_gives_each_joint_its_position() -> None:
    read = mjcf("six-axis")
    values = [
        float(literal_value(value))
        for node in read.instances(f"{QUDT}Quantity")
        for value in read.values(node, f"{QUDT}value")
    ]
    assert sorted(values) == [-0.6, 0, 0, 0, 0.9, 1.2]


def test_a_mesh_is_in_the_folder_that_the_compiler_says(tmp_path: Path) -> None:
    file = tmp_path / "robot.xml"
    file.write_text(
        '<mujoco><compiler meshdir="meshes"/><asset><mesh name="a" file="a.stl" scale="1 2 3"/>'
        '<mesh name="plain" vertex="0 0 0 1 0 0 0 1 0 0 0 1"/></asset>'
        '<worldbody><body name="b"><geom name="look" type="mesh" mesh="a" contype="0"'
        ' conaffinity="0"/><geom name="hull" type="mesh" mesh="plain"/><geom name="ball" size="1"/>'
        "</body></worldbody></mujoco>"
    )
    read = robot(file)
    (look,) = read.instances(f"{KIN}VisualGeometry")
    assert read.value(look, f"{KIN}mesh") == "<file:meshes/a.stl>"
    assert read.listed(look, f"{KIN}scale") == (1, 2, 3)
    (ball,) = read.instances(f"{KIN}CollisionGeometry")
    assert read.number(ball, f"{KIN}radius") == 1
