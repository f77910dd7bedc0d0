"""What GitHub's runner makes of lines in the format `concise`, by the matcher that we offer."""

import json
import re

import pytest
from ci_robots import AXIS, BAD, GOOD
from workflow import ROOT

from kinlint.cli.main import main

MATCHERS = json.loads((ROOT / ".github/kinlint-problem-matcher.json").read_text("utf-8"))
NAMES = ("a robot.urdf", "a:7:1: error: b.urdf", "[x] (1).urdf", "ünï.urdf")


def matched(line):
    """What the first matcher that fits says of *line*; as IssueMatcher.cs of the runner does."""
    for matcher in MATCHERS["problemMatcher"]:
        (pattern,) = matcher["pattern"]
        if found := re.search(pattern["regexp"], line, re.ASCII):
            keys = ("file", "line", "column", "severity", "message", "code")
            said = {key: found[pattern[key]] for key in keys if key in pattern}
            return {"severity": matcher.get("severity", "error"), **said}
    return None


@pytest.fixture
def lint(tmp_path, rules_cache, monkeypatch, capsys):
    """The lines of a run, and the findings as objects."""
    monkeypatch.chdir(tmp_path)

    def run(files, *options):
        for name, text in files.items():
            (tmp_path / name).write_text(text, "utf-8")
        made = []
        for form in ("concise", "json"):
            main([*files, *options, "--output-format", form, "-q", "--color", "never"])
            made.append(capsys.readouterr().out)
        return made[0].splitlines(), json.loads(made[1])

    return run


@pytest.mark.parametrize("name", [name for name in NAMES if ":7:" not in name])
def test_each_line_is_an_issue_at_its_place(lint, name):
    """Whatever brackets and colons a message has."""
    lines, objects = lint({name: BAD}, "--info", "INE001", "--show", "info")
    assert len(lines) == len(objects) == 2
    for line, one in zip(lines, objects, strict=True):
        severity = {"info": "notice"}.get(one["severity"], one["severity"])
        assert matched(line) == {
            "severity": severity,
            "file": name,
            "line": str(one["location"]["row"]),
            "column": str(one["location"]["column"]),
            "message": matched(line)["message"],
            "code": one["code"],
        }
        assert one["message"] in line
        assert matched(line)["message"].endswith(one["message"])


def test_messages_keep_their_brackets_and_colons():
    """The code is the last bracket."""
    line = "a b.urdf:3:14: warning: [*!] Of '[x]: 1:2: error: y' [FRM007] is said: no. [SHACL001]"
    assert matched(line) == {
        "file": "a b.urdf",
        "line": "3",
        "column": "14",
        "severity": "warning",
        "message": "[*!] Of '[x]: 1:2: error: y' [FRM007] is said: no.",
        "code": "SHACL001",
    }
    info = matched("a.urdf:1:2: info: No [x]. [FRM028]")
    assert (info["severity"], info["message"], info["code"]) == ("notice", "No [x].", "FRM028")


def test_a_file_that_cannot_be_read_is_an_error(lint):
    """It has no code."""
    lines, _ = lint({"arm.urdf": '<!DOCTYPE robot [<!ENTITY a "b">]><robot name="&a;"/>'})
    (line,) = lines
    assert matched(line)["severity"] == "error"
    assert matched(line)["code"] is None
    assert "document type" in matched(line)["message"]


def test_nothing_else_is_an_issue(lint):
    """Neither the summary nor a clean run."""
    lines, _ = lint({"arm.urdf": GOOD, "axis.urdf": AXIS}, "--select", "INE003")
    assert lines == []
    for line in ("Found 2 errors in 1 of 3 files.", "All checks passed in 3 files.", ""):
        assert matched(line) is None
