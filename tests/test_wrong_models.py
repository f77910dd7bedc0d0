"""Faults that the published shapes let pass are named; right models that they refuse are clean."""

import json

import pytest
from support.linting import codes, findings

CONTEXT = ["https://w3id.org/kinlint/composable.json", {"ex": "https://example.org/robot#"}]

BODIES = [
    {"@id": "ex:base", "@type": ["SimplicialComplex", "RigidBody"], "simplices": ["ex:a", "ex:b"]},
    {"@id": "ex:arm", "@type": ["SimplicialComplex", "RigidBody"], "simplices": ["ex:c", "ex:d"]},
    {"@id": "ex:hand", "@type": ["SimplicialComplex", "RigidBody"], "simplices": ["ex:e", "ex:f"]},
    *({"@id": f"ex:{name}", "@type": ["3D", "Euclidean", "Frame"]} for name in "abcdef"),
]
JOINT = {"@id": "ex:joint", "@type": ["Joint", "RevoluteJoint"]}
OFFSET = {"@id": "ex:offset", "@type": "Position", "quantity-kind": "Length"}
NUMBERS = {"x": 0.1, "y": 0.0, "z": 0.4}
POSITION = {
    "@id": "ex:offset-coord",
    "@type": ["PositionReference", "PositionCoordinate", "VectorXYZ"],
    "of-position": "ex:offset",
    "as-seen-by": "ex:a",
    "unit": "M",
    **NUMBERS,
}
POINTS = [{"@id": f"ex:{name}", "@type": ["3D", "Euclidean", "Point"]} for name in "pq"]
BETWEEN_POINTS = OFFSET | {"of": "ex:p", "with-respect-to": "ex:q"}
POSE = {"@id": "ex:pose", "@type": "Pose", "quantity-kind": ["Angle", "Length"]}
SEEN = {
    "@id": "ex:pose-coord",
    "@type": ["PoseReference", "PoseCoordinate", "VectorXYZ"],
    "of-pose": "ex:pose",
    "unit": "M",
    **NUMBERS,
}
INERTIA = {"@id": "ex:inertia", "@type": "RigidBodyInertia", "of-body": "ex:base", "about": "ex:p"}
MASS = {
    "@id": "ex:inertia-coord",
    "@type": ["InertiaReference", "RigidBodyInertiaCoordinate", "MassScalar"],
    "of-inertia": "ex:inertia",
    "as-seen-by": "ex:a",
    "unit": "KiloGM",
}
WRENCHES = [
    {
        "@id": f"ex:{name}",
        "@type": ["WrenchReference", "WrenchCoordinate"],
        "of-wrench": f"ex:{name}-wrench",
        "as-seen-by": f"ex:{frame}",
        "unit": ["N", "N-M"],
    }
    for name, frame in (("w1", "a"), ("w2", "a"), ("w3", "b"))
]


def pose(name, of, base):
    return POSE | {"@id": f"ex:{name}", "of": f"ex:{of}", "with-respect-to": f"ex:{base}"}


def body(name):
    """A body with a frame that is all there."""
    axes = [f"ex:{name}-{axis}" for axis in "xyz"]
    origin, frame = f"ex:{name}-origin", f"ex:{name}-frame"
    vector = {"@type": ["3D", "Euclidean", "Vector", "BoundVector", "UnitLength"], "start": origin}
    return [
        {"@id": origin, "@type": ["3D", "Euclidean", "Point"]},
        *(vector | {"@id": axis} for axis in axes),
        {
            "@id": frame,
            "@type": ["3D", "Frame", "Orthonormal", "RightHanded", "OriginVectorsXYZ"],
            "origin": origin,
            **{f"vector-{axis[-1]}": axis for axis in axes},
        },
        {
            "@id": f"ex:{name}",
            "@type": ["SimplicialComplex", "RigidBody"],
            "simplices": [frame, origin, *axes],
        },
    ]


