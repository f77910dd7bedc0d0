"""Targets by files: those of the nearest configuration, and of globs in it."""

import json

import pytest

from kinlint.cli.main import main

HAND = """<robot name="hand">
  <link name="palm"/><link name="left"/><link name="right"/>
  <joint name="a" type="continuous"><parent link="palm"/><child link="left"/>
    <axis xyz="0 0 1"/></joint>
  <joint name="b" type="continuous"><parent link="palm"/><child link="right"/>
    <axis xyz="0 0 1"/><mimic joint="a"/></joint>
</robot>
"""
CONFIG = """target = ["drake"]
[per-file-target]
"sim/*.urdf" = ["mujoco@3.3"]
"""


@pytest.fixture
def told(tmp_path, monkeypatch, capsys):
    """The files in which POR003 speaks, with options."""
    (tmp_path / "kinlint.toml").write_text(CONFIG, "utf-8")
    for name in ("sim/hand.urdf", "real/hand.urdf"):
        (tmp_path / name).parent.mkdir()
        (tmp_path / name).write_text(HAND, "utf-8")
    monkeypatch.chdir(tmp_path)

    def run(*options):
        main(["--select", "POR003", "--output-format", "json", *options, "."])
        return [each["filename"] for each in json.loads(capsys.readouterr().out)]

    return run


def test_a_glob_adds_targets(told):
    """To those of the configuration."""
    assert [name.replace("\\", "/").split("/")[-2] for name in told()] == ["sim"]


@pytest.mark.slow
def test_the_command_line_wins(told):
    """It replaces the targets of all files."""
    assert told("--target", "drake") == []
    assert len(told("--target", "kdl")) == 2


def test_an_unknown_name_in_a_glob_is_an_error(told, tmp_path, capsys):
    """With a suggestion, before anything is read."""
    (tmp_path / "kinlint.toml").write_text('[per-file-target]\n"*/*.urdf" = ["drak"]', "utf-8")
    assert main(["."]) == 2
    assert "unknown target 'drak', did you mean 'drake'?" in capsys.readouterr().err
