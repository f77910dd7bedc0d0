"""Arguments and packages for xacro files, by options and by configuration."""

import json
from pathlib import Path

import pytest

from kinlint.cli.main import main

XMLNS = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
ARM = f"""<robot name="arm" {XMLNS}>
<xacro:include filename="$(find hand_description)/hand.xacro"/>
<link name="$(arg prefix)base"/>
<link name="$(arg prefix)base"/>
</robot>"""
HAND = f'<robot name="hand" {XMLNS}>\n<lnik/></robot>'


@pytest.fixture
def cell(tmp_path):
    """A cell with an arm, whose hand lies in a package that nobody finds by itself."""
    hand = tmp_path / "lib" / "hands" / "one" / "two"
    hand.mkdir(parents=True)
    (hand / "hand.xacro").write_text(HAND)
    (tmp_path / "arm.xacro").write_text(ARM)
    (tmp_path / "kinlint.toml").write_text("")
    return tmp_path


def run(capfd, *arguments):
    code = main(
        ["--output-format", "concise", "--show", "info", "-q", "--select", "SRC,ID", *arguments]
    )
    out, err = capfd.readouterr()
    return code, [line.split(" ")[0] for line in out.splitlines()], err


def codes(capfd, *arguments):
    main(["--output-format", "concise", "--show", "info", "-q", "--select", "SRC,ID", *arguments])
    return {line[-7:-1] for line in capfd.readouterr().out.splitlines()}


def test_a_missing_package_and_a_missing_argument_are_told(cell, capfd):
    assert codes(capfd, "arm.xacro") == {"SRC013", "SRC014"}
    told = ["--package", "hand_description=lib/hands/one/two"]
    assert codes(capfd, "arm.xacro", *told) == {"SRC013"}


def test_options(cell, capfd):
    code, places, _ = run(
        capfd,
        "arm.xacro",
        "--package",
        "hand_description=lib/hands/one/two",
        "--xacro-arg",
        "prefix:=left_",
    )
    assert code == 1
    assert "lib/hands/one/two/hand.xacro:2:2:" in places
    assert any(place.startswith("arm.xacro:4:") for place in places)


@pytest.mark.slow
def test_configuration(cell, capfd):
    (cell / "kinlint.toml").write_text(
        'packages = { hand_description = "lib/hands/one/two" }\n'
        "[xacro-args]\n"
        "prefix = 1\n"
        "other = true\n"
        '"*.urdf.xacro" = { prefix = "other_" }\n'
    )
    main(["--output-format", "concise", "--show", "info", "-q", "--select", "ID", "arm.xacro"])
    assert "1base" in capfd.readouterr().out
    (cell / "arm.urdf.xacro").write_text(ARM)
    main(["--output-format", "concise", "--show", "info", "-q", "--select", "ID", "arm.urdf.xacro"])
    assert "other_base" in capfd.readouterr().out
    told = ["--xacro-arg", "prefix:=x_"]
    main(
        ["--output-format", "concise", "--show", "info", "-q", "--select", "ID", "arm.xacro", *told]
    )
    assert "x_base" in capfd.readouterr().out
    main(["--show-settings", "arm.xacro"])
    shown = capfd.readouterr().out
    assert "xacro-arg other = true" in shown
    assert "package hand_description = lib/hands/one/two" in shown


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        (["--xacro-arg", "a"], "--xacro-arg: expected NAME:=VALUE, got 'a'"),
        (["--xacro-arg", ":=1"], "--xacro-arg: expected NAME:=VALUE, got ':=1'"),
        (["--package", "a"], "--package: expected NAME=DIR, got 'a'"),
        (["--package", "a=nowhere"], "--package 'a=nowhere': no such file or directory"),
        (["--package", "a=arm.xacro"], "--package 'a=arm.xacro': not a directory"),
        (["--config", "xacro-args=1"], "--config: xacro-args: expected a table, got a number 1"),
        (
            ["--config", "xacro-args={a=[1]}"],
            "--config: xacro-args: 'a': expected a string or number, got a list",
        ),
    ],
)
def test_mistakes(cell, capfd, arguments, expected):
    code, _, err = run(capfd, "arm.xacro", *arguments)
    assert (code, err) == (2, f"kinlint: error: {expected}\n")


