"""Serial chains of any length as composable JSON-LD, clean or with known defects."""

from __future__ import annotations

import json
from typing import Any

from benchmarks import defects

METAMODELS = "https://comp-rob2b.github.io/metamodels/"
CONTEXTS = (
    "geometry/structural-entities.json",
    "geometry/spatial-relations.json",
    "geometry/coordinates.json",
    "kinematic-chain/structural-entities.json",
    "newtonian-rigid-body-dynamics/structural-entities.json",
    "newtonian-rigid-body-dynamics/coordinates.json",
    "qudt.json",
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
    if spoiled:
        defects.inject({node["@id"]: node for node in nodes}, joints)
    context = [*(METAMODELS + path for path in CONTEXTS), {"rob": "https://example.org/chain#"}]
    return json.dumps({"@context": context, "@id": "rob:model", "@graph": nodes}, indent=2)


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
            "@id": f"rob:link{number}-pose-coord",
            "@type": ["PoseReference", "PoseCoordinate", "DirectionCosineXYZ", "VectorXYZ"],
            "of-pose": f"rob:link{number}-pose",
            "as-seen-by": root,
            "unit": ["UNITLESS", "M"],
            "direction-cosine-x": [1.0, 0.0, 0.0],
            "direction-cosine-y": [0.0, 0.0, -1.0],
            "direction-cosine-z": [0.0, 1.0, 0.0],
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
            "@id": f"rob:link{number}-inertia-coord",
            "@type": [
                "InertiaReference",
                "RigidBodyInertiaCoordinate",
                "MassScalar",
                "MomentOfInertiaXYZ",
                "ProductOfInertiaXYZ",
            ],
            "of-inertia": f"rob:link{number}-inertia",
            "as-seen-by": f"rob:link{number}-root",
            "unit": ["KiloGM", "KiloGM-M2"],
            "mass": 1.5,
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
            "@type": ["Joint", "RevoluteJoint"],
            "between-attachments": [tip, root],
            "common-axis": f"rob:joint{number}-axis",
            "origin-offset": f"rob:joint{number}-offset",
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
