"""Editors find prims by the steps of paths."""

from __future__ import annotations

import pytest
from completing import Typing
from support.linting import book, source

from kinlint.configuration.settings import Settings
from kinlint.navigation.navigator import Navigator
from kinlint.navigation.usd_meaning import meaning
from kinlint.pipeline.analyzer import Analyzer

TEXT = """#usda 1.0
def Xform "arm"
{
    def Xform "base" (
        prepend apiSchemas = ["PhysicsRigidBodyAPI"]
    )
    {
        def Cube "block"
        {
        }
    }
    def PhysicsFixedJoint "mount"
    {
        rel physics:body1 = </arm/base/block>
    }
}
"""


@pytest.fixture
def navigator() -> Navigator:
    """The navigator of the layer."""
    sources = [source(TEXT, "arm.usda")]
    return Navigator(Analyzer(Settings(), book(), repeated=True).examine(sources), book(), {})


@pytest.mark.parametrize("name", ["arm", "base", "block"])
def test_each_step_of_a_path_leads_to_its_prim(name: str, navigator: Navigator) -> None:
    path = TEXT.index("</arm/base/block>")
    offset = TEXT.index(name, path) + 1
    (found,) = navigator.definitions("arm.usda", offset)

    assert TEXT[found.span.start - 1 : found.span.end + 1] == f'"{name}"'
    assert found.span.start == TEXT.index(f'"{name}"') + 1


def test_a_prim_is_named_where_paths_lead_through_it(navigator: Navigator) -> None:
    places = navigator.references("arm.usda", TEXT.index('"base"') + 2, described=False)

    assert [TEXT[each.span.start : each.span.end] for each in places] == ["base"]


@pytest.mark.parametrize(
    ("place", "told"),
    [
        (
            "stiffness",
            "`drive:angular:physics:stiffness` float of PhysicsDriveAPI, unit: torque per degree",
        ),
        ("lowerLimit", "`physics:lowerLimit` float of PhysicsRevoluteJoint, unit: degree"),
        ("axis", "`physics:axis` token of PhysicsRevoluteJoint, uniform: `X`, `Y`, `Z`"),
        ("PhysicsDriveAPI", "`PhysicsDriveAPI` schema of "),
    ],
)
def test_a_hover_says_what_schemas_say(place: str, told: str) -> None:
    text = """#usda 1.0
def PhysicsRevoluteJoint "elbow" (
    prepend apiSchemas = ["PhysicsDriveAPI:angular"]
)
{
    uniform token physics:axis = "Z"
    float physics:lowerLimit = -90
    float drive:angular:physics:stiffness = 10
}
"""
    assert meaning(text, text.index(place) + 1).startswith(told)


JOINT = """#usda 1.0
def Xform "arm"
{
    def Xform "base" (
        prepend apiSchemas = ["PhysicsRigidBodyAPI"]
    )
    {
        def Cube "block"
        {
        }
    }
    def PhysicsRevoluteJoint "hip"
    {
        rel physics:body0 = </arm>
        rel newton:mimicJoint = [</arm/hip>]
        asset file = @</arm/base>@
    }
}
"""


def test_paths_in_relationships_are_completed(tmp_path) -> None:
    """Bodies and joints come first where only they are meant; a bracket that lacks is added."""
    typing = Typing(tmp_path, {"arm.usda": JOINT})
    every = {"/arm", "/arm/base", "/arm/base/block", "/arm/hip"}
    bodies = typing.labels("arm.usda: body0 = </arm> => body0 = </a|rm>")
    assert (bodies[0], set(bodies)) == ("/arm/base", every)
    joints = typing.labels("arm.usda: [</arm/hip>] => [</arm/hip>, <|]")
    assert (joints[0], set(joints)) == ("/arm/hip", every)
    assert typing.candidates("arm.usda: body0 = </arm> => body0 = </ar|")[0].text == "/arm/base>"
    assert typing.candidates("arm.usda: body0 = </arm> => body0 = </a|>")[0].text == "/arm/base"
    assert typing.labels("arm.usda: @</arm/base>@ => @</arm|>@") == []


SCHEMAS = """#usda 1.0
def Xform "arm"
{
    def Xform "base" (
        prepend apiSchemas = ["PhysicsRigidBodyAPI", "PhysicsMassAPI"]
    )
    {
        float physics:mass = 2
    }
    def PhysicsRevoluteJoint "hip" (
        apiSchemas = ["PhysicsDriveAPI:angular"]
    )
    {
        uniform token physics:axis = "X"
        float drive:angular:physics:damping = 1
    }
}
"""


@pytest.mark.slow
def test_what_schemas_have_is_completed(tmp_path) -> None:
    typing = Typing(tmp_path, {"arm.usda": SCHEMAS})

    assert typing.labels('arm.usda: physics:axis = "X" => physics:axis = "|"') == ["X", "Y", "Z"]
    schemas = typing.labels('arm.usda: "PhysicsMassAPI" => "Phys|"')
    assert "PhysicsMassAPI" in schemas
    assert not {"PhysicsRigidBodyAPI", "PhysicsDriveAPI:angular"} & {*schemas}
    assert "PhysicsDriveAPI:linear" in typing.labels("arm.usda: API:angular => API:|")
    assert "PhysicsFixedJoint" in typing.labels("arm.usda: def PhysicsRev => def Physics|Rev")
    floats = typing.labels("arm.usda: float physics:mass => float physics:|")
    assert "physics:mass" in floats
    assert "physics:centerOfMass" not in floats
    (damping,) = (
        each
        for each in typing.candidates("arm.usda: float drive:angular:physics:damping => dr|")
        if each.label == "drive:angular:physics:damping"
    )
    assert damping.text == "float drive:angular:physics:damping"
    assert typing.labels('arm.usda: "hip" => "hip|"') == []
