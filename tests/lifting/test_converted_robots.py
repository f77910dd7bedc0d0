"""A converted robot moves, weighs and is limited as the one that was lifted."""

from __future__ import annotations

import random
import re
from pathlib import Path

import pytest
from data import locate_data
from lifted import robot
from robot import Robot

from kinlint.cli.main import main
from kinlint.conversion.composition import compose
from kinlint.conversion.output import jsonld
from kinlint.conversion.rotations import ROTATIONS
from kinlint.errors import KinlintError
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode, read
from kinlint.terms import Term, literal_value
from kinlint.text import SourceText
from kinlint.vocabulary import KIN

SAMPLES = Path(__file__).resolve().parents[2] / "samples"
NUMBERS = ("lower", "upper", "multiplier", "offset", "radius", "length", "advance-per-turn")
REFERENCES = ("of-body", "of-joint", "of-actuator", "actuates", "leader", "follower", "mesh")
STATED = (
    *("JointPositionLimit", "JointCoupling", "ThreadPitch", "VisualGeometry", "CollisionGeometry"),
    *("Actuator", "ActuatorForceLimit", "ActuatorVelocityLimit", "ActuatorAccelerationLimit"),
)
EXACT = 1e-12
WORLD = re.compile("world/[^/]+")
"""The name of a world: one with several models is a body, by which they are placed."""
MOST = 20_000
"""The size in bytes of the largest file that is tried."""


@pytest.mark.slow
@pytest.mark.parametrize("rotation", ROTATIONS)
@pytest.mark.parametrize(
    "path",
    sorted(SAMPLES.glob("urdf/*.urdf")) + sorted(SAMPLES.glob("sdf/*.sdf")),
    ids=lambda path: path.name,
)
def test_samples(path: Path, rotation: str) -> None:
    same(robot(path), converted(path, rotation))


@pytest.mark.corpus
@pytest.mark.parametrize(("folder", "pattern"), [("urdf", "*.urdf"), ("sdf", "*.sdf")])
def test_real_robots(folder: str, pattern: str) -> None:
    tried = 0
    for path in sorted(locate_data("robots", folder).rglob(pattern))[::6]:
        if path.stat().st_size > MOST:
            continue
        try:
            other = converted(path, ROTATIONS[tried % len(ROTATIONS)])
        except KinlintError:
            continue
        same(robot(path), other)
        tried += 1
    assert tried >= 15


TURNED = """<robot name="r" version="1.1"><link name="a"/><link name="b"><visual><geometry>
<sphere radius="1"/></geometry></visual><visual name="moved"><origin xyz="0 0 1"/><geometry>
<sphere radius="1"/></geometry></visual></link><joint name="j" type="revolute">
<parent link="a"/><child link="b"/><origin {origin}/><axis xyz="{axis}"/>
<limit lower="-1" upper="1" effort="2" velocity="3"/></joint></robot>"""


@pytest.mark.slow
@pytest.mark.parametrize("rotation", ROTATIONS)
@pytest.mark.parametrize("axis", ["1 0 0", "0 1 0", "0 0 1", "0 0 -1", "0.6 0 0.8", "0 0 2"])
@pytest.mark.parametrize(
    "origin",
    [
        'rpy="0 0 0"',
        'rpy="0.4 -1.1 2.9" xyz="1 2 3"',
        'rpy="0.3 1.5707963267948966 0.2"',
        'rpy="0.3 -1.5707963267948966 0.2"',
        'quat_xyzw="0.1 0.2 -0.3 0.9"',
        'quat_xyzw="0 0.7071067811865476 0 0.7071067811865476"',
        'quat_xyzw="0 0 0 -1"',
    ],
)
def test_any_rotation_and_axis(tmp_path: Path, origin: str, axis: str, rotation: str) -> None:
    path = tmp_path / "r.urdf"
    path.write_text(TURNED.format(origin=origin, axis=axis), encoding="utf-8")
    same(robot(path), converted(path, rotation))


def converted(path: Path, rotation: str) -> Robot:
    document = read(decode(path.name, path.read_bytes()), ReadOptions())
    text = jsonld(compose([document], rotation=rotation))
    return Robot(read(SourceText("robot.jsonld", text), ReadOptions()).statements)


def local(term: Term) -> str:
    """The name of a node in its file."""
    return term[1:-1].partition("#")[2] or term


