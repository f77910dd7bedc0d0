"""No URDF that a consumer refuses is without an error for that target; meshes aside."""

from __future__ import annotations

from pathlib import Path

import pytest
from data import locate_data
from refusals import LOADERS, is_installed, refuses, without_meshes
from support.linting import lint

from kinlint.configuration.settings import FileSettings
from kinlint.formats.registry import decode
from kinlint.rule import Severity

pytestmark = [pytest.mark.external, pytest.mark.xdist_group("refusals")]

ROBOT = """<robot name="arm">
  <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
  <link name="base">
    <inertial>
      <mass value="2"/>
      <inertia ixx="0.02" ixy="0" ixz="0" iyy="0.02" iyz="0" izz="0.02"/>
    </inertial>
    <visual>
      <origin xyz="0 0 0.05"/><geometry><cylinder radius="0.1" length="0.1"/></geometry>
      <material name="grey"/>
    </visual>
    <collision><geometry><cylinder radius="0.1" length="0.1"/></geometry></collision>
  </link>
  <link name="forearm">
    <inertial>
      <mass value="1.5"/>
      <inertia ixx="0.006" ixy="0" ixz="0" iyy="0.006" iyz="0" izz="0.002"/>
    </inertial>
    <collision><geometry><box size="0.1 0.1 0.2"/></geometry></collision>
  </link>
  <link name="hand">
    <inertial>
      <mass value="0.5"/>
      <inertia ixx="0.0005" ixy="0" ixz="0" iyy="0.0005" iyz="0" izz="0.0005"/>
    </inertial>
  </link>
  <link name="camera"/>
  <joint name="elbow" type="revolute">
    <parent link="base"/><child link="forearm"/><axis xyz="0 1 0"/>
    <limit lower="-1.5" upper="1.5" effort="20" velocity="2"/>
    <dynamics damping="0.1" friction="0.2"/>
  </joint>
  <joint name="wrist" type="continuous">
    <parent link="forearm"/><child link="hand"/><axis xyz="0 0 1"/>
    <limit effort="5" velocity="4"/>
  </joint>
  <joint name="mount" type="fixed"><parent link="hand"/><child link="camera"/></joint>
  <transmission name="drive">
    <type>transmission_interface/SimpleTransmission</type>
    <joint name="elbow"/>
    <actuator name="motor"/>
  </transmission>
</robot>
"""
TENSOR = 'ixx="0.006" ixy="0" ixz="0" iyy="0.006" iyz="0" izz="0.002"'
WELDED = '<link name="camera"><inertial><mass value="1"/><inertia {}/></inertial></link>'
CAMERA = '<link name="camera"/>'


def tensor(xx: str, yy: str, zz: str) -> str:
    """Return the attributes of a tensor without products."""
    return f'ixx="{xx}" ixy="0" ixz="0" iyy="{yy}" iyz="0" izz="{zz}"'


