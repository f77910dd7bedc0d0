"""A robot written as SDF and as URDF is the same robot in the domain vocabulary."""

from __future__ import annotations

import random

import pytest
from lifted import robot
from robot import Robot, name
from test_robot_agreement import SAMPLES, measured, ranges, sizes

CLOSE = 1e-12


@pytest.fixture(scope="module")
def pair() -> tuple[Robot, Robot]:
    """The six-axis arm by its SDF file, and by its URDF file."""
    return robot(SAMPLES / "sdf" / "six-axis.sdf"), robot(SAMPLES / "urdf" / "six-axis.urdf")


def test_bodies_and_joints_have_the_same_names_and_kinds(pair: tuple[Robot, Robot]) -> None:
    ours, theirs = pair
    assert set(ours.bodies) == set(theirs.bodies)
    assert set(ours.joints) == set(theirs.joints)
    for key, joint in theirs.joints.items():
        assert ours.joints[key].kinds == joint.kinds
        for one, other in (
            (ours.joints[key].base, joint.base),
            (ours.joints[key].rider, joint.rider),
        ):
            assert name(ours.body_of[one]) == name(theirs.body_of[other])


def test_axes_are_equal_whatever_they_are_expressed_in(pair: tuple[Robot, Robot]) -> None:
    ours, theirs = pair
    for key, joint in theirs.joints.items():
        if joint.axis is not None:
            assert ours.joints[key].axis == pytest.approx(joint.axis, abs=CLOSE)


def test_bodies_are_in_the_same_places_wherever_joints_are(pair: tuple[Robot, Robot]) -> None:
    numbers = random.Random(20250512)  # noqa: S311
    for _ in range(5):
        positions = {key: [numbers.uniform(-2.0, 2.0)] for key in pair[1].joints}
        places = []
        for described in pair:
            at = described.places(_frame(described, "base"), positions)
            places.append({key: at[_frame(described, key)] for key in described.bodies})
        ours, theirs = places
        for key, there in theirs.items():
            assert ours[key].shift == pytest.approx(there.shift, abs=CLOSE)
            for one, other in zip(ours[key].turn, there.turn, strict=True):
                assert one == pytest.approx(other, abs=CLOSE)


def test_inertias_are_equal(pair: tuple[Robot, Robot]) -> None:
    ours, theirs = pair
    assert ours.inertias == theirs.inertias != {}


def test_limits_are_equal(pair: tuple[Robot, Robot]) -> None:
    ours, theirs = pair
    assert ranges(ours) == ranges(theirs) != {}
    assert sizes(ours) == sizes(theirs) != {}
    assert measured  # both compare the units, too


def _frame(described: Robot, body: str) -> str:
    return f"{described.bodies[body][:-1]}/frame>"
