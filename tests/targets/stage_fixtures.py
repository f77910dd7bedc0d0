"""A stage of USD for each plain feature: a small arm that has it.

Names and numbers are those of the URDFs, so that the same words tell what became of a feature.
"""

from __future__ import annotations

import math

DEGREES = 180 / math.pi
MASS = "float physics:mass = 2\nfloat3 physics:diagonalInertia = (0.02, 0.02, 0.02)"
LIMITS = f"float physics:lowerLimit = {-DEGREES}\nfloat physics:upperLimit = {2 * DEGREES}"


def prim(kind: str, name: str, content: str, *schemas: str) -> str:
    """Return a prim of this *kind* with *schemas*."""
    applied = ", ".join(f'"{each}"' for each in schemas)
    told = f"prepend apiSchemas = [{applied}]" if schemas else ""
    return f'def {kind} "{name}" ({told})\n{{\n{content}\n}}\n'


def shape(kind: str, content: str, *schemas: str, name: str = "shape") -> str:
    """Return a collider of this *kind*."""
    return prim(kind, name, content, "PhysicsCollisionAPI", *schemas)


BOX = shape(
    "Cube",
    "double size = 0.1\ndouble3 xformOp:scale = (1, 1, 2)\n"
    'uniform token[] xformOpOrder = ["xformOp:scale"]',
)
POINTS = """point3f[] points = [(0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 3)]
int[] faceVertexCounts = [3, 3, 3, 3]
int[] faceVertexIndices = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]"""


def link(name: str, height: float, mass: str, shapes: str, more: str = "") -> str:
    """Return a body at this *height*."""
    place = f"double3 xformOp:translate = (0, 0, {height})"
    order = 'uniform token[] xformOpOrder = ["xformOp:translate"]'
    content = f"{place}\n{order}\n{mass}\n{more}\n{shapes}"
    return prim("Xform", name, content, "PhysicsRigidBodyAPI", "PhysicsMassAPI")


def joint(
    name: str, bodies: tuple[str, str], height: float, content: str, *schemas: str, kind: str
) -> str:
    """Return a joint of this *kind* between *bodies*; without the first, with the world."""
    first = f"rel physics:body0 = </arm/{bodies[0]}>\n" if bodies[0] else ""
    place = f"""{first}rel physics:body1 = </arm/{bodies[1]}>
point3f physics:localPos0 = (0, 0, {height})
point3f physics:localPos1 = (0, 0, 0)
quatf physics:localRot0 = (1, 0, 0, 0)
quatf physics:localRot1 = (1, 0, 0, 0)
"""
    return prim(kind, name, place + content, *schemas)


AXIS = 'uniform token physics:axis = "Z"'


def stage(  # noqa: PLR0913
    *more: str,
    kind: str = "PhysicsRevoluteJoint",
    turn: str = f"{AXIS}\n{LIMITS}",
    drive: tuple[str, ...] = (),
    mass: str = MASS,
    shapes: str = BOX,
    wrist: tuple[str, ...] = (),
    hold: str = joint("hold", ("", "base"), 0, "", kind="PhysicsFixedJoint"),
    units: str = "metersPerUnit = 1",
    up: str = "Z",
    body: str = "",
) -> str:
    """Return an arm of USD: a body that stands, one that moves, and one that turns on that."""
    schema, bend = (*wrist, "")[:2] if wrist else ("", "")
    parts = (
        link("base", 0, MASS, ""),
        link("upper", 1, mass, shapes, body),
        link("tip", 1.5, MASS, BOX),
        hold,
        joint("elbow", ("base", "upper"), 1, turn, *drive, kind=kind),
        joint(
            "wrist",
            ("upper", "tip"),
            0.5,
            f'uniform token physics:axis = "Y"\n{LIMITS}\n{bend}',
            *filter(None, [schema]),
            kind="PhysicsRevoluteJoint",
        ),
        *more,
    )
    arm = prim("Xform", "arm", "".join(parts), "PhysicsArticulationRootAPI")
    return f"""#usda 1.0
(
    defaultPrim = "arm"
    {units}
    kilogramsPerUnit = 1
    upAxis = "{up}"
)
{arm}"""


def turned(content: str, *schemas: str, kind: str = "PhysicsRevoluteJoint") -> str:
    """Return an arm whose elbow has *content*."""
    return stage(kind=kind, turn=f"{AXIS}\n{content}", drive=schemas)


MOMENTS = "float physics:mass = 2\nfloat3 physics:diagonalInertia = (0.03, 0.04, 0.05)"