CHANGES = {
    "nothing": ("arm", "arm"),
    "a triangle off by a hundredth": (TENSOR, tensor("0.006", "0.006", "0.01212")),
    "a triangle off by a millionth": (TENSOR, tensor("0.006", "0.006", "0.012000012")),
    "a triangle off by rounding": (TENSOR, tensor("0.1", "0.7", "0.8")),
    "a plate": (TENSOR, tensor("0.006", "0.006", "0.012")),
    "a rod": (TENSOR, tensor("0.006", "0.006", "0")),
    "moments of 1e-15": (TENSOR, tensor("1e-15", "1e-15", "1e-15")),
    "moments of 1e-14": (TENSOR, tensor("1e-14", "1e-14", "1e-14")),
    "a welded rod": (CAMERA, WELDED.format(tensor("0", "1", "1"))),
    "a welded needle": (CAMERA, WELDED.format(tensor("0", "0", "1"))),
    "a welded mote": (CAMERA, WELDED.format(tensor("3e-22", "3e-22", "3e-22"))),
    "a welded point": (CAMERA, WELDED.format(tensor("0", "0", "0"))),
    "a mass of 1e-16": ('value="1.5"', 'value="1e-16"'),
    "a mass of zero": ('value="1.5"', 'value="0"'),
    "a flat box": ("0.1 0.1 0.2", "0.1 0 0.2"),
    "a box turned inside out": ("0.1 0.1 0.2", "0.1 -0.1 0.2"),
    "no shape": ('<box size="0.1 0.1 0.2"/>', ""),
    "a plane": ('<box size="0.1 0.1 0.2"/>', '<plane normal="0 0 1"/>'),
    "an axis without xyz": ('<axis xyz="0 1 0"/>', "<axis/>"),
    "an axis of a fixed joint without xyz": (
        '<child link="camera"/>',
        '<child link="camera"/><axis/>',
    ),
    "negative damping": ('damping="0.1"', 'damping="-0.1"'),
    "negative friction": ('friction="0.2"', 'friction="-0.2"'),
    "negative effort": ('effort="20"', 'effort="-1"'),
    "an effort that is not a number": ('effort="20"', 'effort="nan"'),
    "an infinite limit": ('upper="1.5"', 'upper="inf"'),
    "an inverted limit": ('lower="-1.5"', 'lower="2.5"'),
    "an inverted limit of a continuous joint": (
        '<limit effort="5"',
        '<limit lower="1" upper="-1" effort="5"',
    ),
    "a floating joint in the middle": (
        'name="wrist" type="continuous"',
        'name="wrist" type="floating"',
    ),
    "a planar joint with damping": ('type="revolute"', 'type="planar"'),
    "a mimic on a fixed joint": (
        '<child link="camera"/>',
        '<child link="camera"/><mimic joint="elbow"/>',
    ),
    "a transmission of a missing joint": ('<joint name="elbow"/>', '<joint name="elbo"/>'),
    "a transmission without an actuator": ('<actuator name="motor"/>', ""),
    "a transmission without a type": ("<type>transmission_interface/SimpleTransmission</type>", ""),
    "a material nowhere defined": ('<material name="grey"/>', '<material name="gray"/>'),
    "a colour above one": ("0.5 0.5 0.5 1", "255 0 0 1"),
    "a colour of three numbers": ("0.5 0.5 0.5 1", "0.5 0.5 0.5"),
    "a texture that is not there": (
        '<color rgba="0.5 0.5 0.5 1"/>',
        '<texture filename="oak.png"/>',
    ),
    "a robot without a name": ('<robot name="arm">', '<robot name="">'),
    "a visual with an empty name": ("<visual>", '<visual name="">'),
    "a malformed place of a visual": ('xyz="0 0 0.05"', 'xyz="0 0 0,05"'),
    "a space of Unicode": ('xyz="0 0 0.05"', 'xyz="0\u00a00 0.05"'),
    "a moving link without anything": (
        '<collision><geometry><box size="0.1 0.1 0.2"/></geometry></collision>\n  </link>',
        (
            '</link><link name="bare"/><joint name="j" type="continuous">'
            '<parent link="base"/><child link="bare"/></joint>'
        ),
    ),
}
"""Words of the robot and what stands in their place."""

SDF = """<sdf version="1.9">
  <model name="arm">
    <link name="base">
      <inertial><mass>2</mass>
        <inertia><ixx>0.02</ixx><iyy>0.021</iyy><izz>0.022</izz></inertia></inertial>
      <collision name="plate">
        <geometry><cylinder><radius>0.1</radius><length>0.12</length></cylinder></geometry>
        <surface><friction><ode><mu>0.8</mu><mu2>0.7</mu2></ode></friction></surface>
      </collision>
    </link>
    <link name="forearm">
      <pose>0 0.01 0.3 0.1 0 0</pose>
      <inertial><mass>1.5</mass>
        <inertia><ixx>0.006</ixx><iyy>0.0061</iyy><izz>0.002</izz></inertia></inertial>
    </link>
    <joint name="elbow" type="revolute">
      <parent>base</parent><child>forearm</child>
      <axis><xyz>0 1 0</xyz>
        <limit><lower>-1.5</lower><upper>1.6</upper></limit>
        <dynamics><damping>0.1</damping></dynamics></axis>
    </joint>
    <frame name="tip" attached_to="forearm"/>
  </model>
</sdf>
"""
AXIS = SDF[SDF.index("<axis>") : SDF.index("</axis>") + len("</axis>")]
PLANE = "<plane><normal>0 0 0</normal><size>1 1</size></plane>"
SDF_CHANGES = {
    "nothing": ("arm", "arm"),
    "an unknown element": ("<frame ", "<alwaysOn>1</alwaysOn><frame "),
    "an unknown attribute": ("<frame ", '<frame kind="tool" '),
    "an element of another": ("<frame ", "<damping>1</damping><frame "),
    "an included model that is not there": (
        "<frame ",
        "<include><uri>model://hand</uri></include><frame ",
    ),
    "a link called like a joint": ('"tip" attached', '"elbow" attached'),
    "a link called like a joint in 1.6": (
        SDF[SDF.index('"1.9"') :],
        SDF[SDF.index('"1.9"') :].replace("1.9", "1.6").replace("elbow", "forearm"),
    ),
    "a dynamic friction above the static one": ("<mu2>0.7", "<mu2>0.9"),
    "a static friction alone": ("<mu2>0.7</mu2>", ""),
    "a negative friction": ("<mu>0.8", "<mu>-0.8"),
    "a negative damping": ("<damping>0.1", "<damping>-0.1"),
    "a negative spring": (
        "</dynamics>",
        "<spring_stiffness>-1</spring_stiffness></dynamics>",
    ),
    "no axis": (AXIS, ""),
    "an infinite lower limit": ("<lower>-1.5", "<lower>inf"),
    "a negative infinite upper limit": ("<upper>1.6", "<upper>-inf"),
    "a pose that is not a number": ("0 0.01 0.3", "0 nan 0.3"),
    "a quaternion of zeros": (
        "<pose>0 0.01 0.3 0.1 0 0",
        '<pose rotation_format="quat_xyzw">0 0 0 0 0 0 0',
    ),
    "a plane without a normal": (
        "<cylinder><radius>0.1</radius><length>0.12</length></cylinder>",
        PLANE,
    ),
    "a link without a name": ('<link name="base">', '<link name="">'),
    "a joint of one link": ("<child>forearm", "<child>base"),
    "no model": (SDF[SDF.index("<model") : SDF.index("</sdf>")], ""),
    "a model beside a world": ("</model>", '</model><world name="hall"/>'),
}
"""Words of the model and what stands in their place."""


