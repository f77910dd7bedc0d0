"""The command that writes composable models."""

from __future__ import annotations

import io
import json
from pathlib import Path

import pytest

from kinlint.cli.main import main

SAMPLES = Path(__file__).resolve().parents[2] / "samples"
ROBOT = """<robot name="two parts"><material name="red"/><link name="a"/><link name="b"/>
<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint></robot>"""
SEMANTIC = """<robot name="two parts"><group name="all"><joint name="j"/></group></robot>"""


@pytest.fixture
def robot(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "robot.urdf").write_text(ROBOT, encoding="utf-8")
    return tmp_path


def convert(capsys, *arguments: str) -> tuple[int, str, str]:
    code = main(["convert", *arguments])
    out, err = capsys.readouterr()
    return code, out, err


def test_to_standard_output(robot, capsys):
    code, out, err = convert(capsys, "robot.urdf")
    said = json.loads(out)
    assert code == 0
    assert said["@context"][-1] == {"robot": "https://example.org/two%20parts#"}
    assert said["@id"] == "robot:model"
    assert {"robot:link/a", "robot:joint/j", "robot:chain"} < {
        node["@id"] for node in said["@graph"]
    }
    assert err == (
        "kinlint: left out: 1 'robot/material': how a body looks says nothing about where it is, "
        "how it moves or what it weighs\n"
    )
    assert convert(capsys, "robot.urdf", "-o", "-", "-q") == (0, out, "")


@pytest.mark.slow
def test_to_a_file_that_kinlint_finds_nothing_wrong_with(tmp_path, capsys):
    for name in ("six-axis", "gripper"):
        target = tmp_path / f"{name}.jsonld"
        assert convert(capsys, str(SAMPLES / "urdf" / f"{name}.urdf"), "-o", str(target)) == (
            0,
            "",
            "",
        )
        assert main([str(target), "--isolated", "--fail-on", "info"]) == 0
        assert capsys.readouterr().out == "All checks passed in 1 file.\n"


def test_from_standard_input(robot, capsys, monkeypatch):
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(ROBOT.encode())))
    assert convert(capsys, "-", "-q")[1] == convert(capsys, "robot.urdf", "-q")[1]


def test_namespace(robot, capsys):
    _, out, _ = convert(capsys, "robot.urdf", "--namespace", "https://acme.example/arm#")
    assert json.loads(out)["@context"][-1] == {"robot": "https://acme.example/arm#"}


@pytest.mark.parametrize(
    "wrong", ["arm", "https://acme.example/arm", "https://acme.example/<>#", ""]
)
def test_namespace_that_is_none(robot, capsys, wrong):
    code, _, err = convert(capsys, "robot.urdf", "--namespace", wrong)
    assert code == 2
    assert "--namespace: expected an IRI that ends with # or /" in err


@pytest.mark.parametrize(
    ("arguments", "beginning"),
    [
        (["-o", "robot.ttl"], "@prefix"),
        (["-o", "robot.nt"], "<https://example.org/two%20parts#link/a>"),
        (["-o", "robot.txt", "--to", "ntriples"], "<https://"),
        (["-o", "robot.json"], "{"),
        (["-o", "robot.TTL", "--to", "jsonld"], "{"),
    ],
)
def test_formats(robot, capsys, arguments, beginning):
    assert convert(capsys, "robot.urdf", "-q", *arguments) == (0, "", "")
    assert (robot / arguments[1]).read_text(encoding="utf-8").startswith(beginning)


@pytest.mark.slow
@pytest.mark.parametrize("there", [True, False])
@pytest.mark.parametrize(("name", "form"), [("parts", "jsonld"), ("parts.d/", "turtle")])
def test_to_a_directory(robot, capsys, name, form, there):
    if there:
        (robot / name).mkdir()
    arm = str(SAMPLES / "urdf" / "gripper.urdf")
    assert convert(capsys, arm, "-o", name, "--to", form) == (0, "", "")
    assert {path.stem for path in (robot / name).iterdir()} == {
        *("skeleton", "spatial-relations", "coordinates", "kinematic-chain"),
        *("dynamics", "actuation", "shapes"),
    }
    assert main([f"{name}/*", "--isolated", "--fail-on", "info"]) == 0
    assert capsys.readouterr().out == "All checks passed in 7 files.\n"


@pytest.mark.slow
def test_parts_are_the_whole(robot, capsys):
    arm = str(SAMPLES / "urdf" / "six-axis.urdf")
    whole = json.loads(convert(capsys, arm)[1])
    convert(capsys, arm, "-o", "parts")
    parts = [json.loads(path.read_text()) for path in sorted((robot / "parts").iterdir())]
    assert [part["@id"] for part in parts] == [
        "robot:" + path.stem for path in sorted((robot / "parts").iterdir())
    ]
    nodes = [node for part in parts for node in part["@graph"]]
    assert len(nodes) == len(whole["@graph"])
    assert all(node in whole["@graph"] for node in nodes)
    contexts = {one for part in parts for one in part["@context"][:-1]}
    assert contexts == set(whole["@context"][:-1])


def test_a_directory_that_cannot_be_made(robot, capsys):
    code, _, err = convert(capsys, "robot.urdf", "-o", "no/where/")
    assert code == 2
    assert "cannot make directory no/where" in err


