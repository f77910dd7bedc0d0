"""What a stage says of joints is whole after conversion, wherever frames coincide."""

from __future__ import annotations

import pytest
from support.linting import codes

from kinlint.conversion.composition import compose
from kinlint.conversion.output import jsonld
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.text import SourceText

BODY = 'def Xform "{}" (\n    apiSchemas = ["PhysicsRigidBodyAPI"]\n)\n{{\n}}\n'
HEAD = '#usda 1.0\n(\n    metersPerUnit = 1\n    kilogramsPerUnit = 1\n    upAxis = "Z"\n)\n'


@pytest.mark.parametrize("far", [(0, 0, 0), (0, 0, -0.1)])
def test_joints_keep_their_offsets(far: tuple[float, ...]) -> None:
    joint = (
        'def PhysicsRevoluteJoint "hinge"\n{\n    rel physics:body0 = </base>\n'
        "    rel physics:body1 = </arm>\n    point3f physics:localPos0 = (0, 0, 0.2)\n"
        f"    point3f physics:localPos1 = {far}\n}}\n"
    )
    text = HEAD + BODY.format("base") + BODY.format("arm") + joint
    source = SourceText("robot.usda", text)
    model = jsonld(compose([read(source, ReadOptions())]))

    assert "LD006" not in codes(model, "robot.jsonld")
