"""A slip in a right model is one finding, at the word that its author has to change."""

import json

import pytest
from support.linting import findings

from kinlint.formats.registry import decode

CONTEXT = ["https://w3id.org/kinlint/composable.json", {"r": "https://robots.example/arm#"}]


def parts(*frames):
    """Return the names of *frames*, their origins and their vectors."""
    return [f"r:{f}{end}" for f in frames for end in ("", "-origin", "-x", "-y", "-z")]


def body(name, *frames):
    """Yield a body and its frames, each with an origin and three vectors."""
    yield {
        "@id": f"r:{name}",
        "@type": ["SimplicialComplex", "RigidBody"],
        "simplices": parts(*frames),
    }
    for frame in frames:
        origin = {"@id": f"r:{frame}-origin", "@type": ["3D", "Point"]}
        vectors = [
            {"@id": f"r:{frame}-{axis}", "@type": ["3D", "Vector", "BoundVector", "UnitLength"]}
            | {"start": f"r:{frame}-origin"}
            for axis in "xyz"
        ]
        axes = {f"vector-{axis}": f"r:{frame}-{axis}" for axis in "xyz"}
        kinds = ["3D", "Frame", "Orthonormal", "RightHanded", "OriginVectorsXYZ"]
        yield from (origin, *vectors)
        yield {"@id": f"r:{frame}", "@type": kinds, "origin": f"r:{frame}-origin", **axes}


def pose(of, reference):
    """Yield a pose and its coordinates."""
    yield {"@id": f"r:pose-{of}", "@type": "Pose", "of": f"r:{of}"} | {
        "with-respect-to": f"r:{reference}",
        "quantity-kind": ["Angle", "Length"],
    }
    kinds = ["3D", "PoseReference", "PoseCoordinate", "EulerAngles", "Intrinsic", "VectorXYZ"]
    numbers = {"axes-sequence": "zyx", **dict.fromkeys(("alpha", "beta", "gamma", "y", "z"), 0.0)}
    yield {"@id": f"r:pose-{of}-coord", "@type": kinds, "of-pose": f"r:pose-{of}"} | {
        "as-seen-by": f"r:{reference}",
        "unit": ["RAD", "M"],
        "x": 0.4,
        **numbers,
    }


def joint(name, near, far):
    """Yield a joint between two frames, with its axis, and its offset with coordinates."""
    kinds = ["Joint", "RevoluteJoint", "RevoluteJointWithPolarity"]
    ends = {"of": f"r:{far}-origin", "with-respect-to": f"r:{near}-origin"}
    offset = {"@id": f"r:{name}-offset", "@type": "Position", **ends, "quantity-kind": "Length"}
    lines = [f"r:{near}-z", f"r:{far}-z"]
    numbers = {"as-seen-by": f"r:{near}", "unit": "M", "x": 0.0, "y": 0.0, "z": 0.1}
    yield {"@id": f"r:{name}", "@type": kinds, "between-attachments": [f"r:{near}", f"r:{far}"]} | {
        "common-axis": f"r:{name}-axis",
        "origin-offset": f"r:{name}-offset",
        "positive-direction": f"r:{far}-z",
        "handedness": "RightHanded",
    }
    yield {"@id": f"r:{name}-axis", "@type": "LineCollinearity", "lines": lines}
    yield offset
    coordinates = ["3D", "PositionReference", "PositionCoordinate", "VectorXYZ"]
    yield {"@id": f"r:{name}-offset-coord", "@type": coordinates, **numbers} | {
        "of-position": f"r:{name}-offset"
    }
    zero = {"of-joint": f"r:{name}", "coincidence-of": [f"r:{near}-x", f"r:{far}-x"]}
    yield {"@id": f"r:{name}-zero", "@type": "ZeroConfiguration", **zero}