def test_what_several_files_include_is_told_once(cell, capfd):
    include = '<xacro:include filename="part.xacro"/>'
    for name in ("one", "two"):
        text = f'<robot name="{name}" {XMLNS}>\n{include}<link name="base"/></robot>'
        (cell / f"{name}.xacro").write_text(text)
    (cell / "part.xacro").write_text(
        f'<robot name="part" {XMLNS}>\n<link name="a"><lnik/></link></robot>'
    )
    _, places, _ = run(capfd, "one.xacro", "two.xacro", "part.xacro")
    assert [place for place in places if place.startswith("part")] == ["part.xacro:2:17:"]
    (cell / "part.xacro").write_text(
        f'<!-- kinlint: file-ignore[SRC003] -->\n<robot name="part" {XMLNS}>\n'
        '<link name="a"><lnik/></link></robot>'
    )
    _, places, _ = run(capfd, "one.xacro")
    assert places == []
    geoms = '<geom name="a" size="1"/>\n<geom name="a" size="1"/>'
    (cell / "arm.xml").write_text(f"<mujoco><worldbody>{geoms}</worldbody></mujoco>")
    (cell / "scene.xml").write_text('<mujoco><include file="arm.xml"/></mujoco>')
    _, places, _ = run(capfd, "arm.xml", "scene.xml")
    assert places == ["arm.xml:2:13:"]


def test_failures_inside_what_others_include_are_theirs(cell, capfd):
    (cell / "part.xacro").write_text(
        f'<robot name="part" {XMLNS}>\n<link name="${{side}}_a"/></robot>'
    )
    (cell / "one.xacro").write_text(
        f'<robot name="one" {XMLNS}><xacro:property name="side" value="left"/>'
        '<xacro:include filename="part.xacro"/></robot>'
    )
    assert codes(capfd, "part.xacro") == {"SRC018"}
    assert codes(capfd, "part.xacro", "one.xacro") == set()


HAND_IS = "hand_description{}lib/hands/one/two"


@pytest.mark.parametrize("sign", ["=", ":="])
def test_either_sign(cell, capfd, sign):
    """`=` as kinlint writes packages, `:=` as xacro writes arguments."""
    told = ["--package", HAND_IS.format(sign), "--xacro-arg", f"prefix{sign}left_"]
    _, places, _ = run(capfd, "arm.xacro", *told)
    assert any(place.startswith("arm.xacro:4:") for place in places)


@pytest.mark.slow
def test_arguments_as_xacro_takes_them(cell, capfd):
    """Among the paths, in any place; a value may be empty or have more signs."""
    told = ["--package", HAND_IS.format("=")]
    for words in (["arm.xacro", "prefix:=a:=b="], ["prefix:=a:=b=", "arm.xacro"]):
        main(["--output-format", "concise", "-q", "--select", "ID", *words, *told])
        assert "'a:=b=base'" in capfd.readouterr().out
    assert main(["arm.xacro", "prefix=left_"]) == 2
    assert "an argument for xacro is written prefix:=left_" in "".join(capfd.readouterr())
    main(["--output-format", "concise", "-q", "--select", "ID", "arm.xacro", "prefix:=", *told])
    assert "'base'" in capfd.readouterr().out
    main(["graph", "arm.xacro", "prefix:=left_", *told])
    assert "left_base" in capfd.readouterr().out


@pytest.mark.slow
def test_an_argument_that_no_file_takes(cell, capfd):
    """It is told; a slip ends with 2, also of commands that draw; included files are known."""
    (cell / "kinlint.toml").write_text('packages = { hand_description = "lib/hands/one/two" }')
    hand = cell / "lib" / "hands" / "one" / "two" / "hand.xacro"
    hand.write_text(f'<robot {XMLNS}><xacro:arg name="gripper" default=""/></robot>')

    def told(*words):
        main(["--output-format", "concise", "--select", "ID", "arm.xacro", *words])
        return capfd.readouterr().err

    assert told("prefix:=a", "gripper:=b") == ""
    unknown = "no xacro file of this run has an argument"
    slip = f"{unknown} 'prefx', did you mean 'prefix'?\n"
    for command in (("graph",), ("convert",)):
        assert main([*command, "arm.xacro", "prefx:=a"]) == 2
        assert capfd.readouterr().err.endswith(f"kinlint: error: {slip}")
    reports = ("--output", "concise", "--output", "sarif=a.sarif", "--sarif-invocation")
    assert main(["arm.xacro", "prefx:=a", "-q", *reports]) == 2
    assert f"prefx:=a:1:1: error: {slip}" in capfd.readouterr().out
    assert json.loads(Path("a.sarif").read_text())["runs"][0]["invocations"][0]["exitCode"] == 2
    assert told("prefix:=a", "size:=2") == f"kinlint: warning: {unknown} 'size'\n"
    hand.unlink()
    assert told("prefix:=a", "size:=2") == ""