RIGHT = {
    "P1 the identity as direction cosines": [
        *body("base"),
        *body("arm"),
        {
            "@id": "ex:turn",
            "@type": "Orientation",
            "of": "ex:arm-frame",
            "with-respect-to": "ex:base-frame",
            "quantity-kind": "Angle",
        },
        {
            "@id": "ex:turn-coord",
            "@type": ["OrientationReference", "OrientationCoordinate", "DirectionCosineXYZ"],
            "of-orientation": "ex:turn",
            "as-seen-by": "ex:base-frame",
            "unit": "UNITLESS",
            "direction-cosine-x": [1.0, 0.0, 0.0],
            "direction-cosine-y": [0.0, 1.0, 0.0],
            "direction-cosine-z": [0.0, 0.0, 1.0],
        },
    ],
    "P2 an angular velocity as a list": [
        *body("base"),
        *body("arm"),
        {
            "@id": "ex:spin",
            "@type": "VelocityTwist",
            "of": "ex:arm",
            "with-respect-to": "ex:base",
            "reference-point": "ex:arm-origin",
            "quantity-kind": ["AngularVelocity", "LinearVelocity"],
        },
        {
            "@id": "ex:spin-coord",
            "@type": ["VelocityReference", "VelocityTwistCoordinate", "AngularVelocityVectorXYZ"],
            "of-velocity": "ex:spin",
            "as-seen-by": "ex:base-frame",
            "unit": "RAD-PER-SEC",
            "angular-velocity": [0.0, 0.0, 0.5],
        },
    ],
    "P3 a damping controller": [
        *(
            {"@id": f"ex:{name}", "@type": "Quantity", "quantity-kind": kind, "unit": unit}
            for name, kind, unit in (
                ("fastest", "LinearVelocity", "M-PER-SEC"),
                ("strongest", "Force", "N"),
                ("speed", "LinearVelocity", "M-PER-SEC"),
                ("error", "LinearVelocity", "M-PER-SEC"),
                ("command", "Force", "N"),
            )
        ),
        {
            "@id": "ex:damper",
            "@type": ["Controller", "DampingController"],
            "error-signal": "ex:error",
            "control-signal": "ex:command",
            "maximum-velocity": "ex:fastest",
            "maximum-force": "ex:strongest",
            "measured-velocity": "ex:speed",
        },
    ],
}


