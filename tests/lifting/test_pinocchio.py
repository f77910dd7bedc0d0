"""What is lifted from real robots moves and weighs as Pinocchio computes it."""

from __future__ import annotations

import math
import random
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import pytest
from data import locate_data
from lifted import robot
from pinocchio_robots import ROOT, configuration, silence
from robot import ZERO, Inertia, Motion, Robot

from kinlint.errors import SourceError
from kinlint.facts.linear_algebra import scale

pytestmark = [pytest.mark.oracle, pytest.mark.xdist_group("Pinocchio")]

TOLERANCE = 1e-9
CONFIGURATIONS = 3
FEWEST = 250
"""Of the robots in the data, this many at least are compared."""


class Compared(NamedTuple):
    """The largest differences of one robot, each relative to the size of what differs."""

    path: str
    frames: int
    places: float
    masses: float
    inertias: float


NOTHING = Inertia(0.0, ZERO, (ZERO, ZERO, ZERO))


@pytest.fixture(scope="module")
def compared() -> list[Compared]:
    pin = pytest.importorskip("pinocchio", reason="compares with Pinocchio, PyPI's pin")
    data = locate_data("robots", "urdf")
    found = []
    for path in sorted(data.rglob("*.urdf")):
        try:
            with silence():
                model = pin.buildModelFromUrdf(str(path), pin.JointModelFreeFlyer(), ROOT)
        except (ValueError, RuntimeError):
            continue
        try:
            ours = robot(path)
        except SourceError:
            continue
        found.append(_compare(pin, str(path.relative_to(data)), model, ours))
    return found


def test_many_robots_are_compared(compared: list[Compared]) -> None:
    assert len(compared) >= FEWEST
    assert sum(one.frames for one in compared) >= 10 * FEWEST


@pytest.mark.parametrize("quantity", ["places", "masses", "inertias"])
def test_agrees(compared: list[Compared], quantity: str) -> None:
    assert [one for one in compared if not getattr(one, quantity) <= TOLERANCE] == []


def _compare(pin: Any, path: str, model: Any, ours: Robot) -> Compared:
    links = [each for each in model.frames if each.type == pin.FrameType.BODY]
    assert {each.name for each in links} == set(ours.bodies), path
    random_numbers = random.Random(path)  # noqa: S311
    data, places = model.createData(), 0.0
    for _ in range(CONFIGURATIONS):
        positions, q = configuration(pin, model, lambda _: random_numbers)
        pin.framesForwardKinematics(model, data, q)
        where = ours.places(_frame(ours, links[0].name), positions)
        first = data.oMf[model.getFrameId(links[0].name, pin.FrameType.BODY)]
        for link in links:
            there = first.inverse() * data.oMf[model.getFrameId(link.name, pin.FrameType.BODY)]
            places = max(places, _apart(where[_frame(ours, link.name)], there))
    masses, inertias = _weighed(pin, model, ours)
    return Compared(path, len(links), places, masses, inertias)


def _frame(ours: Robot, link: str) -> str:
    return ours.bodies[link][:-1] + "/frame>"


def _apart(ours: Motion, theirs: Any) -> float:
    """The largest difference of an entry, relative to the distance where that is above one."""
    far = max(1.0, *map(abs, theirs.translation))
    turns = (abs(ours.turn[i][j] - theirs.rotation[i, j]) for i in range(3) for j in range(3))
    shifts = (abs(ours.shift[i] - theirs.translation[i]) / far for i in range(3))
    return max(*turns, *shifts)


def _weighed(pin: Any, model: Any, ours: Robot) -> tuple[float, float]:
    """How far the total mass differs, and at most the lump of bodies that one joint carries."""
    total = math.fsum(inertia.mass for inertia in ours.inertias.values())
    masses = _relative([total], [pin.computeTotalMass(model)])
    lumps, inertias = _lumps(model, ours), 0.0
    for index in range(1, model.njoints):
        lump = lumps.get(model.names[index], NOTHING)
        mass, x, y, z, xx, xy, yy, xz, yz, zz = model.inertias[index].toDynamicParameters()
        tensor = [each for row in lump.about(ZERO) for each in row]
        inertias = max(
            inertias,
            _relative([lump.mass], [mass]),
            _relative(scale(lump.mass, lump.centre), [x, y, z]),
            _relative(tensor, [xx, xy, xz, xy, yy, yz, xz, yz, zz]),
        )
    return masses, inertias


def _relative(ours: Sequence[float], theirs: Sequence[float]) -> float:
    """The largest difference of an entry, relative to the largest entry."""
    largest = max(map(abs, theirs)) or 1.0
    return max(abs(a - b) / largest for a, b in zip(ours, theirs, strict=True))


def _lumps(model: Any, ours: Robot) -> Mapping[str, Inertia]:
    """What each joint of the model carries up to the next, seen by the frame of the joint."""
    lumps: dict[str, Inertia] = {}
    carried = {joint.rider: key for key, joint in ours.joints.items()}
    for link, seen in ours.inertias.items():
        frame = _frame(ours, link)
        while frame in carried and not model.existJointName(carried[frame]):
            base, motion = ours.poses[ours.joints[carried[frame]].base]
            frame, seen = base, seen.seen(motion)  # noqa: PLW2901
        joint = carried.get(frame, ROOT)
        lumps[joint] = lumps.get(joint, NOTHING).with_(seen)
    return lumps
