"""A robot written as USD and as URDF is the same robot in the domain vocabulary."""

from __future__ import annotations

import math
import random
from pathlib import Path

import pytest
from lifted import robot
from robot import Robot, name
from test_collada_agreement import CLOSE, JOINTS, RANGE, urdf
from test_robot_agreement import ranges

from kinlint.formats.rigid_transform import transform

UNITS = [1.0, 0.001]
"""Metres in the unit of the stage."""


def usd(unit: float, *, swapped: bool) -> str:
    """Return the robot as USD in lengths of *unit* metres; with *swapped*, body1 is the parent."""
    prims = ""
    for each in ("base", "upper", "rod", "hand"):
        prims += (
            f'def Xform "{each}" (\n    prepend apiSchemas = ["PhysicsRigidBodyAPI"]\n)\n{{\n}}\n'
        )
    for key, (above, below, kind, at, turns, axis) in JOINTS.items():
        place = transform((*(each / unit for each in at), *turns), degrees=True)
        assert place is not None
        (x, y, z), (qx, qy, qz, qw) = place
        near, far = (1, 0) if swapped else (0, 1)
        low, high = RANGE[kind]
        if kind == "prismatic":
            low, high = low * 0.001 / unit, high * 0.001 / unit
        if swapped:
            low, high = -high, -low
        prims += f"""
def Physics{kind.capitalize()}Joint "{key}"
{{
    uniform token physics:axis = "{"XYZ"[axis.index(1)]}"
    rel physics:body{near} = </{above}>
    rel physics:body{far} = </{below}>
    point3f physics:localPos{near} = ({x!r}, {y!r}, {z!r})
    quatf physics:localRot{near} = ({qw!r}, {qx!r}, {qy!r}, {qz!r})
    float physics:lowerLimit = {low!r}
    float physics:upperLimit = {high!r}
}}
"""
    if swapped:
        prims = prims.replace('"PhysicsRigidBodyAPI"', '"PhysicsRigidBodyAPI", "ROOT"', 1)
        prims = prims.replace("ROOT", "PhysicsArticulationRootAPI")
    return f"#usda 1.0\n(\n    metersPerUnit = {unit!r}\n    kilogramsPerUnit = 1\n)\n{prims}"


@pytest.fixture(params=[(unit, swapped) for unit in UNITS for swapped in (False, True)], ids=str)
def pair(request: pytest.FixtureRequest, tmp_path: Path) -> tuple[Robot, Robot, bool]:
    """The arm by its stage, and by its URDF file, and whether its joints name the child first."""
    unit, swapped = request.param
    (tmp_path / "arm.usda").write_text(usd(unit, swapped=swapped), "utf-8")
    (tmp_path / "arm.urdf").write_text(urdf(), "utf-8")
    return robot(tmp_path / "arm.usda"), robot(tmp_path / "arm.urdf"), swapped


def test_bodies_and_joints_have_the_same_names_and_kinds(pair: tuple[Robot, Robot, bool]) -> None:
    """A joint that names the child first turns the other way."""
    ours, theirs, swapped = pair
    sign = -1 if swapped else 1
    assert set(ours.bodies) == set(theirs.bodies)
    assert set(ours.joints) == set(theirs.joints)
    for key, joint in theirs.joints.items():
        assert ours.joints[key].kinds == joint.kinds
        assert joint.axis is not None
        expected = [sign * each for each in joint.axis]
        assert ours.joints[key].axis == pytest.approx(expected, abs=CLOSE)
        assert name(ours.body_of[ours.joints[key].base]) == name(theirs.body_of[joint.base])


def test_limits_are_equal(pair: tuple[Robot, Robot, bool]) -> None:
    """Of a joint that names the child first they are those of the opposite direction."""
    ours, theirs, swapped = pair
    here, there = ranges(ours), ranges(theirs)
    assert set(here) == set(there) != set()
    for key, (low, high, *_) in there.items():
        lower, upper, kind, unit = here[key]
        scale = math.pi / 180 if "Angle" in f"{kind}{unit}" else 1.0
        expected = (-high, -low) if swapped else (low, high)
        assert (lower * scale, upper * scale) == pytest.approx(expected, abs=CLOSE)


def test_bodies_are_in_the_same_places_wherever_joints_are(
    pair: tuple[Robot, Robot, bool],
) -> None:
    ours, theirs, swapped = pair
    numbers = random.Random(20250512)  # noqa: S311
    for _ in range(5):
        positions = {key: [numbers.uniform(-2.0, 2.0)] for key in theirs.joints}
        turned = {key: [-value if swapped else value] for key, (value,) in positions.items()}
        there = theirs.places(_frame(theirs, "base"), positions)
        here = ours.places(_frame(ours, "base"), turned)
        for key in theirs.bodies:
            at, seen = here[_frame(ours, key)], there[_frame(theirs, key)]
            assert at.shift == pytest.approx(seen.shift, abs=CLOSE)
            for one, other in zip(at.turn, seen.turn, strict=True):
                assert one == pytest.approx(other, abs=CLOSE)


def _frame(described: Robot, body: str) -> str:
    return f"{described.bodies[body][:-1]}/frame>"