WRONG = {
    "N1 both attachments on one body": (
        "TOP005",
        [*BODIES, JOINT | {"between-attachments": ["ex:a", "ex:b"]}],
    ),
    "N2 one attachment": ("TOP005", [*BODIES, JOINT | {"between-attachments": ["ex:a"]}]),
    "N3 a joint with nothing": ("TOP005", [JOINT]),
    "N4 a joint between bodies": (
        "TOP010",
        [*BODIES, JOINT | {"between-attachments": ["ex:base", "ex:arm"]}],
    ),
    "N5 a chain in pieces": (
        "TOP006",
        [
            *BODIES,
            {"@id": "ex:far", "@type": ["SimplicialComplex"], "simplices": ["ex:g"]},
            {"@id": "ex:g", "@type": ["3D", "Euclidean", "Frame"]},
            JOINT | {"@id": "ex:one", "between-attachments": ["ex:a", "ex:c"]},
            JOINT | {"@id": "ex:two", "between-attachments": ["ex:e", "ex:g"]},
            {"@id": "ex:chain", "@type": "KinematicChain", "joints": ["ex:one", "ex:two"]},
        ],
    ),
    "N6 a frame in two bodies": (
        "TOP011",
        [*BODIES, {"@id": "ex:hand", "@type": "SimplicialComplex", "simplices": ["ex:a"]}],
    ),
    "N7 a bound vector without a start": (
        "FRM022",
        [{"@id": "ex:axis", "@type": ["3D", "Euclidean", "Vector", "BoundVector"]}],
    ),
    "N8 a frame of three vectors that has none": (
        "FRM014",
        [{"@id": "ex:frame", "@type": ["3D", "Euclidean", "Frame", "OriginVectorsXYZ"]}],
    ),
    "N9 vectors that start elsewhere": (
        "FRM021",
        [
            *POINTS,
            *(
                {
                    "@id": f"ex:{axis}",
                    "@type": ["3D", "Euclidean", "Vector", "BoundVector"],
                    "start": "ex:q",
                }
                for axis in ("frame-x", "frame-y", "frame-z")
            ),
            {
                "@id": "ex:frame",
                "@type": ["3D", "Euclidean", "Frame", "OriginVectorsXYZ"],
                "origin": "ex:p",
                "vector-x": "ex:frame-x",
                "vector-y": "ex:frame-y",
                "vector-z": "ex:frame-z",
            },
        ],
    ),
    "N10 a position of nothing": ("FRM001", [OFFSET]),
    "N11 a position of a point relative to itself": (
        "FRM016",
        [*POINTS, OFFSET | {"of": "ex:p", "with-respect-to": "ex:p"}],
    ),
    "N11 a position that is a mass": (
        "UNI014",
        [*POINTS, BETWEEN_POINTS | {"quantity-kind": "Mass"}],
    ),
    "N12 an orientation between points": (
        "FRM015",
        [
            *POINTS,
            {
                "@id": "ex:turn",
                "@type": "Orientation",
                "quantity-kind": "Angle",
                "of": "ex:p",
                "with-respect-to": "ex:q",
            },
        ],
    ),
    "N13 no unit": (
        "UNI001",
        [*BODIES, *POINTS, BETWEEN_POINTS, {k: v for k, v in POSITION.items() if k != "unit"}],
    ),
    "N14 a length in kilograms": (
        "UNI002",
        [*BODIES, *POINTS, BETWEEN_POINTS, POSITION | {"unit": "KiloGM"}],
    ),
    "N15 coordinates that contradict each other": (
        "FRM003",
        [
            *BODIES,
            *POINTS,
            BETWEEN_POINTS,
            POSITION,
            POSITION | {"@id": "ex:other-coord", "unit": "CentiM", "z": 42.0},
        ],
    ),
    "N16 coordinates of nothing": (
        "FRM027",
        [*BODIES, {k: v for k, v in POSITION.items() if k != "of-position"}],
    ),
    "N17 a pose seen by a third frame": (
        "FRM019",
        [*BODIES, pose("pose", "a", "b"), SEEN | {"as-seen-by": "ex:c"}],
    ),
    "N18 a negative mass": ("INE003", [*BODIES, *POINTS, INERTIA, MASS | {"mass": -1.0}]),
    "N18 moments that no body has": (
        "INE001",
        [
            *BODIES,
            *POINTS,
            INERTIA,
            MASS
            | {
                "@type": ["InertiaReference", "RigidBodyInertiaCoordinate", "MomentOfInertiaXYZ"],
                "unit": "KiloGM-M2",
                "ixx": 1.0,
                "iyy": 0.1,
                "izz": 0.1,
            },
        ],
    ),
    "N19 an inertia without a body": (
        "INE011",
        [*POINTS, {"@id": "ex:inertia", "@type": "RigidBodyInertia", "about": "ex:p"}],
    ),
    "N20 a line collinear with nothing": (
        "FRM033",
        [{"@id": "ex:axis", "@type": "LineCollinearity", "lines": ["ex:v"]}],
    ),
    "N21 forward kinematics of no joint": (
        "ALG001",
        [
            {
                "@id": "ex:fpk",
                "@type": "ForwardPositionKinematics",
                "joint-space-motion": "ex:q1",
                "cartesian-space-motion": "ex:pose-coord",
            }
        ],
    ),
    "N22 an empty schedule": (
        "ALG008",
        [{"@id": "ex:schedule", "@type": "Schedule", "trigger-chain": []}],
    ),
    "N23 a sum of wrenches in another frame": (
        "ALG006",
        [
            *BODIES,
            *WRENCHES,
            {
                "@id": "ex:sum",
                "@type": "AddWrench",
                "in1": "ex:w1",
                "in2": "ex:w2",
                "out": "ex:w3",
            },
        ],
    ),
    "N24 a composition that leads elsewhere": (
        "ALG002",
        [
            *BODIES,
            pose("one", "b", "a"),
            pose("two", "c", "b"),
            pose("whole", "d", "a"),
            {
                "@id": "ex:compose",
                "@type": "ComposePose",
                "in1": "ex:one",
                "in2": "ex:two",
                "composite": "ex:whole",
            },
        ],
    ),
    "N25 two lower thresholds": (
        "ID004",
        [
            {
                "@id": "ex:range",
                "@type": ["Constraint", "BilateralConstraint"],
                "quantity": "ex:height",
                "lower-threshold": ["ex:low", "ex:lower"],
                "upper-threshold": "ex:high",
            }
        ],
    ),
    "N26 a pose that is a velocity": (
        "LD012",
        [
            *BODIES,
            pose("pose", "a", "b") | {"@type": ["Pose", "VelocityTwist"]},
        ],
    ),
    "N27 a joint without an offset": (
        "FRM025",
        [*BODIES, JOINT | {"between-attachments": ["ex:a", "ex:c"]}],
    ),
}


def model(nodes):
    return json.dumps({"@context": CONTEXT, "@graph": nodes}, indent=2)


@pytest.mark.parametrize("fault", WRONG)
def test_a_fault_is_named(fault):
    """By the rule about it."""
    code, nodes = WRONG[fault]

    assert code in codes(model(nodes), "robot.jsonld")


def test_each_of_the_wrong_models_is_here():
    """From N1 to N27."""
    assert {fault.split()[0] for fault in WRONG} == {f"N{number}" for number in range(1, 28)}


@pytest.mark.parametrize("name", RIGHT)
def test_what_is_right_is_clean(name):
    """Whatever the published shapes say of it."""
    found = findings(model(RIGHT[name]), "robot.jsonld")

    assert [finding.message for finding in found] == []
