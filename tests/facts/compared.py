"""Two descriptions of an arm, and what a comparison says of them."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from described import closed

from kinlint.facts.comparison.comparison import Comparison
from kinlint.facts.comparison.described_robot import DescribedRobot
from kinlint.facts.comparison.extraction import RobotExtraction
from kinlint.facts.comparison.tolerances import EXACT, EXPORTED, Tolerances
from kinlint.facts.fact_context import FactContext
from kinlint.facts.predicate_index import PredicateIndex

ARM = """<robot name="arm">
  <link name="base">
    <inertial><origin xyz="0 0 0.05"/><mass value="4"/>
      <inertia ixx="0.02" iyy="0.021" izz="0.03" ixy="0" ixz="0" iyz="0"/></inertial>
    <collision><origin xyz="0 0 0.05"/><geometry><box size="0.2 0.3 0.1"/></geometry></collision>
  </link>
  <link name="stand">
    <inertial><origin xyz="0.01 0 0.1"/><mass value="1.5"/>
      <inertia ixx="0.004" iyy="0.005" izz="0.006" ixy="0.0002" ixz="0" iyz="0"/></inertial>
  </link>
  <link name="upper">
    <inertial><origin xyz="0.02 0 0.15" rpy="0.3 0 0"/><mass value="2.5"/>
      <inertia ixx="0.02" iyy="0.018" izz="0.005" ixy="0" ixz="0.001" iyz="0"/></inertial>
    <collision><origin xyz="0 0 0.15"/>
      <geometry><cylinder radius="0.04" length="0.3"/></geometry></collision>
  </link>
  <link name="fore">
    <inertial><origin xyz="0.1 0.01 0"/><mass value="1.2"/>
      <inertia ixx="0.002" iyy="0.009" izz="0.008" ixy="0" ixz="0" iyz="0.0001"/></inertial>
    <collision><origin xyz="0.1 0 0"/><geometry><sphere radius="0.05"/></geometry></collision>
  </link>
  <link name="hand">
    <inertial><origin xyz="0 0 0.03"/><mass value="0.5"/>
      <inertia ixx="0.0005" iyy="0.0004" izz="0.0003" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <link name="left">
    <inertial><origin xyz="0 0 0.02"/><mass value="0.05"/>
      <inertia ixx="0.00001" iyy="0.00001" izz="0.000005" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <link name="right">
    <inertial><origin xyz="0 0 0.02"/><mass value="0.05"/>
      <inertia ixx="0.00001" iyy="0.00001" izz="0.000005" ixy="0" ixz="0" iyz="0"/></inertial>
  </link>
  <joint name="mount" type="fixed"><parent link="base"/><child link="stand"/>
    <origin xyz="0 0.02 0.1" rpy="0 0 0.5"/></joint>
  <joint name="shoulder" type="revolute"><parent link="stand"/><child link="upper"/>
    <origin xyz="0 0 0.2" rpy="0 0.1 0"/><axis xyz="0 0 1"/>
    <limit lower="-2.9" upper="2.8" effort="80" velocity="2"/></joint>
  <joint name="elbow" type="revolute"><parent link="upper"/><child link="fore"/>
    <origin xyz="0.05 0 0.3" rpy="1.2 0 0.4"/><axis xyz="0 1 0"/>
    <limit lower="-1.5" upper="2.1" effort="60" velocity="2.5"/></joint>
  <joint name="wrist" type="fixed"><parent link="fore"/><child link="hand"/>
    <origin xyz="0.25 0 0" rpy="0 0.7 0"/></joint>
  <joint name="grip_left" type="prismatic"><parent link="hand"/><child link="left"/>
    <origin xyz="0 0.01 0.06"/><axis xyz="0 1 0"/>
    <limit lower="0" upper="0.04" effort="20" velocity="0.1"/></joint>
  <joint name="grip_right" type="prismatic"><parent link="hand"/><child link="right"/>
    <origin xyz="0 -0.01 0.06"/><axis xyz="0 -1 0"/>
    <limit lower="0" upper="0.04" effort="20" velocity="0.1"/></joint>
</robot>"""
"""Arm with fixed links, turned frames, products of inertia, and a gripper of two fingers."""


def described(text: str, name: str) -> DescribedRobot:
    """Return the robot of a file called *name*."""
    store = closed({name: text})
    context = FactContext(PredicateIndex(store))
    form = next(iter(store.documents.values())).format.name
    mechanism = context.mechanism
    made = RobotExtraction(context.robot_parts(context.scan))
    return made.robot(form, mechanism.described, mechanism.joints)


def comparison(one: str, other: str, names: tuple[str, str] = ("a.urdf", "b.urdf")) -> Comparison:
    """Return the comparison of two texts, with the tolerances for their formats."""
    same = names[0].rpartition(".")[2] == names[1].rpartition(".")[2]
    tolerances: Tolerances = EXACT if same else EXPORTED
    return Comparison(described(one, names[0]), described(other, names[1]), tolerances)


def differences(
    one: str, other: str, names: tuple[str, str] = ("a.urdf", "b.urdf")
) -> list[tuple[str, str]]:
    """Return the quantities that differ, each with the name of the part."""
    return [(each.quantity, each.part) for each in comparison(one, other, names).differences]


def mujoco_export(text: str) -> str:
    """Return the MJCF that MuJoCo writes of a URDF."""
    mujoco = pytest.importorskip("mujoco", reason="the wheel of MuJoCo is not installed")
    with TemporaryDirectory() as folder:
        path = Path(folder) / "exported.xml"
        mujoco.mj_saveLastXML(str(path), mujoco.MjModel.from_xml_string(text))
        return path.read_text()
