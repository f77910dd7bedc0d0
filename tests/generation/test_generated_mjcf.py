"""Programs from MJCF compute what MuJoCo does."""

from __future__ import annotations

import os

import numpy as np
import pytest
from data import locate_data
from programs import module, program

pytest.importorskip("jinja2")
pytestmark = [pytest.mark.slow, pytest.mark.corpus]

TOLERANCE = 1e-9
CONFIGURATIONS = 20
EACH = 1 if os.environ.get("KINLINT_EACH_ROBOT") == "1" else 5
"""One public robot of so many is compared; `KINLINT_EACH_ROBOT=1` compares all."""
FEWEST = 20 // EACH
"""Of these, programs are made of this many at least."""
ONE_NUMBER = {2, 3}
"""The joints of MuJoCo that slide or turn: `mjJNT_SLIDE`, `mjJNT_HINGE`."""
GRAVITY = (0.0, 0.0, -9.81)


@pytest.fixture(scope="module")
def mujoco():
    return pytest.importorskip("mujoco", reason="compares with MuJoCo")


class Simulation:
    """A robot as MuJoCo reads it, whose joints are at the positions of the program's."""

    def __init__(self, mujoco, model, robot) -> None:
        self.mujoco, self.model, self.robot = mujoco, model, robot
        self.data = mujoco.MjData(model)
        model.opt.gravity[:] = GRAVITY
        joints = {model.joint(each).name: each for each in range(model.njnt)}
        moving = [each for each in robot.JOINTS if each.index >= 0]
        others = iter(sorted(set(joints.values()) - {joints.get(each.name) for each in moving}))
        self.spread = np.zeros((model.nv, len(robot.POSITIONS)))
        self.shift = model.qpos0.copy()
        for each in moving:
            joint = joints[each.name] if each.name in joints else next(others)
            self.spread[model.jnt_dofadr[joint], each.index] = each.factor
            self.shift[model.jnt_dofadr[joint]] += each.offset
        self.root = model.body(robot.ROOT).id if robot.ROOT in self.bodies else 0

    @property
    def bodies(self):
        return {self.model.body(each).name: each for each in range(self.model.nbody)}

    def difference(self, q, v, a) -> float:
        """The largest difference of poses, twists and forces."""
        mujoco, model, data = self.mujoco, self.model, self.data
        data.qpos[:], data.qvel[:] = self.spread @ q + self.shift, self.spread @ v
        data.qacc[:] = self.spread @ a
        mujoco.mj_fwdPosition(model, data)
        mujoco.mj_fwdVelocity(model, data)
        turn, start = data.xmat[self.root].reshape(3, 3), data.xpos[self.root]
        poses, twists = self.robot.forward_position(q), self.robot.forward_velocity(q, v)
        found = []
        for name, body in self.bodies.items():
            if name not in poses:
                continue
            found.append(poses[name][:3, 3] - turn.T @ (data.xpos[body] - start))
            found.append((poses[name][:3, :3] - turn.T @ data.xmat[body].reshape(3, 3)).ravel())
            moved = np.zeros(6)
            kind = mujoco.mjtObj.mjOBJ_XBODY
            mujoco.mj_objectVelocity(model, data, kind, body, moved, 0)
            found.append(twists[name][:3] - turn.T @ moved[3:])
            found.append(twists[name][3:] - turn.T @ moved[:3])
        forces = np.zeros(model.nv)
        mujoco.mj_rne(model, data, 1, forces)
        ours = self.robot.inverse_dynamics(q, v, a, tuple(turn.T @ np.array(GRAVITY)))
        found.append((ours - self.spread.T @ forces) / max(1.0, np.abs(forces).max(initial=0.0)))
        return max(np.abs(each).max(initial=0.0) for each in found)


def test_public_robots_move_as_mujoco_moves_them(mujoco, tmp_path, monkeypatch):
    """All of them whose files MuJoCo finds, but one without gravity and those on free joints."""
    compared, far = 0, {}
    for path in sorted(locate_data("robots", "mjcf").rglob("*.xml"))[::EACH]:
        monkeypatch.chdir(path.parent)
        text = path.read_bytes()
        try:
            model = mujoco.MjModel.from_xml_path(str(path))
        except ValueError:
            continue
        if not model.njnt or model.opt.disableflags & mujoco.mjtDisableBit.mjDSBL_GRAVITY:
            continue
        errors, files = program({path.name: text}, "numpy", tmp_path, general=False)
        codes = {each.rule.code for each in errors}
        assert ("GEN001" in codes) == (not set(model.jnt_type) <= ONE_NUMBER), path
        if errors:
            continue
        robot = module(files["robot.py"])
        simulation = Simulation(mujoco, model, robot)
        states = np.random.default_rng(23).uniform(
            -1.5, 1.5, (CONFIGURATIONS, 3, len(robot.POSITIONS))
        )
        compared += 1
        difference = max(simulation.difference(*each) for each in states)
        if difference > TOLERANCE:
            far[str(path)] = difference
    assert far == {}
    assert compared >= FEWEST
