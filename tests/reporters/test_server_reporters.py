"""What GitLab, Azure and the readers of JUnit's and Checkstyle's XML get."""

from __future__ import annotations

import json
import re
from collections import Counter
from dataclasses import replace
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import jsonschema
import pytest
from hypothesis import given
from junitparser import Error, Failure, JUnitXml
from reported import (
    BOTH,
    DYNAMICS,
    PLAIN,
    UNIT_FINDING,
    at,
    edit,
    fix,
    here,
    report,
    reports,
    unit_finding,
)

from kinlint.errors import SourceError
from kinlint.report import Report
from kinlint.reporters import azure, checkstyle, gitlab, grouped, junit
from kinlint.reporters.terminal_style import Style
from kinlint.rule import Severity

ASCII = Style(unicode=False)
ERRORS = (SourceError("gone, [b]; 5%.urdf", "no <such>\x00 file", 3, 4), SourceError("-", "no"))
CONTROLS = "a\x00\x1b[0m\x7f\x9f\ufffe\uffff\ud800 ]]> <&\"'\n\t\r😀"
INFO = unit_finding(at(DYNAMICS, '"M"'), severity=Severity.INFO)


def text(reporter: Any, made: Report, style: Style = PLAIN) -> str:
    written = "".join(reporter.render(made, style))
    assert written == "" or written.endswith("\n")
    return written


# GitLab: docs.gitlab.com, "Code Quality report format".

ISSUE = {
    "type": "object",
    "additionalProperties": False,
    "required": ["description", "check_name", "fingerprint", "severity", "location"],
    "properties": {
        "description": {"type": "string", "minLength": 1},
        "check_name": {"type": "string", "minLength": 1},
        "fingerprint": {"type": "string", "pattern": "^[0-9a-f]{32}$"},
        "severity": {"enum": ["info", "minor", "major", "critical", "blocker"]},
        "location": {
            "type": "object",
            "additionalProperties": False,
            "required": ["path", "lines"],
            "properties": {
                "path": {"type": "string", "minLength": 1, "pattern": r"^(?!\./)"},
                "lines": {
                    "type": "object",
                    "additionalProperties": False,
                    "required": ["begin"],
                    "properties": {
                        "begin": {"type": "integer", "minimum": 1},
                        "end": {"type": "integer", "minimum": 1},
                    },
                },
            },
        },
    },
}


def issues(made: Report, style: Style = PLAIN) -> list[dict[str, Any]]:
    said = json.loads(text(gitlab, made, style))
    jsonschema.validate(said, {"type": "array", "items": ISSUE})
    assert len({one["fingerprint"] for one in said}) == len(said)
    return said


def test_gitlab_is_told_what_and_where() -> None:
    first, second = issues(BOTH)
    assert first | {"fingerprint": ""} == {
        "description": BOTH.findings[0].message,
        "check_name": "INE007",
        "fingerprint": "",
        "severity": "major",
        "location": {"path": "models/dynamics.jsonld", "lines": {"begin": 7, "end": 7}},
    }
    assert second["severity"] == "minor"
    assert issues(report(INFO))[0]["severity"] == "info"
    assert issues(Report()) == []


def test_gitlab_is_told_of_what_cannot_be_read() -> None:
    first, second = issues(report(errors=ERRORS))
    assert (first["check_name"], first["severity"]) == ("kinlint", "major")
    assert first["location"] == {"path": ERRORS[0].name, "lines": {"begin": 3}}
    assert second["location"] == {"path": "-", "lines": {"begin": 1}}


def test_fingerprints_outlive_moves_within_a_file() -> None:
    """And do not depend on what other files say, nor on fixes."""
    moved = replace(UNIT_FINDING, location=here("x" * 9, 3, 4, DYNAMICS.name))
    other = replace(UNIT_FINDING, location=here("x", 0, 1, "another.jsonld"))
    mended = replace(UNIT_FINDING, fixes=(fix(edit(DYNAMICS, '"M"', '"N"')),))
    (own,) = issues(report(UNIT_FINDING))
    for made in (report(moved), report(mended), report(other, UNIT_FINDING)):
        assert issues(made)[-1]["fingerprint"] == own["fingerprint"]
    assert issues(report(replace(UNIT_FINDING, arguments=("N",))))[0] != own


