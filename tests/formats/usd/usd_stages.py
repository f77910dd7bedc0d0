"""Stages for tests: robots in one layer, and scenes of several layers that compose each other."""

from __future__ import annotations

import random
from pathlib import Path

UNITS = '#usda 1.0\n(\n    metersPerUnit = {}\n    kilogramsPerUnit = {}\n    upAxis = "Z"\n{}\n)\n'


def layer(content: str, *, metres: float = 1, kilograms: float = 1, more: str = "") -> str:
    """Return the text of a layer with *content*, and with *more* in its metadata."""
    return f"{UNITS.format(metres, kilograms, more)}{content}\n"


def body(name: str, more: str = "", *, at: str = "(0, 0, 0)", schemas: str = "") -> str:
    """Return a body at a place, with *more* in it."""
    listed = ", ".join(
        f'"{each}"' for each in ("PhysicsRigidBodyAPI", "PhysicsMassAPI", *schemas.split())
    )
    return f"""
def Xform "{name}" (
    prepend apiSchemas = [{listed}]
)
{{
    double3 xformOp:translate = {at}
    uniform token[] xformOpOrder = ["xformOp:translate"]
    {more}
}}"""


ARM = f"""
def Xform "arm" (
    prepend apiSchemas = ["PhysicsArticulationRootAPI"]
)
{{
    double3 xformOp:translate = (1, 2, 3)
    float3 xformOp:rotateXYZ = (10, 20, 30)
    uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:rotateXYZ"]
    {
    body(
        "base",
        '''
    point3f physics:centerOfMass = (0.01, 0.02, 0.1)
    float3 physics:diagonalInertia = (0.02, 0.03, 0.04)
    quatf physics:principalAxes = (0.8, 0, 0.6, 0)
    float physics:mass = 3''',
    )
}
    {
    body(
        "upper",
        '''
    float physics:mass = 2
    def Capsule "tube" (
        prepend apiSchemas = ["PhysicsCollisionAPI"]
    )
    {
        token axis = "X"
        double radius = 0.1
        double height = 0.5
        double3 xformOp:translate = (0.3, 0, 0.1)
        float3 xformOp:scale = (2, 1, 1)
        uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:scale"]
    }
    def Cube "seat"
    {
        double size = 0.2
        quatd xformOp:orient = (0.6, 0, 0.8, 0)
        double3 xformOp:translate = (0.1, 0.2, 0.3)
        uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:orient"]
    }''',
        at="(0, 0, 0.4)",
    )
}
    {
    body(
        "rod",
        '''
    float physics:density = 700
    point3f physics:centerOfMass = (0, 0, 0.3)
    def Sphere "tip" (
        prepend apiSchemas = ["PhysicsCollisionAPI", "PhysicsMassAPI"]
    )
    {
        double radius = 0.1
        float physics:mass = 0.7
        float3 physics:diagonalInertia = (0.01, 0.02, 0.03)
        quatf physics:principalAxes = (0.6, 0.8, 0, 0)
        point3f physics:centerOfMass = (0.01, 0, 0)
        double3 xformOp:translate = (0, 0, 0.5)
        uniform token[] xformOpOrder = ["xformOp:translate"]
    }
    def Cylinder "shaft" (
        prepend apiSchemas = ["PhysicsCollisionAPI"]
    )
    {
        uniform token axis = "Y"
        double radius = 0.05
        double height = 0.4
    }''',
        at="(0, 0.5, 0.4)",
    )
}
    def Scope "joints"
    {{
        def PhysicsFixedJoint "mount"
        {{
            rel physics:body1 = </arm/base>
            point3f physics:localPos0 = (1, 2, 3)
        }}
        def PhysicsRevoluteJoint "shoulder" (
            prepend apiSchemas = ["PhysicsDriveAPI:angular"]
        )
        {{
            uniform token physics:axis = "Y"
            rel physics:body0 = <../../upper/seat>
            rel physics:body1 = </arm/base>
            point3f physics:localPos0 = (0.1, 0.2, 0.3)
            quatf physics:localRot0 = (0.6, 0, 0, 0.8)
            point3f physics:localPos1 = (0, 0, 0.4)
            float physics:lowerLimit = -90
            float physics:upperLimit = 120
            float drive:angular:physics:maxForce = 40
            float physxJoint:maxJointVelocity = 180
        }}
        def PhysicsPrismaticJoint "slide" (
            prepend apiSchemas = ["PhysicsDriveAPI:linear", "NewtonMimicAPI"]
        )
        {{
            uniform token physics:axis = "Z"
            rel physics:body0 = </arm/upper>
            rel physics:body1 = </arm/rod>
            point3f physics:localPos0 = (0, 0.5, 0)
            float physics:lowerLimit = 0
            float physics:upperLimit = 0.25
            float drive:linear:physics:maxForce = 80
            rel newton:mimicJoint = </arm/joints/shoulder>
            float newton:mimicCoef1 = 2
            float newton:mimicCoef0 = 0.5
        }}
    }}
}}
"""
"""An arm with a joint that names its child first, and masses by all ways."""

