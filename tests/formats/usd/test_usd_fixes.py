"""Fixes of layers: what comes stands where usd-core reads it, and nothing else is touched."""

from __future__ import annotations

from pathlib import Path

import pytest
from reading_usd import HEAD

from kinlint.cli.main import main

Usd = pytest.importorskip("pxr.Usd")
BODY = 'def Xform "{}" (\n    prepend apiSchemas = ["PhysicsRigidBodyAPI"]\n)\n{{\n    {}\n}}\n'
SCOPE = 'def Scope "arm"\n{{\n    {}\n}}\n'


def fixed(path: Path, text: str, code: str, capsys: pytest.CaptureFixture[str]) -> str:
    """Return *text* after all fixes of the rule *code*."""
    path.write_text(text, "utf-8")
    main([str(path), "--isolated", "--no-cache", "--select", code, "--fix", "--unsafe-fixes"])
    capsys.readouterr()
    return path.read_text("utf-8")


def stage(text: str):
    layer = Usd.Stage.CreateInMemory()
    layer.GetRootLayer().ImportFromString(text)
    return layer


@pytest.mark.parametrize(
    "head",
    ["#usda 1.0\n", '#usda 1.0\n(\n    upAxis = "Z" # up\n)\n', HEAD, HEAD.replace(")", "\n)")],
)
def test_the_only_prim_becomes_the_default(head: str, tmp_path: Path, capsys) -> None:
    before = head + SCOPE.format(BODY.format("base", ""))
    after = fixed(tmp_path / "a.usda", before, "CMP069", capsys)

    assert not stage(before).HasDefaultPrim()
    assert stage(after).GetDefaultPrim().GetName() == "arm"


@pytest.mark.parametrize(
    "metadata",
    [
        "",
        '(\n    prepend apiSchemas = ["PhysicsRigidBodyAPI"]\n)',
        '(apiSchemas = ["PhysicsRigidBodyAPI"])',
        '(\n    append apiSchemas = [\n"PhysicsRigidBodyAPI",\n    ]\n    kind = "group"\n)',
        '( kind = "component" )',
        '(\n    """Upper."""\n    references = </b> (offset = 1)\n)',
    ],
)
def test_a_schema_that_is_missing_is_applied(metadata: str, tmp_path: Path, capsys) -> None:
    inertia = "float3 physics:diagonalInertia = (1, 1, 1)"
    prim = f'def Xform "a" {metadata}\n{{\n    float physics:mass = 2\n    {inertia}\n}}\n'
    before = f'{HEAD}{prim}def "b"\n{{\n}}\n'
    after = fixed(tmp_path / "a.usda", before, "SRC031", capsys)
    stages = stage(before), stage(after)
    old, new = (each.GetPrimAtPath("/a").GetAppliedSchemas() for each in stages)

    if "references" not in metadata:
        assert [*new] == [*old, "PhysicsMassAPI"]
        assert len(after.splitlines()) - len(before.splitlines()) <= 3


def test_a_target_is_that_which_resembles_it(tmp_path: Path, capsys) -> None:
    joint = 'def PhysicsFixedJoint "j"\n{\n    rel physics:body0 = </arm/bse>\n}\n'
    before = HEAD + SCOPE.format(BODY.format("base", "") + joint)
    after = fixed(tmp_path / "a.usda", before, "TOP031", capsys)

    assert after == before.replace("bse", "base")
    read = stage(after)
    (target,) = read.GetPrimAtPath("/arm/j").GetRelationship("physics:body0").GetTargets()
    assert str(target) == "/arm/base"