FILES = {
    "bodies.jsonld": [
        *body("base", "base-root", "base-top"),
        *body("upper", "upper-root", "upper-top"),
        *body("fore", "fore-root", "fore-tip"),
    ],
    "poses.jsonld": [
        *pose("base-top", "base-root"),
        *pose("upper-top", "upper-root"),
        *pose("fore-tip", "fore-root"),
    ],
    "joints.jsonld": [
        *joint("j1", "base-top", "upper-root"),
        *joint("j2", "upper-top", "fore-root"),
        {"@id": "r:arm", "@type": "KinematicChain", "joints": ["r:j1", "r:j2"]},
    ],
}
SLIPS = {
    "of and with-respect-to swapped": (
        "FRM019",
        ("pose-upper-top", "of"),
        {"pose-upper-top": {"of": "r:upper-root", "with-respect-to": "r:upper-top"}},
    ),
    "of and with-respect-to swapped in the first body": (
        "FRM019",
        ("pose-base-top", "of"),
        {"pose-base-top": {"of": "r:base-root", "with-respect-to": "r:base-top"}},
    ),
    "coordinates seen by the frame that they place": (
        "FRM019",
        ("pose-upper-top-coord", "as-seen-by"),
        {"pose-upper-top-coord": {"as-seen-by": "r:upper-top"}},
    ),
    "the origin of another body's frame": (
        "FRM021",
        ("upper-top", "origin"),
        {"upper-top": {"origin": "r:fore-root-origin"}},
    ),
    "one vector that starts elsewhere": (
        "FRM021",
        ("upper-top-x", "start"),
        {"upper-top-x": {"start": "r:upper-root-origin"}},
    ),
    "both lines on one body": (
        "FRM023",
        ("j1-axis", "lines"),
        {"j1-axis": {"lines": ["r:upper-top-z", "r:upper-root-z"]}},
    ),
    "a line of a third body": (
        "FRM023",
        ("j1-axis", "lines"),
        {"j1-axis": {"lines": ["r:base-top-z", "r:fore-root-z"]}},
    ),
    "the axis of the next joint": (
        "FRM023",
        ("j1", "common-axis"),
        {"j1": {"common-axis": "r:j2-axis"}},
    ),
    "lines that are not parallel": (
        "FRM037",
        ("j1-axis", "lines"),
        {"j1-axis": {"lines": ["r:base-top-z", "r:upper-root-x"]}},
    ),
    "a positive direction off the axis": (
        "FRM037",
        ("j1", "positive-direction"),
        {"j1": {"positive-direction": "r:upper-root-x"}},
    ),
    "the offset of the next joint": (
        "FRM024",
        ("j1", "origin-offset"),
        {"j1": {"origin-offset": "r:j2-offset"}},
    ),
    "an end of the offset at another point": (
        "FRM024",
        ("j1-offset", "of"),
        {"j1-offset": {"of": "r:upper-top-origin"}},
    ),
    "a frame that a second body lists, too": (
        "TOP011",
        ("fore", "simplices"),
        {"fore": {"simplices": [*parts("fore-root", "fore-tip"), "r:upper-top"]}},
    ),
    "a frame with all its parts that a second body lists, too": (
        "TOP011",
        ("base", "simplices"),
        {"base": {"simplices": parts("base-root", "base-top", "upper-root")}},
    ),
    "a vector that is a point": (
        "LD012",
        ("upper-top", "vector-x"),
        {"upper-top": {"vector-x": "r:upper-top-origin"}},
    ),
    "a pose without the kind of its offset": (
        "UNI020",
        ("pose-upper-top", "quantity-kind"),
        {"pose-upper-top": {"quantity-kind": "Angle"}},
    ),
    "a pose without the kind of its rotation": (
        "UNI020",
        ("pose-upper-top", "quantity-kind"),
        {"pose-upper-top": {"quantity-kind": ["Length"]}},
    ),
}


def model(changes):
    """Yield the files of the arm, one member a line, but for *changes* by node."""
    for name, nodes in FILES.items():
        graph = [node | changes.get(node["@id"].removeprefix("r:"), {}) for node in nodes]
        text = json.dumps({"@context": CONTEXT, "@graph": graph}, indent=1)
        yield decode(name, text.encode())


def place(finding):
    """Return the node and the key that *finding* is shown in."""
    before = finding.location.source.text[: finding.location.span.start].splitlines()
    name = next(line for line in reversed(before) if '"@id"' in line).split('"')[3]
    key = next(line for line in reversed([*before]) if '":' in line).split('"')[1]
    return name.removeprefix("r:"), key


@pytest.mark.slow
def test_the_arm_is_right():
    assert list(findings(model({}))) == []


@pytest.mark.slow
@pytest.mark.parametrize("slip", SLIPS)
def test_a_slip_is_shown_where_it_is(slip):
    code, where, changes = SLIPS[slip]

    assert [(each.rule.code, place(each)) for each in findings(model(changes))] == [(code, where)]
