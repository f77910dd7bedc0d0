"""One slip in a right model of several files is one finding: nothing else follows it."""

import json
from pathlib import Path

import pytest
from support.linting import codes

from kinlint.formats.registry import decode

SAMPLE = Path(__file__).parent.parent / "samples" / "one-dof"
MODEL = {file.name: file.read_text(encoding="utf-8") for file in sorted(SAMPLE.glob("*.jsonld"))}
HALF = {"qx": 0.0, "qy": 0.0, "qz": 1.0, "qw": 0.0}
TURNED = "pose-link1-joint1-wrt-link1-root-orientation-coord"
SLIPS = {
    "an offset between nothing": ("FRM001", "joint1-offset", {"of": None, "with-respect-to": None}),
    "an offset of a frame": ("FRM015", "joint1-offset", {"of": "rob:link2-root"}),
    "an offset between other points": (
        "FRM024",
        "joint1-offset",
        {"of": "rob:link2-com", "with-respect-to": "rob:link1-root-origin"},
    ),
    "an axis that is a pose": (
        "FRM023",
        "joint1",
        {"common-axis": "rob:pose-link1-joint1-wrt-link1-root"},
    ),
    "an axis along two vectors of a frame": (
        "FRM043",
        "joint1-common-axis",
        {"lines": ["rob:link1-joint1-z", "rob:link1-joint1-x", "rob:link2-root-z"]},
    ),
    "a direction beside the axis": (
        "FRM037",
        "joint1",
        {"positive-direction": "rob:link2-root-y"},
    ),
    "an attachment that is a relation": (
        "TOP010",
        "joint1",
        {"between-attachments": ["rob:link1-joint1", "rob:joint1-offset"]},
    ),
    "a position seen by a point": (
        "FRM015",
        "joint1-offset-coord",
        {"as-seen-by": "rob:link2-root-origin"},
    ),
    "a pose seen by a body": ("FRM015", TURNED, {"as-seen-by": "rob:link1"}),
    "a mirror": ("FRM004", TURNED, {"direction-cosine-y": [0.0, -1.0, 0.0]}),
    "a quaternion that is another rotation": (
        "FRM003",
        TURNED,
        {"@type": ["PoseReference", "PoseCoordinate", "DirectionCosineXYZ", "Quaternion"], **HALF},
    ),
}


def model(name, changes):
    """The sample, but for *changes* in one node; what changes to None is left out."""
    for file, text in MODEL.items():
        content = json.loads(text)
        content["@context"] = ["https://w3id.org/kinlint/composable.json", content["@context"][-1]]
        for node in content["@graph"]:
            if node.get("@id") == f"rob:{name}":
                node.update(changes)
                for key in [key for key, value in changes.items() if value is None]:
                    del node[key]
        yield decode(file, json.dumps(content, indent=2).encode())


@pytest.mark.slow
def test_the_model_is_clean_but_for_what_it_always_tells():
    """Units without their numbers, as in the sample itself."""
    assert codes(model("nothing", {})) == []


@pytest.mark.slow
@pytest.mark.parametrize("slip", SLIPS)
def test_a_slip_is_one_finding(slip):
    code, name, changes = SLIPS[slip]

    assert codes(model(name, changes)) == [code]