@pytest.mark.parametrize(
    ("option", "key"),
    [
        ((), "direction-cosine-x"),
        (("--rotation", "euler-angles"), "axes-sequence"),
        (("--rotation", "quaternion"), "qw"),
    ],
)
def test_rotation(robot, capsys, option, key):
    text = ROBOT.replace("<child", '<origin xyz="1 0 0" rpy="0 0 0.5"/><child')
    (robot / "robot.urdf").write_text(text, encoding="utf-8")
    nodes = {
        node["@id"]: node
        for node in json.loads(convert(capsys, "robot.urdf", "-q", *option)[1])["@graph"]
    }
    assert key in nodes["robot:joint/j/pose/coordinates"]
    assert nodes["robot:joint/j/pose/coordinates"]["x"] == 1.0


MINIMAL = """<robot name="r"><link name="a"><inertial><origin xyz="0 0 0.1"/><mass value="2"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial><visual name="v">
<origin xyz="0 0 0"/><geometry><mesh filename="package://p/v.stl"/></geometry></visual>
<visual name="w"><origin xyz="0 1 0"/><geometry><sphere radius="1"/></geometry></visual></link>
<link name="b"/><joint name="j" type="revolute"><parent link="a"/><child link="b"/>
<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="2" velocity="3"/></joint></robot>"""


def test_nothing_is_said_twice(robot, capsys):
    (robot / "robot.urdf").write_text(MINIMAL, encoding="utf-8")
    graph = json.loads(convert(capsys, "robot.urdf", "-q")[1])["@graph"]
    nodes = {node["@id"].removeprefix("robot:"): node for node in graph}
    assert nodes["link/a/visual/v"]["attached-to"] == "robot:link/a/frame"
    assert "scale" not in nodes["link/a/visual/v"]
    assert nodes["link/a/visual/w"]["attached-to"] == "robot:link/a/visual/w/frame"
    assert nodes["joint/j"]["between-attachments"] == ["robot:link/a/frame", "robot:link/b/frame"]
    assert nodes["joint/j"]["positive-direction"] == "robot:link/a/frame/z"
    assert nodes["joint/j/common-axis"]["lines"] == ["robot:link/a/frame/z", "robot:link/b/frame/z"]
    assert "vector-x" not in nodes["link/a/frame"]
    assert set(nodes["link/a/inertia/coordinates"]["unit"]) == {"KiloGM", "M-KiloGM", "KiloGM-M2"}
    assert nodes["link/a/centre-of-mass/position/coordinates"]["z"] == 0.1
    assert (nodes["joint/j/force-limit"]["lower"], nodes["joint/j/force-limit"]["upper"]) == (-2, 2)
    assert nodes["joint/j/velocity-limit"]["lower"] == -3


def test_srdf_with_its_urdf(robot, capsys):
    (robot / "robot.srdf").write_text(SEMANTIC, encoding="utf-8")
    code, out, err = convert(capsys, "robot.srdf", "robot.urdf")
    assert code == 0
    assert "robot:joint/j" in out
    assert "1 'robot/group'" in err


def test_sdf(robot, capsys):
    (robot / "model.sdf").write_text(
        '<sdf version="1.9"><model name="box"><link name="a"/></model></sdf>', encoding="utf-8"
    )
    code, out, _ = convert(capsys, "model.sdf")
    assert code == 0
    assert json.loads(out)["@context"][-1] == {"robot": "https://example.org/box#"}


def test_xacro(robot, capsys):
    (robot / "robot.urdf.xacro").write_text(
        """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
        <xacro:arg name="n" default="a"/>
        <link name="$(arg n)"/></robot>""",
        encoding="utf-8",
    )
    assert "robot:link/a" in convert(capsys, "robot.urdf.xacro")[1]
    assert "robot:link/b" in convert(capsys, "robot.urdf.xacro", "--xacro-arg", "n:=b")[1]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([], "name the file of a robot to convert"),
        (["absent.urdf"], "absent.urdf"),
        (
            ["robot.urdf", "-o", "robot.sdf"],
            "-o robot.sdf: a model is written as .jsonld (jsonld), ",
        ),
        (["robot.urdf", "-o", "robot.urdf", "--to", "jsonld"], "is read in this run, and would be"),
        (["robot.urdf", "-o", "nowhere/robot.jsonld"], "cannot write nowhere/robot.jsonld"),
        (["robot.urdf", "--to", "usd"], "--to"),
        (["model.jsonld"], "model.jsonld: composable already, nothing to convert"),
        (["empty.urdf"], "empty.urdf: no links and joints, nothing to convert"),
        (["robot.urdf", "same.urdf"], "two files both describe"),
        (["robot.urdf", "--nonsense"], "unknown option '--nonsense'"),
    ],
)
def test_what_cannot_be(robot, capsys, arguments, message):
    (robot / "model.jsonld").write_text('{"@context": {"@vocab": "urn:x:"}}', encoding="utf-8")
    (robot / "empty.urdf").write_text('<robot name="nothing"/>', encoding="utf-8")
    (robot / "same.urdf").write_text(ROBOT, encoding="utf-8")
    before = sorted(path.name for path in robot.iterdir())
    code, out, err = convert(capsys, *arguments)
    assert (code, out) == (2, "")
    assert message in err
    assert sorted(path.name for path in robot.iterdir()) == before


def test_a_file_is_replaced_as_a_whole(robot, capsys):
    target = robot / "robot.jsonld"
    target.write_text("what was before", encoding="utf-8")
    target.chmod(0o640)
    assert convert(capsys, "robot.urdf", "-q", "-o", "robot.jsonld")[0] == 0
    assert json.loads(target.read_text(encoding="utf-8"))
    assert target.stat().st_mode & 0o777 == 0o640
    assert [path.name for path in robot.iterdir() if path.name.startswith(".")] == []


def test_help(capsys):
    code, out, _ = convert(capsys, "--help")
    assert code == 0
    assert "--namespace" in out
