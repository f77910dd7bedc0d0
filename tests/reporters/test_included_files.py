"""A finding in a file that another one includes is shown in that file, by every reporter."""

from __future__ import annotations

import io
import json
from pathlib import Path

import pytest
from support.linting import lint

from kinlint.report import Report
from kinlint.reporters import reporter_registry

ROBOT = """<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="parts/link.xacro"/>
  <xacro:piece name="base"/>
</robot>
"""
LINK = """<?xml version="1.0" encoding="ISO-8859-1"?>
<robot xmlns:xacro="http://www.ros.org/wiki/xacro"> <!-- Größe -->
  <xacro:macro name="piece" params="name">
    <link name="${name}">
      <inertial>
        <mass value="-1"/>
        <inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="2"/>
      </inertial>
    </link>
  </xacro:macro>
</robot>
"""
INCLUDED = "parts/link.xacro"


@pytest.fixture
def found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Report:
    """What kinlint finds in a robot whose one link is written in an included file."""
    monkeypatch.chdir(tmp_path)
    Path("parts").mkdir()
    Path(INCLUDED).write_bytes(LINK.encode("iso-8859-1"))
    report = lint(ROBOT, "robot.urdf.xacro")
    assert [each.rule.code for each in report.findings] == ["INE003"]
    return report


def text(report: Report, form: str) -> str:
    stream = io.StringIO()
    reporter_registry.write(report, form, stream)
    return stream.getvalue()


@pytest.mark.parametrize("form", ["full", "concise", "json", "json-lines", "github", "sarif"])
def test_the_path_of_the_included_file_is_shown(found: Report, form: str) -> None:
    shown = text(found, form)
    assert INCLUDED in shown
    assert str(Path.cwd() / INCLUDED) in shown or f"/{INCLUDED}" not in shown


def test_the_excerpt_is_of_the_included_file(found: Report) -> None:
    assert '6 |         <mass value="-1"/>' in text(found, "full")


def test_sarif_shows_the_included_file(found: Report) -> None:
    (only,) = json.loads(text(found, "sarif"))["runs"]
    place = only["results"][0]["locations"][0]["physicalLocation"]
    assert place["artifactLocation"]["uri"].endswith(INCLUDED)
    assert place["region"]["snippet"] == {"text": "-1"}
    assert '<mass value="-1"/>' in place["contextRegion"]["snippet"]["text"]
