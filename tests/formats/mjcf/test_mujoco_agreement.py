"""What is stated of a model is what MuJoCo computes: places of bodies, masses and inertias."""

from __future__ import annotations

from pathlib import Path

import pytest
from data import locate_data

mujoco = pytest.importorskip("mujoco", reason="the wheel of MuJoCo is not installed")
from simulated import differences, stated  # noqa: E402  it needs MuJoCo

pytestmark = pytest.mark.external
TOLERANCE = 1e-9
GEOMS = """
<mujoco>
  <compiler {settings}/>
  <default><default class="slim"><geom size="0.02"/></default></default>
  <worldbody>
    <body name="base" pos="1 2 3" euler="10 20 30">
      <freejoint/>
      <geom type="box" size="0.1 0.2 0.3" pos="0.1 0 0" quat="1 1 0 0.5"/>
      <geom type="capsule" size="0.05 0.2" zaxis="1 1 0" density="500"/>
      <body name="upper" pos="0.3 0 0.1" axisangle="1 1 0 40">
        <joint type="hinge" axis="1 0 1" pos="0.1 0.2 0" ref="15"/>
        <joint type="slide" axis="0 1 1" ref="0.1"/>
        <geom type="cylinder" class="slim" fromto="0 0 0 0.3 0.1 0.2"/>
        <geom type="ellipsoid" size="0.1 0.05 0.02" mass="0.4" xyaxes="1 1 0 0 1 0.3"/>
        <frame pos="0 0 0.5" euler="0 45 0">
          <body name="fore" pos="0.1 0 0" zaxis="0 0.3 -1">
            <joint type="ball" pos="0 0 -0.1"/>
            <inertial pos="0.1 0 0" mass="0.7" fullinertia="0.02 0.03 0.04 0.001 0.002 0.003"/>
            <body name="tool" pos="0 0 0.2">
              <joint axis="0 1 0"/>
              <inertial pos="0 0 0.1" mass="0.2" diaginertia="0.01 0.004 0.0061" euler="20 0 5"/>
              <geom size="0.1" group="3"/>
              <geom size="0.1 0.3" type="capsule" shellinertia="true" pos="0.1 0 0"/>
              <geom size="0.1 0.2" type="cylinder" shellinertia="true"/>
              <geom size="0.1 0.2 0.3" type="box" shellinertia="true" mass="2"/>
              <geom size="0.2" shellinertia="true" group="3"/>
            </body>
          </body>
        </frame>
        <replicate count="3" offset="0.1 0 0.2" euler="0 0 20">
          <body name="leg" pos="0 0.1 0"><joint axis="1 0 0"/><geom size="0.04"/></body>
        </replicate>
      </body>
    </body>
  </worldbody>
</mujoco>
"""


@pytest.mark.parametrize(
    "settings",
    [
        "",
        'angle="radian"',
        'eulerseq="XYZ"',
        'eulerseq="zXy"',
        'inertiafromgeom="true"',
        'boundmass="0.5" boundinertia="0.01"',
        'balanceinertia="true"',
        'settotalmass="3"',
        'inertiagrouprange="0 2"',
    ],
)
def test_every_setting_of_the_compiler_counts(settings: str, tmp_path: Path) -> None:
    file = tmp_path / "robot.xml"
    file.write_text(GEOMS.format(settings=settings))
    model = mujoco.MjModel.from_xml_path(str(file))

    assert max(differences(file, model).values()) < TOLERANCE


def test_real_models_are_computed_like_mujoco_does() -> None:
    """Those that load without their meshes; most do not name any."""
    compared = skipped = 0
    for path in sorted(locate_data("robots", "mjcf").rglob("*.xml")):
        try:
            model = mujoco.MjModel.from_xml_path(str(path))
        except ValueError:
            skipped += 1
            continue
        if model.nbody > 1:
            assert max(differences(path, model).values()) < TOLERANCE, path
            compared += 1
    assert compared > 2 * skipped - 10, (compared, skipped)


PENDULUMS = """
<mujoco>
  <compiler angle="radian"/>
  <worldbody>
    <body><joint name="a" ref="0.2"/><geom size="1"/></body>
    <body pos="3 0 0"><joint name="b" ref="-0.3"/><geom size="1"/></body>
  </worldbody>
  <tendon>
    <fixed name="both"><joint joint="a" coef="2"/><joint joint="b" coef="-3"/></fixed>
    <fixed name="one"><joint joint="a" coef="2"/></fixed>
    <fixed name="other"><joint joint="b" coef="5"/></fixed>
  </tendon>
  <equality>{}</equality>
</mujoco>
"""


@pytest.mark.parametrize(
    "equality",
    [
        '<tendon tendon1="both" polycoef="0.4 1 0 0 0"/>',
        '<tendon tendon1="one" tendon2="other" polycoef="0.4 0.7 0 0 0"/>',
        '<joint joint1="a" joint2="b" polycoef="0.4 0.7 0 0 0"/>',
    ],
)
def test_a_coupling_is_where_the_equality_holds(equality: str, tmp_path: Path) -> None:
    file = tmp_path / "robot.xml"
    file.write_text(PENDULUMS.format(equality))
    model = mujoco.MjModel.from_xml_path(str(file))
    data = mujoco.MjData(model)
    (node,) = (each for each in stated(file).said.values() if "follower" in each)
    multiplier = float(node.get("multiplier", node.get("@polycoef-2", "1")))
    offset = float(node.get("offset", node.get("@polycoef-1", "0")))
    follower, leader = (0, 1) if "/joint/a>" in node["follower"] else (1, 0)
    for position in (-0.5, 0.0, 1.25):
        data.qpos[leader] = model.qpos0[leader] + position
        data.qpos[follower] = model.qpos0[follower] + multiplier * position + offset
        mujoco.mj_forward(model, data)
        assert abs(data.efc_pos[0]) < TOLERANCE
