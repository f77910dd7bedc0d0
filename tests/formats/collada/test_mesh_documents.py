"""Meshes in COLLADA that robots name are read once each, and are judged where they are named."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.linting import lint

from kinlint.formats.collada import mesh_documents
from kinlint.formats.registry import decode

MESH = (
    '<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">\n'
    "<asset>{asset}</asset>\n"
    '<library_geometries><geometry id="g"><mesh><source id="s">\n'
    '<float_array id="a" count="{count}">1 2 3</float_array>\n'
    '<technique_common><accessor source="#{target}" count="1" stride="3"/></technique_common>'
    "</source></mesh></geometry></library_geometries></COLLADA>"
)
ASSET = '<unit meter="1"/><up_axis>Z_UP</up_axis>'
SOUND = MESH.format(asset=ASSET, count=3, target="a")
URDF = '<visual><geometry><mesh filename="meshes/part.dae"/></geometry></visual>'
SDF = '<visual name="v"><geometry><mesh><uri>meshes/part.dae</uri></mesh></geometry></visual>'


def messages(folder: Path, mesh: str, suffix: str = ".urdf", links: int = 3) -> list[str]:
    """The messages about *mesh*, which each of some links of a robot in *folder* names."""
    (folder / "meshes").mkdir(exist_ok=True)
    (folder / "meshes" / "part.dae").write_text(mesh, "utf-8")
    inside = URDF if suffix == ".urdf" else SDF
    parts = "".join(f'<link name="l{each}">{inside}</link>\n' for each in range(links))
    text = f'<robot name="r">\n{parts}</robot>'
    if suffix == ".sdf":
        text = f'<sdf version="1.9"><model name="r">\n{parts}</model></sdf>'
    robot = folder / f"robot{suffix}"
    robot.write_text(text, "utf-8")
    report = lint([decode(str(robot), robot.read_bytes())])
    found = [each for each in report.findings if each.rule.code == "GEO012"]
    assert {each.location.start.line for each in found} <= {2}
    return [each.message for each in found]


@pytest.mark.parametrize("suffix", [".urdf", ".sdf"])
@pytest.mark.parametrize(
    ("mesh", "message"),
    [
        (MESH.format(asset=ASSET, count=3, target="b"), "Line 5 of 'part.dae' refers to '#b'"),
        (MESH.format(asset=ASSET, count=4, target="a"), "Line 4 of 'part.dae' has a wrong count"),
        (SOUND.replace('id="s"', 'id="g"'), "Line 3 of 'part.dae' has a wrong second id: 'g'"),
        (SOUND.replace('meter="1"', 'meter="0.01"'), "The unit of 'part.dae' is 0.01 m"),
        (SOUND.replace("Z_UP", "Y_UP"), "z does not point up in 'part.dae'"),
        (SOUND.replace("</COLLADA>", "</x>"), "'part.dae' cannot be read"),
        ("<!DOCTYPE a [<!ENTITY b 'c'>]><COLLADA/>", "'part.dae' cannot be read"),
    ],
)
def test_a_mesh_that_all_links_name_is_one_finding(
    tmp_path: Path, mesh: str, message: str, suffix: str
) -> None:
    (found,) = messages(tmp_path, mesh, suffix)
    assert found.startswith(message)


@pytest.mark.parametrize("mesh", [SOUND, '<robot name="no mesh"/>'])
def test_sound_meshes_and_other_files_are_silent(tmp_path: Path, mesh: str) -> None:
    assert messages(tmp_path, mesh) == []


def test_a_mesh_is_read_once_until_it_changes(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened = []
    contents = mesh_documents.contents
    monkeypatch.setattr(
        mesh_documents, "contents", lambda *args: opened.append(args[0]) or contents(*args)
    )
    broken = SOUND.replace("#a", "#bb")
    assert messages(tmp_path, SOUND) == []
    assert messages(tmp_path, SOUND) == []
    assert len(messages(tmp_path, broken)) == 1
    assert 2 <= len(opened) <= 3


def test_large_meshes_are_passed_over(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(mesh_documents, "LARGEST", 100)
    assert messages(tmp_path, SOUND.replace("Z_UP", "X_UP")) == []