USD = {
    "usd": stage(),
    "usd-revolute-joint": stage(),
    "usd-prismatic-joint": turned(
        "float physics:lowerLimit = -1\nfloat physics:upperLimit = 2", kind="PhysicsPrismaticJoint"
    ),
    "usd-unlimited-joint": turned(""),
    "usd-spherical-joint": turned("", kind="PhysicsSphericalJoint"),
    "usd-cone-limit": turned(
        "float physics:coneAngle0Limit = 30\nfloat physics:coneAngle1Limit = 30",
        kind="PhysicsSphericalJoint",
    ),
    "usd-fixed-joint": turned("", kind="PhysicsFixedJoint"),
    "usd-distance-joint": turned("float physics:maxDistance = 1", kind="PhysicsDistanceJoint"),
    "usd-generic-joint": turned(
        "\n".join(
            f"float limit:{each}:physics:low = 1\nfloat limit:{each}:physics:high = -1"
            for each in ("transX", "transY", "transZ", "rotX")
        ),
        *(f"PhysicsLimitAPI:{each}" for each in ("transX", "transY", "transZ", "rotX")),
        kind="PhysicsJoint",
    ),
    "usd-position-limits": turned(
        f"float physics:lowerLimit = {-DEGREES / 2}\nfloat physics:upperLimit = {DEGREES / 2}"
    ),
    "usd-drive": turned(
        f"{LIMITS}\nfloat drive:angular:physics:stiffness = 50\n"
        "float drive:angular:physics:targetPosition = 10",
        "PhysicsDriveAPI:angular",
    ),
    "usd-drive-force": turned(
        f"{LIMITS}\nfloat drive:angular:physics:maxForce = 6\n"
        "float drive:angular:physics:stiffness = 50",
        "PhysicsDriveAPI:angular",
    ),
    "usd-acceleration-drive": turned(
        f'{LIMITS}\nuniform token drive:angular:physics:type = "acceleration"\n'
        "float drive:angular:physics:stiffness = 50",
        "PhysicsDriveAPI:angular",
    ),
    "usd-joint-to-world": stage(),
    "usd-excluded-joint": stage(
        joint(
            "close",
            ("base", "tip"),
            1.5,
            "uniform bool physics:excludeFromArticulation = 1",
            kind="PhysicsFixedJoint",
        )
    ),
    "usd-closed-loop": stage(joint("close", ("base", "tip"), 1.5, "", kind="PhysicsFixedJoint")),
    "usd-disabled-joint": stage(
        joint(
            "extra",
            ("base", "tip"),
            1.5,
            "uniform bool physics:jointEnabled = 0",
            kind="PhysicsFixedJoint",
        )
    ),
    "usd-breakable-joint": turned(f"{LIMITS}\nfloat physics:breakForce = 10"),
    "usd-inertia": stage(mass=MOMENTS),
    "usd-principal-axes": stage(
        mass=f"{MOMENTS}\nquatf physics:principalAxes = (0.70710678, 0, 0, 0.70710678)"
    ),
    "usd-mass-by-density": stage(mass="float physics:density = 1000"),
    "usd-mass-alone": stage(mass="float physics:mass = 2"),
    "usd-body-without-mass": stage(mass=""),
    "usd-box": stage(),
    "usd-cylinder": stage(shapes=shape("Cylinder", "double radius = 0.05\ndouble height = 0.2")),
    "usd-sphere": stage(shapes=shape("Sphere", "double radius = 0.05")),
    "usd-capsule": stage(shapes=shape("Capsule", "double radius = 0.05\ndouble height = 0.2")),
    "usd-cone": stage(shapes=shape("Cone", "double radius = 0.05\ndouble height = 0.2")),
    "usd-mesh": stage(shapes=shape("Mesh", POINTS)),
    "usd-convex-hull": stage(
        shapes=shape(
            "Mesh",
            f'{POINTS}\nuniform token physics:approximation = "convexHull"',
            "PhysicsMeshCollisionAPI",
        )
    ),
    "usd-several-colliders": stage(
        shapes=BOX + shape("Sphere", "double radius = 0.05", name="other")
    ),
    "usd-kinematic-body": stage(body="bool physics:kinematicEnabled = 1"),
    "usd-mimic-of-newton": stage(
        wrist=(
            "NewtonMimicAPI",
            "rel newton:mimicJoint = </arm/elbow>\nfloat newton:mimicCoef1 = 0.5",
        )
    ),
    "usd-mimic-of-physx": stage(
        wrist=(
            "PhysxMimicJointAPI:rotY",
            """rel physxMimicJoint:rotY:referenceJoint = </arm/elbow>
float physxMimicJoint:rotY:gearing = -0.5""",
        )
    ),
    "usd-joint-velocity-of-physx": turned(
        f"{LIMITS}\nfloat physxJoint:maxJointVelocity = 100", "PhysxJointAPI"
    ),
    "usd-joint-friction-of-physx": turned(
        f"{LIMITS}\nfloat physxJoint:jointFriction = 0.3", "PhysxJointAPI"
    ),
    "usd-armature-of-physx": turned(f"{LIMITS}\nfloat physxJoint:armature = 0.1", "PhysxJointAPI"),
    "usd-other-units": stage(units="metersPerUnit = 0.01"),
    "usd-y-up": stage(up="Y"),
}
