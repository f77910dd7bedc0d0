"""Links of real robots are where Pinocchio has them with all joints at zero."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from data import locate_data
from pinocchio_robots import silence
from support.linting import lint

from kinlint.structure import Structure

pytestmark = [pytest.mark.oracle, pytest.mark.xdist_group("Pinocchio")]

TOLERANCE = 1e-9
FEWEST = 100
"""Of the robots in the data, this many at least are compared."""


def robots(data: Path) -> list[Path]:
    """The first robot of each directory."""
    found: dict[Path, Path] = {}
    for path in sorted(data.rglob("*.urdf")):
        found.setdefault(path.parent, path)
    return list(found.values())


def far(pin: Any, model: Any, robot: Structure) -> float:
    """The largest distance of a link in m, relative to that from the root where it is above one."""
    data = model.createData()
    pin.framesForwardKinematics(model, data, pin.neutral(model))
    largest = 0.0
    for link in robot.links:
        index = model.getFrameId(link.name, pin.FrameType.BODY)
        if index < model.nframes:
            assert link.point is not None, link.name
            there = data.oMf[index].translation
            size = max(1.0, *map(abs, there))
            apart = (abs(ours - theirs) for ours, theirs in zip(link.point, there, strict=True))
            largest = max(largest, *(each / size for each in apart))
    return largest


def test_links_are_where_pinocchio_has_them() -> None:
    pin = pytest.importorskip("pinocchio", reason="compares with Pinocchio, PyPI's pin")
    compared = {}
    for path in robots(locate_data("robots", "urdf")):
        try:
            with silence():
                model = pin.buildModelFromUrdf(str(path))
        except (ValueError, RuntimeError):
            continue
        report = lint({"robot.urdf": path.read_text("utf-8")}, drawn=True)
        if len(report.structures) == 1 and len(report.structures[0].roots) == 1:
            compared[str(path)] = far(pin, model, report.structures[0])
    assert {path: apart for path, apart in compared.items() if not apart <= TOLERANCE} == {}
    assert len(compared) >= FEWEST
