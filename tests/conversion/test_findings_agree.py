"""Linting what was converted finds what linting the robot found, where a rule is about robots."""

from __future__ import annotations

import json
import re
from pathlib import Path

import pytest
from support.linting import book, codes

from kinlint.conversion.composition import compose
from kinlint.conversion.output import jsonld
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.rule import Rule
from kinlint.text import SourceText

BOOK = book()
TREES = ("urdf", "sdf")
APART = {
    "INE003": "joints of the metamodels do not say which of two bodies carries the other",
    "LNT001": "comments are not converted",
    "LNT002": "comments are not converted",
    "LNT003": "comments are not converted",
    "LNT004": "comments are not converted",
    "UNI009": "an actuator of the metamodels may have a gear, that of a file in XML has none",
    "UNI025": "an actuator of the metamodels may have a gear, that of a file in XML has none",
    "TOP009": "the frames of SDF are resolved when a file is read",
}
"""Why some rules find other things in a composable model."""

ELEMENTS = re.compile(r"(?<![\w-])(?:urdf|srdf|sdf|ext|at):\w")


def about_robots(rule: Rule) -> bool:
    """Whether *rule* speaks of no element of a format, and has no other reason to differ."""
    text = Path(rule.path).read_text(encoding="utf-8").partition("kl:example")[0]
    return not ELEMENTS.search(text) and rule.code not in APART


UNRESOLVED = "CMP016"
"""What is found where a file includes another that is not there: its content is not converted."""

EXAMPLES = [
    pytest.param(rule, example, id=f"{rule.code}-{number}")
    for rule in BOOK.rules
    if {"jsonld", *TREES} & {*rule.formats} > {"jsonld"} and about_robots(rule)
    for number, example in enumerate(rule.examples)
    if example.format in TREES
]


@pytest.mark.slow
@pytest.mark.parametrize(("rule", "example"), EXAMPLES)
def test_examples_of_rules_about_robots(rule, example):
    for text in filter(None, (example.bad, example.good)):
        robot = SourceText(
            f"robot.{example.format}", text.replace("[|", "").replace("|]", "").strip()
        )
        found = codes([robot])
        composed = converted(robot)
        assert (rule.code in found) == (rule.code in codes([composed])) or UNRESOLVED in found


def converted(robot: SourceText) -> SourceText:
    """The model of *robot*, its rotations written as there: some rules look at that."""
    rotation = "quaternion" if "quat" in robot.text else "euler-angles"
    model = compose([read(robot, ReadOptions())], rotation=rotation)
    return SourceText("robot.jsonld", jsonld(model))


BROKEN = """
<robot name="broken">
  <link name="base"/>
  <link name="arm">
    <inertial>
      <origin xyz="0 0 0.1" rpy="0 0 90"/>
      <mass value="1500"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.1"/>
    </inertial>
  </link>
  <link name="hand">
    <inertial>
      <mass value="-0.5"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="-0.1"/>
    </inertial>
    <collision>
      <geometry>
        <box size="0.1 0 0.2"/>
      </geometry>
    </collision>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="base"/>
    <child link="arm"/>
    <axis xyz="0 0 1"/>
    <limit lower="2" upper="-2" effort="-1" velocity="1"/>
  </joint>
  <joint name="wrist" type="prismatic">
    <parent link="arm"/>
    <child link="hand"/>
    <axis xyz="1 0 0"/>
    <limit upper="0.3" effort="5" velocity="1"/>
    <mimic joint="wrist"/>
  </joint>
</robot>
"""


@pytest.mark.slow
@pytest.mark.parametrize(
    "code",
    [
        "CMP007",
        "GEO004",
        "INE001",
        "INE002",
        "INE003",
        "LIM001",
        "LIM002",
        "LIM007",
        "UNI003",
        "UNI009",
    ],
)
def test_one_robot_with_many_faults(code):
    robot = SourceText("broken.urdf", BROKEN.strip())
    assert code in codes([robot])
    assert code in codes([converted(robot)])


FREE = """<sdf version="1.9"><model name="desk">
<link name="base"/><link name="drawer"/><link name="lamp">{pose}</link>
<joint name="slide" type="prismatic"><parent>base</parent><child>drawer</child>
<axis><xyz>1 0 0</xyz><limit><lower>0</lower><upper>0.4</upper></limit></axis></joint>
<frame name="edge" attached_to="base"/></model></sdf>"""


@pytest.mark.parametrize(
    "pose", ["", "<pose>1 2 3 0 0 0.5</pose>", '<pose relative_to="edge">1 0 0 0 0 0</pose>']
)
def test_a_body_without_joint_is_somewhere(pose: str) -> None:
    source = SourceText("desk.sdf", FREE.format(pose=pose))
    text = jsonld(compose([read(source, ReadOptions())]))

    assert "link/lamp/pose" in text
    assert "TOP018" not in codes(text, "desk.jsonld")


NESTED = """<sdf version="1.8">
  <model name="cell">
    <link name="floor"/>
    <link name="base"/>
    <link name="arm"/>
    <joint name="hinge" type="revolute">
      <parent>base</parent><child>arm</child><axis><xyz>0 0 1</xyz></axis>
    </joint>
    <model name="table">
      <pose relative_to="arm">1 0 0 0 0 0</pose>
      <model name="top"><link name="plate"/></model>
    </model>
    <model name="lamp">
      <pose relative_to="hinge">0 0 2 0 0 0</pose>
      <link name="bulb"/>
    </model>
  </model>
</sdf>"""


@pytest.mark.slow
def test_every_body_of_nested_models_is_somewhere():
    """The canonical link is free; others are seen from it, from a link and from a joint."""
    composed = converted(SourceText("cell.sdf", NESTED))
    assert "TOP018" not in codes([composed])


WORLD = """<sdf version="1.9">
  <world name="yard">
    <model name="arm">
      <pose degrees="true">1 2 0 0 0 90</pose>
      <link name="base"/>
      <link name="hand"><pose>0 0 1 0 0 0</pose></link>
      <joint name="lift" type="revolute">
        <parent>base</parent><child>hand</child><axis><xyz>0 0 1</xyz></axis>
      </joint>
    </model>
    <model name="crate"><link name="box"><pose>0 0 0.5 0 0 0</pose></link></model>
  </world>
</sdf>"""


def test_the_models_of_a_world_are_somewhere():
    """A pose in the world, with the numbers of the model; without any it is at the origin."""
    composed = converted(SourceText("yard.sdf", WORLD))
    nodes = {each["@id"]: each for each in json.loads(composed.text)["@graph"]}

    assert "TOP018" not in codes([composed])
    arm, crate = (f"robot:world/yard/model/{name}/placement" for name in ("arm", "crate"))
    assert nodes[arm]["with-respect-to"] == nodes[crate]["with-respect-to"]
    assert nodes[arm]["with-respect-to"] == "robot:world/yard/frame"
    assert [nodes[f"{arm}/coordinates"][axis] for axis in "xyz"] == [1, 2, 0]
    assert [nodes[f"{crate}/coordinates"][axis] for axis in "xyz"] == [0, 0, 0]


def test_the_only_model_of_a_world_needs_no_place():
    """How a robot stands in the world is no part of it."""
    alone = WORLD.replace(
        '<model name="crate"><link name="box"><pose>0 0 0.5 0 0 0</pose></link></model>', ""
    )

    assert "placement" not in converted(SourceText("yard.sdf", alone)).text