def same(lifted: Robot, other: Robot) -> None:
    worlds = [key for key in other.bodies if WORLD.fullmatch(local(other.bodies[key]))]
    assert set(lifted.bodies) | {*worlds} == set(other.bodies)
    assert {local(each.node) for each in lifted.joints.values()} == {
        local(each.node) for each in other.joints.values()
    }
    same_places(lifted, other)
    left_out = lifted.inertias.keys() - other.inertias.keys()
    assert [lifted.inertias[body].mass for body in left_out] in ([], [0.0])
    for body, there in other.inertias.items():
        inertia = lifted.inertias[body]
        assert there.mass == inertia.mass
        assert there.centre == pytest.approx(inertia.centre, abs=EXACT)
        for one, two in zip(there.tensor, inertia.tensor, strict=True):
            assert one == pytest.approx(two, rel=1e-9, abs=EXACT)
    for kind in STATED:
        nodes = {local(each): each for each in other.instances(KIN + kind)}
        assert {local(each) for each in lifted.instances(KIN + kind)} == set(nodes)
        for node in lifted.instances(KIN + kind):
            assert stated(other, nodes[local(node)]) == both_ways(stated(lifted, node))


def same_places(lifted: Robot, other: Robot) -> None:
    """Frames are at the same places; only a model with free bodies relates more of them."""
    numbers = random.Random(7)  # noqa: S311
    positions = {
        key: [*(numbers.uniform(-1.0, 1.0) for _ in range(3)), 0.0, 0.0, 0.0, 1.0]
        for key in lifted.joints
    }
    places = {
        body: lifted.places(f"{node[:-1]}/frame>", positions)
        for body, node in lifted.bodies.items()
    }
    ends = {end for joint in lifted.joints.values() for end in (joint.base, joint.rider)}
    free = any(ends.isdisjoint(ours) for ours in places.values())
    for body, ours in places.items():
        theirs = other.places(f"{other.bodies[body][:-1]}/frame>", positions)
        found = {local(frame): place for frame, place in theirs.items()}
        reached = {local(frame) for frame in ours}
        assert free or set(found) <= reached
        assert {f"{local(each)}/frame" for each in lifted.bodies.values()} & reached <= set(found)
        for frame, place in ours.items():
            if there := found.get(local(frame)):
                assert there.shift == pytest.approx(place.shift, abs=EXACT)
                for one, two in zip(there.turn, place.turn, strict=True):
                    assert one == pytest.approx(two, abs=EXACT)


def stated(described: Robot, node: Term) -> dict[str, list[float] | list[str]]:
    numbers = {
        key: [float(literal_value(each)) for each in described.values(node, KIN + key)]
        for key in NUMBERS
    }
    others = {key: [*map(local, described.values(node, KIN + key))] for key in REFERENCES}
    return {**numbers, **others}


def both_ways(said: dict[str, list[float] | list[str]]) -> dict[str, list[float] | list[str]]:
    """What a limit of an actuator by its magnitude comes to."""
    if said["of-actuator"] and said["upper"] and not said["lower"]:
        (upper,) = map(float, said["upper"])
        return {**said, "lower": [0.0 - upper]}
    return said


@pytest.mark.corpus
@pytest.mark.parametrize(
    "name", ["usd/clean-four-bar.usda", "usd/clean-arm.usda", "collada/clean-loop.dae"]
)
def test_nothing_differs_from_the_model_that_was_converted(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Shapes and loops too, whose joints have no order of their bodies any more."""
    path, made = locate_data("defects") / name, tmp_path / "robot.jsonld"
    assert main(["convert", "-q", str(path), "-o", str(made)]) == 0
    assert main(["diff", str(path), str(made)]) == 0
    assert "only in" not in capsys.readouterr().out


@pytest.mark.slow
def test_placed_shapes_of_sdf_are_on_their_bodies(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Where a collision has a pose, its frame is one of the link."""
    path, made = tmp_path / "robot.sdf", tmp_path / "robot.jsonld"
    path.write_text(
        """<sdf version="1.9"><model name="arm"><link name="a"/><link name="b"><collision name="c">
        <pose>0 0 0.1 0 0 0</pose><geometry><sphere><radius>0.1</radius></sphere></geometry>
        </collision></link><joint name="j" type="revolute"><parent>a</parent><child>b</child>
        <axis><xyz>0 0 1</xyz></axis></joint></model></sdf>"""
    )
    assert main(["convert", "-q", str(path), "-o", str(made)]) == 0
    assert main(["diff", str(path), str(made)]) == 0
    assert "only in" not in capsys.readouterr().out