def has_error(path: Path, consumer: str) -> bool:
    """Tell whether kinlint finds an error in the file at *path*, meant for *consumer*."""
    source = decode(str(path), path.read_bytes())
    report = lint([source], default=FileSettings(targets=(consumer,)))
    return any(each.severity is Severity.ERROR for each in report.findings) or bool(report.errors)


@pytest.fixture(params=LOADERS)
def consumer(request: pytest.FixtureRequest) -> str:
    name: str = request.param
    if not is_installed(name):
        pytest.skip(f"{name} is not installed")
    return name


@pytest.mark.parametrize("change", CHANGES)
def test_what_a_consumer_refuses_is_an_error_for_it(
    change: str, consumer: str, tmp_path: Path
) -> None:
    """One change of a sound robot at a time."""
    path = tmp_path / "arm.urdf"
    path.write_text(ROBOT.replace(*CHANGES[change], 1), "utf-8")

    assert has_error(path, consumer) or not refuses(consumer, path)


@pytest.mark.parametrize("change", SDF_CHANGES)
def test_what_drake_refuses_of_sdf_is_an_error_for_it(change: str, tmp_path: Path) -> None:
    """One change of a sound model at a time."""
    if not is_installed("drake"):
        pytest.skip("drake is not installed")
    path = tmp_path / "arm.sdf"
    path.write_text(SDF.replace(*SDF_CHANGES[change], 1), "utf-8")

    assert has_error(path, "drake") == refuses("drake", path)


@pytest.mark.parametrize("change", ["nothing", "a plate", "moments of 1e-14"])
def test_what_a_consumer_takes_is_no_error_for_it(
    change: str, consumer: str, tmp_path: Path
) -> None:
    """Neither a sound robot nor the limits of what can be."""
    path = tmp_path / "arm.urdf"
    path.write_text(ROBOT.replace(*CHANGES[change], 1), "utf-8")

    assert not refuses(consumer, path)
    assert not has_error(path, consumer)


@pytest.mark.slow
@pytest.mark.corpus
def test_public_robots_that_a_consumer_refuses_have_an_error(consumer: str, tmp_path: Path) -> None:
    """Each on its own, with boxes for meshes."""
    stub = tmp_path / "robot.urdf"
    silent = []
    for path in sorted(locate_data("robots").joinpath("urdf").rglob("*.urdf")):
        stub.write_bytes(without_meshes(path.read_bytes()))
        if refuses(consumer, stub) and not has_error(path, consumer):
            silent.append(path.name)

    assert not silent


@pytest.mark.slow
@pytest.mark.corpus
def test_public_sdf_that_drake_refuses_has_an_error(tmp_path: Path) -> None:
    """An element that libsdformat drops when it converts a version, and state of a world, are not.

    Those cannot be told by the description of the version that the file declares.
    """
    if not is_installed("drake"):
        pytest.skip("drake is not installed")
    stub = tmp_path / "robot.sdf"
    silent = []
    for path in sorted(locate_data("robots").joinpath("sdf").rglob("*.sdf")):
        stub.write_bytes(without_meshes(path.read_bytes()))
        if refuses("drake", stub) and not has_error(path, "drake"):
            silent.append(path.name)

    assert set(silent) <= {"joint_complete.sdf", "world_complete.sdf"}