SCENE = """
over "World"
{
    over "left" (
        variants = {
            string grip = "wide"
        }
    )
    {
        over "hand"
        {
            float physics:mass = 9
        }
    }
    def "right" (
        references = @parts/robot.usda@</kit/robot>
    )
    {
        float extra = 1
    }
    def "copy" (
        references = </World/left/hand>
    )
    {
    }
    def "bare" (
        inherits = </_class>
    )
    {
    }
    def "loaded" (
        payload = @parts/load.usda@
    )
    {
    }
}
class "_class"
{
    custom float c = 1
    rel to = <inner>
    def Xform "inner"
    {
    }
}
over "_shared"
{
    float shared = 5
}
"""
ROBOT = """
class "_shared"
{
    float shared = 2
    float kept = 3
}
def Xform "robot" (
    inherits = </_shared>
    prepend variantSets = "grip"
    variants = {
        string grip = "narrow"
    }
)
{
    double size = 1
    rel out = </elsewhere>
    def Xform "hand" (
        prepend apiSchemas = ["PhysicsRigidBodyAPI", "PhysicsMassAPI"]
    )
    {
        float physics:mass = 1
        rel to = [<../finger>, </robot>]
    }
    variantSet "grip" = {
        "narrow" {
            float width = 1
            def Xform "finger"
            {
            }
        }
        "wide" (
            references = @load.usda@
        ) {
            float width = 2
            def Cube "finger"
            {
            }
        }
    }
}
def Xform "kit"
{
    def "robot" (
        inherits = </robot>
        specializes = </special>
    )
    {
        double size = 7
    }
}
def Xform "special"
{
    double size = 8
    float special = 1
}
"""
LOAD = """
def Xform "crate"
{
    double size = 11
    float weight = 2
    rel self = </crate/lid>
    def Cube "lid"
    {
    }
}
"""
OVER = """
over "World"
{
    over "left"
    {
        float from = 1
        double size = 3
    }
}
"""
BASE = """
def Xform "World"
{
    def "left" (
        prepend references = @parts/robot.usda@
    )
    {
        float from = 2
        double size = 4
    }
}
"""
LAYERS = {
    "scene.usda": layer(
        SCENE, more='    subLayers = [@over.usda@, @base.usda@]\n    defaultPrim = "World"'
    ),
    "over.usda": layer(OVER),
    "base.usda": layer(BASE),
    "parts/robot.usda": layer(ROBOT, more='    defaultPrim = "robot"'),
    "parts/load.usda": layer(LOAD, more='    defaultPrim = "crate"'),
}
"""A scene of five layers with all arcs."""


def written(folder: Path, layers: dict[str, str] = LAYERS) -> Path:
    """Write *layers* into *folder* and return the path of the first."""
    for name, text in layers.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")
    return folder / next(iter(layers))


def random_layers(seed: int) -> dict[str, str]:
    """Return layers of prims that refer to each other, without cycles between layers."""
    choice = random.Random(seed)  # noqa: S311  not for secrets
    names = ["root.usda", "one.usda", "two.usda"]
    return {
        name: layer(
            _random_class(choice)
            + "\n".join(
                _random_prim(choice, each, names[number + 1 :], f"/{each}") for each in "abc"
            ),
            more='    defaultPrim = "a"',
        )
        for number, name in enumerate(names)
    }


def _random_class(choice: random.Random) -> str:
    """Return a class, or nothing."""
    value = choice.randint(0, 9)
    lines = (
        'class "k"', "{", f"float v1 = {value}", "rel r = </k/e>",
        'def "e"', "{", f"float v2 = {value}", "}", "}", "",
    )  # fmt: skip
    text = "\n".join(lines)
    return text if choice.random() < 0.6 else ""


def _random_prim(choice: random.Random, name: str, others: list[str], path: str) -> str:
    said: list[str] = []
    depth = path.count("/")
    if others and choice.random() < 0.5:
        kind = choice.choice(["references", "payload", "prepend references"])
        target = choice.choice(["", "</a>", "</b>", "</c/d>"])
        said.append(f"{kind} = @{choice.choice(others)}@{target}")
    if name in "bd" and choice.random() < 0.3:
        said.append("inherits = </k>")
    if choice.random() < 0.3:
        said.append('prepend apiSchemas = ["PhysicsMassAPI"]')
    values = [f"float v{n} = {choice.randint(0, 9)}" for n in range(3) if choice.random() < 0.5]
    if choice.random() < 0.4:
        values.append(f"prepend rel r = <{choice.choice(['/a/d', '/b', 'd', '/c/e'])}>")
    children = ""
    if depth < 3:
        children = "\n".join(
            _random_prim(choice, each, others, f"{path}/{each}")
            for each in "de"
            if choice.random() < 0.6
        )
    head = choice.choice(["def Xform", "over", "def"])
    return f'{head} "{name}" (\n{chr(10).join(said)}\n)\n{{\n{chr(10).join(values)}\n{children}\n}}'