def test_fingerprints_of_elements_do_not_depend_on_where_kinlint_runs(tmp_path: Path) -> None:
    (tmp_path / ".git").mkdir()
    element = "urn:kinlint:document:{}#/link/base"
    names = {"sub/a.urdf": tmp_path, "a.urdf": tmp_path / "sub"}
    told = [
        issues(report(unit_finding(here("x", 0, 1, name), iri=element.format(name)), root=str(at)))
        for name, at in names.items()
    ]
    assert told[0] == told[1]
    assert told[0][0]["location"]["path"] == "sub/a.urdf"


def test_equal_findings_have_fingerprints_of_their_own() -> None:
    assert len(issues(report(*[UNIT_FINDING] * 3))) == 3


# Paths


@pytest.mark.parametrize("reporter", [gitlab, junit, checkstyle, azure])
def test_paths_start_at_the_top_of_the_repository(reporter: Any, tmp_path: Path) -> None:
    """There servers look for them, wherever in it kinlint ran."""
    (tmp_path / ".git").mkdir()
    names = ("b.jsonld", "../up é/x.jsonld", str(tmp_path / "abs.jsonld"), "../../out.jsonld")
    found = [unit_finding(here("x", 0, 1, name)) for name in names]
    made = report(*found, root=str(tmp_path / "sub"))
    paths = {"sub/b.jsonld", "up é/x.jsonld", "abs.jsonld", f"{tmp_path.parent}/out.jsonld"}
    assert (
        paths
        == {
            gitlab: lambda: {one["location"]["path"] for one in issues(made)},
            junit: lambda: {suite.name for suite in suites(made)},
            checkstyle: lambda: set(files(made)),
            azure: lambda: {command["sourcepath"] for command, _ in commands(made)},
        }[reporter]()
    )


# JUnit, as junitparser reads it and as Jenkins' schema has it.

SUITE = {"name", "package", "tests", "failures", "errors", "skipped", "time"}


def suites(made: Report, style: Style = PLAIN) -> list[Any]:
    written = text(junit, made, style)
    root = ET.fromstring(written.encode())  # noqa: S314
    assert root.tag == "testsuites"
    totals = Counter[str]()
    for suite in root:
        assert (suite.tag, set(suite.attrib)) == ("testsuite", SUITE)
        own = Counter(tests=len(suite))
        for case in suite:
            assert case.tag == "testcase"
            assert {"name", "classname", "time", "file"} <= set(case.attrib)
            assert set(case.attrib) <= {"name", "classname", "time", "file", "line", "column"}
            assert [one.tag for one in case] in ([], ["failure"], ["error"], ["system-out"])
            for one in case.iterfind("*[@type]"):
                assert set(one.attrib) == {"type", "message"}
                own[f"{one.tag}s"] += 1
        for key in ("tests", "failures", "errors", "skipped"):
            assert int(suite.attrib[key]) == own[key]
        names = [(case.get("classname"), case.get("name")) for case in suite]
        assert len(set(names)) == len(names)
        totals += own
    for key in ("tests", "failures", "errors", "skipped"):
        assert int(root.attrib[key]) == totals[key]
    return list(JUnitXml.fromstring(written.encode()))


def test_a_finding_is_a_test_that_fails() -> None:
    (suite,) = suites(BOTH)
    assert (suite.name, suite.tests, suite.failures, suite.errors) == (
        "models/dynamics.jsonld", 2, 2, 0,
    )  # fmt: skip
    first, second = suite
    assert (first.name, first.classname) == ("org.kinlint.INE007", "models/dynamics.jsonld")
    (failure,) = first.result
    assert isinstance(failure, Failure)
    assert (failure.type, failure.message) == ("error", BOTH.findings[0].message)
    assert failure.text == f"models/dynamics.jsonld:7:21: {BOTH.findings[0].message}"
    assert second.result[0].type == "warning"


