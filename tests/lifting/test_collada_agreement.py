"""A robot written as COLLADA and as URDF is the same robot in the domain vocabulary."""

from __future__ import annotations

import math
import random
from pathlib import Path

import pytest
from lifted import robot
from robot import Motion, Robot, name
from test_robot_agreement import ranges

CLOSE = 1e-9
UNIT = 0.001
"""Metres in the unit of the COLLADA document."""
JOINTS = {
    "shoulder": ("base", "upper", "revolute", (0.1, -0.2, 0.3), (0, 0, 30), (0, 1, 0)),
    "slide": ("upper", "rod", "prismatic", (0.0, 0.05, 0.4), (0, 90, 0), (0, 0, 1)),
    "wrist": ("rod", "hand", "revolute", (0.0, 0.0, 0.2), (-45, 0, 0), (1, 0, 0)),
}
"""Parent, child, kind, position in metres, turns about x, y and z in degrees, and axis."""
RANGE = {"revolute": (-90.0, 120.0), "prismatic": (0.0, 150.0)}
"""Limits in degrees, or in units of the document."""


def urdf() -> str:
    """Return the robot as URDF."""
    links = "".join(f'<link name="{each}"/>' for each in ("base", "upper", "rod", "hand"))
    joints = ""
    for key, (above, below, kind, at, turns, axis) in JOINTS.items():
        scale = math.pi / 180 if kind == "revolute" else UNIT
        low, high = (each * scale for each in RANGE[kind])
        rpy = " ".join(repr(math.radians(each)) for each in turns)
        joints += (
            f'<joint name="{key}" type="{kind}"><parent link="{above}"/><child link="{below}"/>'
            f'<origin xyz="{" ".join(map(repr, at))}" rpy="{rpy}"/>'
            f'<axis xyz="{" ".join(map(str, axis))}"/>'
            f'<limit lower="{low!r}" upper="{high!r}" effort="1" velocity="1"/></joint>'
        )
    return f'<robot name="arm">{links}{joints}</robot>'


def collada(*, own: bool) -> str:
    """Return the robot as COLLADA; with *own*, the links have transforms of their own."""
    library = instances = ""
    chain = '<link sid="hand" name="hand">{}</link>'
    below = chain.format(OWN if own else "")
    for key, (above, _, kind, at, (x, y, z), axis) in reversed(JOINTS.items()):
        low, high = RANGE[kind]
        library += (
            f'<joint id="{key}" name="{key}"><{kind} sid="axis"><axis>{" ".join(map(str, axis))}'
            f"</axis><limits><min>\n{low}</min><max>{high}</max></limits></{kind}></joint>"
        )
        instances += f'<instance_joint url="#{key}" sid="{key}"/>'
        place = " ".join(repr(each / UNIT) for each in at)
        attached = (
            f'<attachment_full joint="arm/{key}">{BACK if own and above != "base" else ""}'
            f"<translate>{place}</translate><rotate>0 0 1 {z}</rotate><rotate>0 1 0 {y}</rotate>"
            f"<rotate>1 0 0 {x}</rotate>{below}</attachment_full>"
        )
        moved = OWN if own and above != "base" else ""
        below = f'<link sid="{above}" name="{above}">{moved}{attached}</link>'
    return (
        '<COLLADA xmlns="http://www.collada.org/2008/03/COLLADASchema" version="1.5.0"><asset>'
        f'<unit name="millimeter" meter="{UNIT}"/></asset><library_joints>{library}'
        '</library_joints><library_kinematics_models><kinematics_model id="arm" name="arm">'
        f"<technique_common>{instances}{below}</technique_common></kinematics_model>"
        "</library_kinematics_models></COLLADA>"
    )


OWN = "<translate>10 0 -20</translate><rotate>0 0 1 90</rotate>"
"""What a link is moved by behind its joint, and what undoes that."""
BACK = "<rotate>0 0 1 -90</rotate><translate>-10 0 20</translate>"
OWN_MOTION = Motion(((0.0, -1.0, 0.0), (1.0, 0.0, 0.0), (0.0, 0.0, 1.0)), (0.01, 0.0, -0.02))


@pytest.fixture(params=[False, True], ids=["plain", "moved links"])
def pair(request: pytest.FixtureRequest, tmp_path: Path) -> tuple[Robot, Robot, bool]:
    """The arm by its COLLADA document, and by its URDF file, and whether its links are moved."""
    (tmp_path / "arm.dae").write_text(collada(own=request.param), "utf-8")
    (tmp_path / "arm.urdf").write_text(urdf(), "utf-8")
    return robot(tmp_path / "arm.dae"), robot(tmp_path / "arm.urdf"), request.param


def test_bodies_and_joints_have_the_same_names_and_kinds(pair: tuple[Robot, Robot, bool]) -> None:
    ours, theirs, _ = pair
    assert set(ours.bodies) == set(theirs.bodies)
    assert set(ours.joints) == set(theirs.joints)
    for key, joint in theirs.joints.items():
        assert ours.joints[key].kinds == joint.kinds
        assert ours.joints[key].axis == pytest.approx(joint.axis, abs=CLOSE)
        assert name(ours.body_of[ours.joints[key].base]) == name(theirs.body_of[joint.base])


def test_limits_are_equal(pair: tuple[Robot, Robot, bool]) -> None:
    ours, theirs, _ = pair
    here, there = ranges(ours), ranges(theirs)
    assert set(here) == set(there) != set()
    for key, bounds in there.items():
        assert here[key] == pytest.approx(bounds, abs=CLOSE)


def test_bodies_are_in_the_same_places_wherever_joints_are(
    pair: tuple[Robot, Robot, bool],
) -> None:
    """Links that are moved behind their joint carry the next joint to the same place."""
    ours, theirs, moved = pair
    numbers = random.Random(20250512)  # noqa: S311
    for _ in range(5):
        positions = {key: [numbers.uniform(-2.0, 2.0)] for key in theirs.joints}
        there = theirs.places(_frame(theirs, "base"), positions)
        here = ours.places(_frame(ours, "base"), positions)
        for key in theirs.bodies:
            at, seen = here[_frame(ours, key)], there[_frame(theirs, key)]
            if moved and key != "base":
                at = at.then(OWN_MOTION.inverse)
            assert at.shift == pytest.approx(seen.shift, abs=CLOSE)
            for one, other in zip(at.turn, seen.turn, strict=True):
                assert one == pytest.approx(other, abs=CLOSE)


def _frame(described: Robot, body: str) -> str:
    return f"{described.bodies[body][:-1]}/frame>"
