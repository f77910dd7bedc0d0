"""SARIF as Microsoft's validator judges it, where it is installed.

KINLINT_SARIF_MULTITOOL names the binary: `npm install @microsoft/sarif-multitool`, then
`node_modules/@microsoft/sarif-multitool-linux/Sarif.Multitool`, made executable.
"""

from __future__ import annotations

import json
import os
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import jsonschema
import pytest
from hypothesis import given, settings
from reported import (
    BOTH,
    INERTIA_FINDING,
    RULES,
    SAFE,
    UNSAFE,
    here,
    report,
    reports,
    unit_finding,
)

from kinlint.errors import SourceError
from kinlint.finding import Finding
from kinlint.report import Report
from kinlint.reporters import reporter_registry
from kinlint.reporters.sarif.sarif_log import log
from kinlint.text import Location, SourceText, Span

pytestmark = pytest.mark.external

TOOL = os.environ.get("KINLINT_SARIF_MULTITOOL", "")
OFFLINE, OUTSIDE_GIT = "SARIF2006", "SARIF2003"
needs_tool = pytest.mark.skipif(not TOOL, reason="KINLINT_SARIF_MULTITOOL names no validator")
POLICY = """<?xml version="1.0" encoding="utf-8"?>
<Properties>{}</Properties>
"""
PROPERTIES = "<Properties Key='{}.Options'><Property Key='RuleEnabled' Value='Error'/></Properties>"
GITHUB = (
    "GH1001.ProvideRequiredLocationProperties",
    "GH1002.InlineThreadFlowLocations",
    "GH1003.ProvideRequiredRegionProperties",
    "GH1004.ReviewArraysThatExceedConfigurableDefaults",
    "GH1005.LocationsMustBeRelativeUrisOrFilePaths",
    "GH1006.ProvideCheckoutPath",
    "SARIF2007.ExpressPathsRelativeToRepoRoot",
)
MINIFIED = SourceText("min.jsonld", "{" + '"a":"😀",' * 900 + '"unit":"M"}')
CRLF = SourceText("a b/ü#%?[x]:1.jsonld", '{\r\n\t"😀": "M"\r\n}\r\n', bom=True)


def marked(source: SourceText, *spans: tuple[int, int]) -> list[Finding]:
    return [unit_finding(Location(source, Span(*span))) for span in spans]


NO_RULES = "SARIF2012"
"""A note: no rule is described, which holds for a run without results."""
CASES = {
    "both": BOTH,
    "nothing": report(),
    "unreadable": replace(BOTH, errors=(SourceError("bad b.jsonld", "no [JSON]", 3, 4),)),
    "minified": report(*marked(MINIFIED, (0, 1), (0, len(MINIFIED.text)), (5000, 5004))),
    "crlf": report(*marked(CRLF, (0, 0), (4, 7), (1, 17), (len(CRLF.text), len(CRLF.text)))),
    "elsewhere": report(
        *(unit_finding(here("{}", 0, 1, n)) for n in ("../x.jsonld", "/abs/y.jsonld", "<stdin>"))
    ),
    "suppressed": report(replace(INERTIA_FINDING, suppressed="known"), *BOTH.findings[1:]),
    "fixes": report(replace(INERTIA_FINDING, fixes=(UNSAFE, SAFE)), *BOTH.findings[1:]),
    "free text": report(unit_finding(here("{}", 0, 1), message="[a](7) {0}", template="")),
}


def complaints(made: Report, directory: Path) -> list[str]:
    """The rules of the validator that *made* breaks, at any level."""
    written, judged = directory / "out.sarif", directory / "judged.sarif"
    policy = directory / "policy.xml"
    policy.write_text(POLICY.format("".join(map(PROPERTIES.format, GITHUB))))
    with written.open("w", encoding="utf-8") as stream:
        reporter_registry.write(made, "sarif", stream)
    command: list[str | Path] = [TOOL, "validate", written, "--rule-kind", "Sarif;Ghas"]
    levels = ["--level", "Error;Warning;Note", "--kind", "Fail;Open;Review"]
    output: list[str | Path] = ["-c", policy, "-o", judged, "--log", "ForceOverwrite"]
    subprocess.run([*command, *levels, *output], check=False, capture_output=True)
    (run,) = json.loads(judged.read_text(encoding="utf-8-sig"))["runs"]
    invocations = run.get("invocations", [])
    broken = [note for one in invocations for note in one.get("toolExecutionNotifications", ())]
    assert not [note for note in broken if note.get("level") == "error"]
    return [result["ruleId"] for result in run["results"]]


@needs_tool
@pytest.mark.parametrize("case", CASES)
def test_the_validator_has_nothing_to_say(case: str, tmp_path: Path) -> None:
    known = {OFFLINE, OUTSIDE_GIT} | ({NO_RULES} if not CASES[case].findings else set())
    assert set(complaints(CASES[case], tmp_path)) <= known


@needs_tool
def test_the_validator_would_speak(tmp_path: Path) -> None:
    """A run without any rule description is one of its notes, so it does look."""
    assert NO_RULES in complaints(Report(rules=()), tmp_path)


@pytest.fixture(scope="session")
def schema() -> dict[str, Any]:
    path = Path(TOOL).parent / "sarif-2.1.0.json"
    if not TOOL or not path.is_file():
        pytest.skip("the schema comes with the validator that KINLINT_SARIF_MULTITOOL names")
    loaded: dict[str, Any] = json.loads(path.read_text(encoding="utf-8-sig"))
    return loaded


@pytest.mark.parametrize("case", CASES)
def test_logs_are_valid_by_the_schema(case: str, schema: dict[str, Any]) -> None:
    jsonschema.Draft202012Validator(schema).validate(log(CASES[case]))


def test_any_log_is_valid_by_the_schema(schema: dict[str, Any]) -> None:
    validator = jsonschema.Draft202012Validator(schema)

    @settings(max_examples=25)
    @given(reports())
    def valid(made: Report) -> None:
        validator.validate(log(made))

    valid()


def test_the_cases_cover_all_rules() -> None:
    assert {finding.rule for finding in BOTH.findings} == set(RULES)