def test_failures_agree_with_the_exit_code() -> None:
    """What is below the threshold passes, and is the output of its test."""
    info = unit_finding(here("x", 0, 1), severity=Severity.INFO)
    for least, failures in ((Severity.INFO, 3), (Severity.WARNING, 2), (Severity.ERROR, 1)):
        made = report(*BOTH.findings, info, fails_from=least)
        assert sum(suite.failures for suite in suites(made)) == failures
    told = suites(report(info, fails_from=None))
    assert [(suite.failures, suite.tests) for suite in told] == [(0, 1)]
    assert "does not fit" in text(junit, report(info, fails_from=None))
    unparsable = replace(info, rule=replace(info.rule, unparsable=True))
    assert [(one.failures, one.errors) for one in suites(report(unparsable))] == [(0, 1)]


def test_a_clean_file_is_a_test_that_passes() -> None:
    names = ("models/dynamics.jsonld", "clean.urdf", "é.urdf")
    told = suites(replace(BOTH, files=names))
    assert [suite.name for suite in told] == list(names)
    for suite in told[1:]:
        (case,) = suite
        assert case.is_passed
    assert suites(Report()) == []


def test_a_file_that_cannot_be_read_is_a_test_that_cannot_run() -> None:
    told = suites(report(errors=ERRORS))
    assert [suite.name for suite in told] == [error.name for error in ERRORS]
    (case,) = told[0]
    (error,) = case.result
    assert isinstance(error, Error)
    assert error.message == "no <such>\\u0000 file"
    assert error.text.startswith("gone, [b]; 5%.urdf:3:4: no <such>")


def test_what_is_suppressed_fails_no_test() -> None:
    (suite,) = suites(report(replace(UNIT_FINDING, suppressed="a toy")))
    assert [case.is_passed for case in suite] == [True]


# Checkstyle, as its readers know it.


def files(made: Report, style: Style = PLAIN) -> dict[str, list[dict[str, str]]]:
    root = ET.fromstring(text(checkstyle, made, style).encode())  # noqa: S314
    assert (root.tag, set(root.attrib)) == ("checkstyle", {"version"})
    for file in root:
        assert (file.tag, set(file.attrib)) == ("file", {"name"})
        for error in file:
            assert error.tag == "error"
            assert set(error.attrib) == {"line", "column", "severity", "message", "source"}
            assert error.get("severity") in {"error", "warning", "info"}
            assert min(int(error.get("line", 0)), int(error.get("column", 0))) >= 1
    assert len({file.get("name") for file in root}) == len(root)
    return {str(file.get("name")): [dict(error.attrib) for error in file] for file in root}


def test_checkstyle_has_violations_by_file() -> None:
    ((name, errors),) = files(report(*BOTH.findings, INFO)).items()
    assert name == "models/dynamics.jsonld"
    assert [error["severity"] for error in errors] == ["error", "warning", "info"]
    assert errors[0] == {
        "line": "7",
        "column": "21",
        "severity": "error",
        "message": BOTH.findings[0].message,
        "source": "INE007",
    }
    assert files(Report()) == {}


def test_checkstyle_is_told_of_what_cannot_be_read() -> None:
    told = files(report(errors=ERRORS))
    (error,) = told[ERRORS[0].name]
    assert (error["severity"], error["line"], error["source"]) == ("error", "3", "kinlint")


@pytest.mark.parametrize("style", [PLAIN, ASCII])
def test_xml_takes_any_character(style: Style) -> None:
    """What XML 1.0 refuses is written as an escape."""
    finding = unit_finding(here("x", 0, 1, f"{CONTROLS}.urdf"), message=CONTROLS)
    made = report(finding, errors=(SourceError(CONTROLS, CONTROLS),))
    ((_, (error,)), _) = files(made, style).items()
    assert error["message"].startswith("a\\u0000\\u001b[0m")
    assert error["message"].endswith("\ufffd ]]> <&\"' 😀")
    (suite, _) = suites(made, style)
    assert suite.name.endswith("]]> <&\"'\n\t\r😀.urdf")
    if style is ASCII:
        assert text(junit, made, style).isascii()
        assert text(checkstyle, made, style).isascii()


