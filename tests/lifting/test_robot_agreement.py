"""A robot written as URDF and as composable JSON-LD is the same robot in the domain vocabulary."""

from __future__ import annotations

import random
from collections.abc import Iterator
from pathlib import Path

import pytest
from lifted import robot
from robot import Motion, Robot, name

from kinlint.terms import Term, literal_value
from kinlint.vocabulary import KIN, QUDT

SAMPLES = Path(__file__).resolve().parents[2] / "samples"
ROBOTS = ("six-axis", "gripper")
PRINTED = 1e-8
"""The JSON-LD samples print direction cosines with nine decimals."""


@pytest.fixture(params=ROBOTS)
def pair(request: pytest.FixtureRequest) -> tuple[Robot, Robot]:
    """The robot by its URDF file, and by its JSON-LD files."""
    composed = sorted((SAMPLES / request.param).glob("*.jsonld"))
    return robot(SAMPLES / "urdf" / f"{request.param}.urdf"), robot(*composed)


def test_bodies_and_joints_have_the_same_names_and_kinds(pair: tuple[Robot, Robot]) -> None:
    lifted, composed = pair
    assert set(lifted.bodies) >= set(composed.bodies)
    assert set(lifted.joints) >= set(composed.joints)
    for key, joint in composed.joints.items():
        assert lifted.joints[key].kinds == joint.kinds


def test_joints_join_the_same_bodies_about_the_same_axes(pair: tuple[Robot, Robot]) -> None:
    lifted, composed = pair
    for key, joint in composed.joints.items():
        same = lifted.joints[key]
        for ours, theirs in ((same.base, joint.base), (same.rider, joint.rider)):
            assert name(lifted.body_of[ours]) == name(composed.body_of[theirs])
        assert same.axis == pytest.approx(joint.axis, abs=PRINTED)


def test_bodies_are_in_the_same_places(pair: tuple[Robot, Robot]) -> None:
    lifted, composed = pair
    numbers = random.Random(20250501)  # noqa: S311
    for _ in range(5):
        positions = {key: [numbers.uniform(-2.0, 2.0)] for key in composed.joints}
        (first, *_) = roots(composed)
        ours = lifted.places(lifted.bodies[first][:-1] + "/frame>", positions)
        theirs = composed.places(root_frame(composed, first), positions)
        for key in composed.bodies:
            close(ours[lifted.bodies[key][:-1] + "/frame>"], theirs[root_frame(composed, key)])


def test_flange_is_where_the_frame_is() -> None:
    lifted = robot(SAMPLES / "urdf" / "six-axis.urdf")
    composed = robot(SAMPLES / "six-axis" / "arm.jsonld")
    (flange,) = (frame for frame in composed.poses if name(frame) == "hand-flange")
    close(lifted.poses[lifted.joints["hand-flange"].base][1], composed.poses[flange][1])


def test_inertias_are_equal(pair: tuple[Robot, Robot]) -> None:
    lifted, composed = pair
    assert set(lifted.inertias) == set(composed.inertias) == set(composed.bodies)
    for key, inertia in composed.inertias.items():
        same = lifted.inertias[key]
        assert same.mass == inertia.mass
        assert same.centre == pytest.approx(inertia.centre, abs=1e-15)
        for ours, theirs in zip(same.tensor, inertia.tensor, strict=True):
            assert ours == pytest.approx(theirs, abs=1e-15)


def test_ranges_couplings_and_actuators_are_equal() -> None:
    lifted = robot(SAMPLES / "urdf" / "gripper.urdf")
    composed = robot(*sorted((SAMPLES / "gripper").glob("*.jsonld")))
    assert ranges(lifted) == ranges(composed) != {}
    assert couplings(lifted) == couplings(composed) != {}
    ours = sizes(lifted)
    theirs = sizes(composed)
    assert {kind for _, kind in theirs} == {"ActuatorForceLimit", "ActuatorVelocityLimit"}
    assert {key: ours[key] for key in theirs} == theirs


def test_shapes_are_equal() -> None:
    lifted = robot(SAMPLES / "urdf" / "gripper.urdf")
    composed = robot(*sorted((SAMPLES / "gripper").glob("*.jsonld")))
    ours, theirs = shapes(lifted), shapes(composed)
    assert set(ours) == set(theirs) != set()
    for key, (kinds, owner, sizes_) in theirs.items():
        assert ours[key][:2] == (kinds, owner)
        factor = 1e-3 if key == "mount-collision" else 1.0
        assert ours[key][2] == pytest.approx([factor * size for size in sizes_])


def close(ours: Motion, theirs: Motion) -> None:
    assert ours.shift == pytest.approx(theirs.shift, abs=PRINTED)
    for one, other in zip(ours.turn, theirs.turn, strict=True):
        assert one == pytest.approx(other, abs=PRINTED)


def roots(described: Robot) -> list[str]:
    """The bodies that no joint carries."""
    carried = {described.body_of[joint.rider] for joint in described.joints.values()}
    return [key for key, body in described.bodies.items() if body not in carried]


def root_frame(described: Robot, body: str) -> Term:
    """In the JSON-LD samples, the frame by which the others of a body are posed."""
    return f"{described.bodies[body][:-1]}-root>"


def ranges(described: Robot) -> dict[str, tuple[float, float, Term, Term]]:
    return {
        name(described.value(node, f"{KIN}of-joint")): (
            *described.numbers(node, f"{KIN}lower", f"{KIN}upper"),
            *measured(described, node),
        )
        for node in described.instances(f"{KIN}JointPositionLimit")
    }


def couplings(described: Robot) -> dict[str, tuple[str, float, float, Term, Term]]:
    return {
        name(described.value(node, f"{KIN}follower")): (
            name(described.value(node, f"{KIN}leader")),
            *described.numbers(node, f"{KIN}multiplier", f"{KIN}offset"),
            *measured(described, node),
        )
        for node in described.instances(f"{KIN}JointCoupling")
    }


def sizes(described: Robot) -> dict[tuple[str, str], tuple[float, Term, Term]]:
    """Up to what size a joint's actuator moves it, by kind of limit."""
    return {
        (
            name(described.value(described.value(node, f"{KIN}of-actuator"), f"{KIN}actuates")),
            kind,
        ): (
            described.number(node, f"{KIN}upper"),
            *measured(described, node),
        )
        for kind in ("ActuatorForceLimit", "ActuatorVelocityLimit")
        for node in described.instances(KIN + kind)
    }


def measured(described: Robot, node: Term) -> tuple[Term, Term]:
    return described.value(node, f"{QUDT}hasQuantityKind"), described.value(node, f"{QUDT}unit")


def shapes(described: Robot) -> dict[str, tuple[frozenset[Term], str, list[float]]]:
    return {
        name(node): (
            described.kinds(node),
            name(described.value(node, f"{KIN}of-body")),
            list(extents(described, node)),
        )
        for node in described.instances(f"{KIN}CollisionGeometry")
    }


def extents(described: Robot, node: Term) -> Iterator[float]:
    for key in ("radius", "length"):
        yield from (float(literal_value(each)) for each in described.values(node, KIN + key))
    if described.values(node, f"{KIN}size"):
        yield from described.listed(node, f"{KIN}size")
