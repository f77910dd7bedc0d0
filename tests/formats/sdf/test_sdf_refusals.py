"""Errors about what stands where in SDF are what libsdformat refuses, and the rest is none.

Where Drake is installed, which has libsdformat inside, the verdicts are held to it.
"""

from __future__ import annotations

import pytest
from support.linting import findings

from kinlint.rule import Severity

MODEL = '<sdf version="1.9"><model name="arm">{}</model></sdf>'
LINK = MODEL.format('<link name="base">{}</link>')
SHAPE = LINK.format('<collision name="shell"><geometry>{}</geometry></collision>')
PAIR = MODEL.format('<link name="base"/><link name="hand"/>{}')
WORLD = '<sdf version="1.9"><world name="lab">{}</world></sdf>'
LIGHT = '<light name="lamp" type="spot"><spot>{}</spot></light>'

ACCEPTED = (
    SHAPE.format("<sphere/>"),
    SHAPE.format("<sphere>2</sphere>"),
    SHAPE.format("<box>1 1 1</box>"),
    SHAPE.format("<mesh/>"),
    SHAPE.format("<polyline/>"),
    SHAPE.format("<sphere><radius>1</radius><radius>2</radius></sphere>"),
    LINK.format('<visual name="shell"/>'),
    LINK.format("<inertial><mass>1</mass><mass>2</mass></inertial>"),
    LINK.format("<pose>0 0 0 0 0 0</pose><pose>0 0 1 0 0 0</pose>"),
    LINK.format(LIGHT.format("<inner_angle>1</inner_angle>")),
    LINK.format(
        '<sensor name="touch" type="contact"><contact>'
        "<collision>a</collision><collision>b</collision></contact></sensor>"
    ),
    LINK.format(
        '<visual name="shell"><geometry><empty/></geometry>'
        "<material><shininess>1</shininess></material></visual>"
    ),
    LINK.format('<collision name="shell"><geometry/><max_contacts>10.0</max_contacts></collision>'),
    MODEL.format('<link name="base"/><gripper name="claw"/>'),
    MODEL.format('<link name="base"/><plugin filename="claw"/>'),
    WORLD.format('<physics type="ode"/>'),
    WORLD.format('<actor name="man"><skin/></actor>'),
    WORLD.format("<scene><fog/></scene>"),
)
REFUSED = (
    SHAPE.format("<mesh><uri/></mesh>"),
    SHAPE.format("<mesh><uri>a.dae</uri><submesh/></mesh>"),
    LINK.format("<visual/>"),
    LINK.format('<visual name=""/>'),
    LINK.format('<sensor name="touch"/>'),
    LINK.format("<pose>nan 0 0 0 0 0</pose>"),
    LINK.format("<pose>0 0 0</pose>"),
    LINK.format("<inertial><mass>x</mass></inertial>"),
    LINK.format('<light name="lamp"><spot/></light>'),
    SHAPE.format("<box><size>nan 1 1</size></box>"),
    LINK.format("<battery/>"),
    PAIR.format('<joint name="elbow" type="fixed"><parent>base</parent></joint>'),
    PAIR.format('<joint name="elbow" type="fixed"><child>hand</child></joint>'),
    PAIR.format('<joint name="elbow"><parent>base</parent><child>hand</child></joint>'),
    MODEL.format('<link name="base"/><include/>'),
    MODEL.format('<link name="base"/><plugin name="claw"/>'),
    MODEL.format('<link name="base"/><link/>'),
    WORLD.format("<physics/>"),
)


def errors(text: str) -> list[str]:
    """The codes of the errors that are found in a file of *text*."""
    return [
        each.rule.code
        for each in findings({"arm.sdf": text.encode()})
        if each.severity is Severity.ERROR and each.rule.code.startswith(("SRC", "FRM"))
    ]


@pytest.mark.parametrize("text", ACCEPTED)
def test_what_is_accepted_is_no_error(text: str) -> None:
    assert errors(text) == []


@pytest.mark.parametrize("text", REFUSED)
def test_what_is_refused_is_an_error(text: str) -> None:
    assert errors(text)


@pytest.mark.external
@pytest.mark.parametrize(
    ("text", "accepted"),
    [*((each, True) for each in ACCEPTED), *((each, False) for each in REFUSED)],
)
def test_the_verdicts_are_those_of_libsdformat(text: str, *, accepted: bool) -> None:
    plant = pytest.importorskip("pydrake.multibody.plant")
    parsing = pytest.importorskip("pydrake.multibody.parsing")
    arm = plant.MultibodyPlant(time_step=0.0)  # a parser has no hold on it
    parser = parsing.Parser(arm)
    if accepted:
        parser.AddModelsFromString(text, "sdf")
        return
    with pytest.raises(RuntimeError):
        parser.AddModelsFromString(text, "sdf")
