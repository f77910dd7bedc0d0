"""Serial chains of any length as composable JSON-LD, clean or with known defects."""

from __future__ import annotations

import json
from typing import Any

from benchmarks import defects

NAMESPACE = "https://example.org/chain#"
METAMODELS = "https://comp-rob2b.github.io/metamodels/"
CONTEXTS = (
    f"{METAMODELS}geometry/structural-entities.json",
    f"{METAMODELS}geometry/spatial-relations.json",
    f"{METAMODELS}geometry/coordinates.json",
    f"{METAMODELS}kinematic-chain/structural-entities.json",
    "https://w3id.org/kinlint/kinematics.json",
    f"{METAMODELS}newtonian-rigid-body-dynamics/structural-entities.json",
    f"{METAMODELS}newtonian-rigid-body-dynamics/coordinates.json",
    f"{METAMODELS}qudt.json",
)
Node = dict[str, Any]


def chain(joints: int, *, spoiled: bool = False) -> str:
    """The text of a chain of *joints* revolute joints between *joints* + 1 bodies.

    A spoiled one has the findings that `defects.expected` counts, a clean one has none.
    """
    nodes: list[Node] = []
    for number in range(joints + 1):
        body = [*_frame(f"link{number}-root"), *_frame(f"link{number}-tip")]
        simplices = [node["@id"] for node in body]
        nodes += body
        nodes.append(
            {
                "@id": f"rob:link{number}",
                "@type": ["SimplicialComplex", "RigidBody"],
                "simplices": simplices,
            }
        )
        nodes += _pose(number)
        nodes += _inertia(number)
    for number in range(joints):
        nodes += _joint(number)
    nodes.append(
        {
            "@id": "rob:arm",
            "@type": "KinematicChain",
            "joints": [f"rob:joint{number}" for number in range(joints)],
        }
    )
    named = {node["@id"]: node for node in nodes}
    if spoiled:
        defects.inject(named, joints)
    context = [*CONTEXTS, {"rob": NAMESPACE}]
    return json.dumps(
        {"@context": context, "@id": "rob:model", "@graph": [*named.values()]}, indent=2
    )


def _frame(name: str) -> list[Node]:
    axes = [
        {
            "@id": f"rob:{name}-{axis}",
            "@type": ["3D", "Euclidean", "Vector", "BoundVector", "UnitLength"],
            "start": f"rob:{name}-origin",
        }
        for axis in "xyz"
    ]
    return [
        {"@id": f"rob:{name}-origin", "@type": ["3D", "Euclidean", "Point"]},
        *axes,
        {
            "@id": f"rob:{name}",
            "@type": ["3D", "Euclidean", "Frame", "Orthonormal", "RightHanded", "OriginVectorsXYZ"],
            "origin": f"rob:{name}-origin",
            **{f"vector-{axis}": f"rob:{name}-{axis}" for axis in "xyz"},
        },
    ]


def _pose(number: int) -> list[Node]:
    root, tip = f"rob:link{number}-root", f"rob:link{number}-tip"
    return [
        {
            "@id": f"rob:link{number}-pose",
            "@type": "Pose",
            "of": tip,
            "with-respect-to": root,
            "quantity-kind": ["Angle", "Length"],
        },
        {
            "@id": f"rob:link{number}-orientation-coord",
            "@type": ["PoseReference", "PoseCoordinate", "DirectionCosineXYZ"],
            "of-pose": f"rob:link{number}-pose",
            "as-seen-by": root,
            "unit": "UNITLESS",
            "direction-cosine-x": [1.0, 0.0, 0.0],
            "direction-cosine-y": [0.0, 0.0, -1.0],
            "direction-cosine-z": [0.0, 1.0, 0.0],
        },
        {
            "@id": f"rob:link{number}-position-coord",
            "@type": ["PoseReference", "PoseCoordinate", "VectorXYZ"],
            "of-pose": f"rob:link{number}-pose",
            "as-seen-by": root,
            "unit": "M",
            "x": 0.0,
            "y": 0.0,
            "z": 0.25,
        },
    ]


def _inertia(number: int) -> list[Node]:
    return [
        {
            "@id": f"rob:link{number}-inertia",
            "@type": "RigidBodyInertia",
            "of-body": f"rob:link{number}",
            "about": f"rob:link{number}-root-origin",
            "quantity-kind": ["Mass", "MomentOfInertia"],
        },
        {
            "@id": f"rob:link{number}-mass",
            "@type": ["InertiaReference", "RigidBodyInertiaCoordinate", "MassScalar"],
            "of-inertia": f"rob:link{number}-inertia",
            "as-seen-by": f"rob:link{number}-root",
            "unit": "KiloGM",
            "mass": 1.5,
        },
        {
            "@id": f"rob:link{number}-moments",
            "@type": [
                "InertiaReference",
                "RigidBodyInertiaCoordinate",
                "MomentOfInertiaXYZ",
                "ProductOfInertiaXYZ",
            ],
            "of-inertia": f"rob:link{number}-inertia",
            "as-seen-by": f"rob:link{number}-root",
            "unit": "KiloGM-M2",
            "ixx": 0.011,
            "iyy": 0.012,
            "izz": 0.004,
            "ixy": 0.0001,
            "ixz": 0.0,
            "iyz": -0.0002,
        },
    ]


def _joint(number: int) -> list[Node]:
    tip, root = f"rob:link{number}-tip", f"rob:link{number + 1}-root"
    return [
        {
            "@id": f"rob:joint{number}",
            "@type": ["Joint", "RevoluteJoint", "RevoluteJointWithPolarity"],
            "between-attachments": [tip, root],
            "common-axis": f"rob:joint{number}-axis",
            "origin-offset": f"rob:joint{number}-offset",
            "positive-direction": f"{tip}-z",
            "handedness": "RightHanded",
        },
        {
            "@id": f"rob:joint{number}-zero",
            "@type": "ZeroConfiguration",
            "of-joint": f"rob:joint{number}",
            "coincidence-of": [f"{tip}-x", f"{root}-x"],
        },
        {
            "@id": f"rob:joint{number}-axis",
            "@type": "LineCollinearity",
            "lines": [f"{tip}-z", f"{root}-z"],
        },
        {
            "@id": f"rob:joint{number}-offset",
            "@type": "Position",
            "of": f"{root}-origin",
            "with-respect-to": f"{tip}-origin",
            "quantity-kind": "Length",
        },
        {
            "@id": f"rob:joint{number}-offset-coord",
            "@type": ["PositionReference", "PositionCoordinate", "VectorXYZ"],
            "of-position": f"rob:joint{number}-offset",
            "as-seen-by": tip,
            "unit": "M",
            "x": 0.0,
            "y": 0.0,
            "z": 0.0,
        },
    ]
