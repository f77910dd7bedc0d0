"""Differences between public descriptions of one robot: `python tests/real_drifts.py`.

Prints the page that is kept in rules/real-drifts.md, by `kinlint diff` with the tolerances for two
formats.
"""

from __future__ import annotations

import io
import json
import sys
from collections.abc import Iterator
from contextlib import redirect_stdout
from functools import cache
from pathlib import PurePosixPath
from typing import Any

from data import locate_data

from kinlint.cli.main import main

EXAMPLES, PYBULLET = "urdf/example_robot_data/robots", "urdf/pybullet_data"
CASSIE = "sdf/example_robot_data/robots/cassie_description/robots"
GYMNASIUM = "mjcf/gymnasium/gymnasium/envs/mujoco/assets"
CONTROL = "mjcf/dm_control/dm_control"
PAIRS = (
    (f"{EXAMPLES}/panda_description/urdf/panda.urdf", f"{PYBULLET}/franka_panda/panda.urdf"),
    (
        f"{EXAMPLES}/panda_description/urdf/panda.urdf",
        f"{EXAMPLES}/panda_description/urdf/panda_collision.urdf",
    ),
    (f"{EXAMPLES}/a1_description/urdf/a1.urdf", f"{PYBULLET}/a1/a1.urdf"),
    (f"{EXAMPLES}/laikago_description/urdf/laikago.urdf", f"{PYBULLET}/laikago/laikago.urdf"),
    (f"{PYBULLET}/laikago/laikago.urdf", f"{PYBULLET}/laikago/laikago_toes.urdf"),
    (
        f"{EXAMPLES}/kinova_description/robots/kinova.urdf",
        f"{CONTROL}/third_party/kinova/jaco_arm.xml",
    ),
    (
        f"{EXAMPLES}/pr2_description/urdf/pr2.urdf",
        "sdf/sdformat/test/integration/model/pr2.sdf",
    ),
    (
        f"{EXAMPLES}/simple_humanoid_description/urdf/simple_humanoid.urdf",
        f"{EXAMPLES}/simple_humanoid_description/urdf/simple_humanoid_classical.urdf",
    ),
    (
        f"{EXAMPLES}/talos_data/robots/talos_reduced.urdf",
        f"{EXAMPLES}/talos_data/robots/talos_full_v2.urdf",
    ),
    (
        f"{EXAMPLES}/ur_description/urdf/ur5_robot.urdf",
        f"{EXAMPLES}/ur_description/urdf/ur5_joint_limited_robot.urdf",
    ),
    (
        f"{EXAMPLES}/icub_description/robots/icub.urdf",
        f"{EXAMPLES}/icub_description/robots/icub_reduced.urdf",
    ),
    (f"{CASSIE}/cassie.sdf", f"{CASSIE}/cassie_v2.sdf"),
    (
        "collada/kdl_collada/examples/puma.dae",
        "collada/openrave/src/robots/pumaarm.zae.d/pumaarm.dae",
    ),
    (f"{CONTROL}/mujoco/testing/assets/humanoid.xml", f"{GYMNASIUM}/humanoid.xml"),
    (f"{CONTROL}/suite/humanoid.xml", f"{GYMNASIUM}/humanoid.xml"),
    (f"{GYMNASIUM}/walker2d.xml", f"{GYMNASIUM}/walker2d_v5.xml"),
    (f"{GYMNASIUM}/pusher.xml", f"{GYMNASIUM}/pusher_v5.xml"),
    (f"{PYBULLET}/quadruped/minitaur.urdf", f"{PYBULLET}/quadruped/minitaur_v1.urdf"),
    (f"{PYBULLET}/kuka_iiwa/model_for_sdf.urdf", f"{PYBULLET}/kuka_iiwa/model_vr_limits.urdf"),
)
"""Descriptions of one robot among the public ones, below the directory of robots."""

INTRODUCTION = """\
## Two descriptions of one robot

Differences that `kinlint diff` finds with rounded tolerances between public descriptions of one
robot from example-robot-data, PyBullet, dm_control, Gymnasium, OpenRAVE, KDL and the tests of
libsdformat. Parts are matched by name, or else by structure and numbers. Of each quantity the
number of differences is given, with the first of them.

Made by `python tests/real_drifts.py > rules/real-drifts.md`; a test holds kinlint to it.
"""


@cache
def difference(old: str, new: str) -> dict[str, Any]:
    """Return what `kinlint diff` says of two files below the directory of robots."""
    root = locate_data("robots")
    said = io.StringIO()
    paths = [str(root / each) for each in (old, new)]
    with redirect_stdout(said):
        main(["diff", *paths, "--isolated", "--output-format", "json", "--tolerance", "rounded"])
    (found,) = json.loads(said.getvalue())
    return found  # type: ignore[no-any-return]


def page() -> Iterator[str]:
    """The page, line by line."""
    yield from INTRODUCTION.splitlines()
    for old, new in PAIRS:
        found = difference(old, new)
        joints = found["joints"]
        yield ""
        yield f"### {_short(old)} and {_short(new)}"
        yield ""
        yield (
            f"{joints['common']} of {joints['old']} and {joints['new']} joints in common, "
            f"by {found['matchedBy']}."
        )
        rows = list(_rows(found))
        if rows:
            yield ""
            yield "| quantity | differences | first |"
            yield "|---|---:|---|"
            yield from rows


def _rows(found: dict[str, Any]) -> Iterator[str]:
    """Yield a row for each quantity that differs."""
    kinds: dict[str, list[dict[str, Any]]] = {}
    for each in found["changes"]:
        kinds.setdefault(f"{each['quantity']} of {each['kind']}s", []).append(each)
    for kind, changes in kinds.items():
        first = changes[0]
        title = f"{first['kind']} {first['part']}" if first["part"] else "robot"
        name = kind if first["part"] else kind.removesuffix(" of robots")
        yield f"| {name} | {len(changes)} | {title}: {first['text']} |"
    for way in ("removed", "added"):
        if parts := found[way]:
            yield f"| {way} | {len(parts)} | {parts[0]['kind']} {parts[0]['name']} |"


def _short(name: str) -> str:
    """Return the project and the name of a file."""
    path = PurePosixPath(name)
    return f"{path.parts[1]}: {path.name}"


if __name__ == "__main__":
    sys.stdout.writelines(f"{line}\n" for line in page())