# Azure: learn.microsoft.com, "Logging commands".

COMMAND = re.compile(r"##vso\[task\.logissue ((?:\w+=[^;\]]+;)+)\](.*)")


def commands(made: Report) -> list[tuple[dict[str, str], str]]:
    """The properties and the message of each command, as the agent reads them."""
    told = []
    for line in text(azure, made).split("\n")[:-1]:
        match = COMMAND.fullmatch(line)
        assert match is not None, line
        pairs = (pair.split("=", 1) for pair in match[1].split(";")[:-1])
        told.append(({key: unescaped(value) for key, value in pairs}, unescaped(match[2])))
    return told


def unescaped(said: str) -> str:
    for code, char in (("%3B", ";"), ("%0D", "\r"), ("%0A", "\n"), ("%5D", "]")):
        said = said.replace(code, char)
    return said.replace("%AZP25", "%")


def test_azure_is_told_what_and_where() -> None:
    assert commands(report(*BOTH.findings, INFO)) == [
        (
            {
                "type": "error",
                "sourcepath": "models/dynamics.jsonld",
                "linenumber": "7",
                "columnnumber": "21",
                "code": "INE007",
            },
            BOTH.findings[0].message,
        ),
        *[
            (
                {
                    "type": "warning",
                    "sourcepath": "models/dynamics.jsonld",
                    "linenumber": "8",
                    "columnnumber": "15",
                    "code": "UNI002",
                },
                "Unit 'M' does not fit.",
            )
        ]
        * 2,
    ]


def test_azure_gets_what_separates_as_escapes() -> None:
    finding = unit_finding(
        here("x", 0, 1, "a;b]c%3B,d:e.urdf"), message="100%; [x]\r\n##vso[task.complete]%0A%AZP25"
    )
    ((properties, message),) = commands(report(finding, errors=()))
    assert properties["sourcepath"] == "a;b]c%3B,d:e.urdf"
    assert message == finding.message


def test_azure_is_told_of_what_cannot_be_read() -> None:
    (first, second) = commands(report(errors=ERRORS))
    assert first[0]["sourcepath"] == ERRORS[0].name
    assert (first[0]["type"], first[0]["linenumber"]) == ("error", "3")
    assert second == ({"type": "error"}, "no")


# Grouped, for people.


def test_grouped_names_each_file_once() -> None:
    suppressed = replace(INFO, suppressed="a toy")
    made = report(*BOTH.findings, suppressed, errors=(SourceError("b.urdf", "gone"),))
    assert text(grouped, made) == (
        "models/dynamics.jsonld:\n"
        f"  7:21  error: {BOTH.findings[0].message} [INE007]\n"
        "  8:15  warning: Unit 'M' does not fit. [UNI002]\n"
        "  8:15  info: Unit 'M' does not fit. (suppressed) [UNI002]\n"
        "\n"
        "b.urdf:\n"
        "  1:1  error: gone\n"
        "\n"
    )
    assert text(grouped, Report()) == ""
    assert "\x1b]8;" in text(grouped, BOTH, Style(color=True, links=True))


@pytest.mark.slow
@given(reports())
def test_any_report_can_be_told(made: Report) -> None:
    """In each format, and to streams without Unicode."""
    for style in (PLAIN, ASCII):
        assert len(issues(made, style)) == len(made.findings)
        failed = [each for each in made.findings if each.severity >= Severity.WARNING]
        assert sum(suite.failures for suite in suites(made, style)) == len(failed)
        assert sum(map(len, files(made, style).values())) == len(made.findings)
    assert len(commands(made)) == len(made.findings)
