"""Directories are searched for robots in COLLADA and USD by content; meshes are passed over."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from kinlint.project.discovery import Search

BODY = 'def Xform "{}" (\n    prepend apiSchemas = ["PhysicsRigidBodyAPI"]\n)\n{{\n}}\n'
FILES = {
    "body.usda": "#usda 1.0\n" + BODY.format("base"),
    "mesh.usda": '#usda 1.0\ndef Mesh "m" (\n apiSchemas = ["PhysicsCollisionAPI"]\n)\n{\n}\n',
    "schema.usda": '#usda 1.0\nclass "PhysicsRigidBodyAPI"\n{\n}\nclass "PhysicsJoint"\n{\n}\n',
    "cell/scene.usda": '#usda 1.0\ndef "w" (\n payload = @./parts/arm.usd@\n)\n{\n}\n',
    "cell/parts/arm.usd": "#usda 1.0\n(\n subLayers = [@joints.usda@]\n)\n",
    "cell/parts/joints.usda": '#usda 1.0\ndef PhysicsFixedJoint "j"\n{\n}\n',
    "loop/a.usda": "#usda 1.0\n(\n subLayers = [@b.usda@]\n)\n" + BODY.format("a"),
    "loop/b.usda": "#usda 1.0\n(\n subLayers = [@a.usda@]\n)\n",
    "crate.usd": "PXR-USDC tokens",
    "arm.dae": '<COLLADA>\n<library_kinematics_models><kinematics_model id="k"/>',
    "mesh.dae": "<COLLADA>\n<library_physics_models/><library_geometries/>",
    "box.dae": "<c:COLLADA><c:rigid_body sid='b'>",
}


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    for name, text in FILES.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")
    return tmp_path


def found(*paths: Path) -> list[str]:
    return [each.name for each in Search(lambda _: ()).find([*map(str, paths)]).inputs]


def test_robots_are_told_from_meshes(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tree)
    assert sorted(found(tree)) == [
        "arm.dae", "body.usda", "box.dae", "cell/scene.usda", "loop/a.usda", "loop/b.usda",
    ]  # fmt: skip


def test_what_is_named_is_read_whatever_it_has(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tree)
    assert found(tree / "mesh.dae", tree / "mesh.usda") == ["mesh.dae", "mesh.usda"]
    assert sorted(found(Path("*.dae"))) == ["arm.dae", "box.dae", "mesh.dae"]


def test_pipes_do_not_stop_a_search(tree: Path) -> None:
    os.mkfifo(tree / "pipe.usda")
    os.mkfifo(tree / "pipe.dae")
    assert len(found(tree)) == 8
