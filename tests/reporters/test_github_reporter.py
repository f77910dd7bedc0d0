from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given
from reported import BOTH, here, report, reports, unit_finding

from kinlint.errors import SourceError
from kinlint.finding import Finding
from kinlint.report import Report
from kinlint.reporters.github import render
from kinlint.reporters.terminal_style import Style
from kinlint.rule import Severity


@pytest.fixture(autouse=True)
def elsewhere(monkeypatch: pytest.MonkeyPatch) -> None:
    """As outside of workflows."""
    monkeypatch.delenv("GITHUB_STEP_SUMMARY", raising=False)


def github(*findings: Finding) -> list[str]:
    return "".join(render(report(*findings), Style())).splitlines()


def test_each_finding_is_a_command_the_worst_first() -> None:
    worst_last = replace(BOTH, findings=BOTH.findings[::-1])
    assert "".join(render(worst_last, Style())) == (
        "::error title=kinlint (INE007),file=/work/models/dynamics.jsonld,"
        "line=7,endLine=7,col=21,endColumn=37::"
        "Inertia 'rob:link2-inertia' is seen by frame 'rob:link1-root' of another body.\n"
        "::warning title=kinlint (UNI002),file=/work/models/dynamics.jsonld,"
        "line=8,endLine=8,col=15,endColumn=18::Unit 'M' does not fit.\n"
    )


def test_what_separates_commands_is_escaped() -> None:
    location = here("x", 0, 1, name="a,b:c%0A\n.jsonld")
    (line,) = github(unit_finding(location, message="50%\r\n::error::x"))
    assert line == (
        "::warning title=kinlint (UNI002),file=/work/a%2Cb%3Ac%250A%0A.jsonld,"
        "line=1,endLine=1,col=1,endColumn=2::50%25%0D%0A::error::x"
    )


def test_paths_are_absolute_and_straight() -> None:
    places = (here("x", name=name) for name in ("../up.jsonld", "/abs/x.jsonld", "./a/x.jsonld"))
    lines = "\n".join(github(*map(unit_finding, places)))
    for path in ("/up.jsonld", "/abs/x.jsonld", "/work/a/x.jsonld"):
        assert f"file={path}," in lines


def test_standard_input_is_no_file() -> None:
    assert github(unit_finding(here("x", 0, 1, name="<stdin>")))[0].startswith(
        "::warning title=kinlint (UNI002),line=1,"
    )


def test_columns_are_dropped_from_a_span_of_several_lines() -> None:
    line = github(unit_finding(here("{\n}", 0, 3)))[0]
    assert ",line=1,endLine=2::" in line


def test_twelve_findings_make_ten_annotations_and_a_count() -> None:
    warnings = [unit_finding(here("x", 0, 1), str(i)) for i in range(12)]
    errors = [replace(finding, severity=Severity.ERROR) for finding in warnings[:11]]
    notice = replace(warnings[0], severity=Severity.INFO)
    lines = github(*warnings, *errors, notice)
    kinds = [line.split(" ", 1)[0] for line in lines]
    assert kinds == ["::error"] * 10 + ["::warning"] * 10 + ["::notice", "kinlint:"]
    assert lines[-1] == (
        "kinlint: 1 more error, 2 more warnings not annotated, since GitHub shows 10 of a kind;"
        " other formats list all."
    )


def test_the_rest_is_in_the_summary_of_the_step(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GITHUB_STEP_SUMMARY", "/any")
    lines = github(*(unit_finding(here("x", 0, 1), str(i)) for i in range(11)))
    assert lines[-1].endswith("GitHub shows 10 of a kind; they are in the summary of this step.")


def test_files_that_cannot_be_read_are_annotated_first() -> None:
    """They count among the ten errors."""
    errors = tuple(SourceError(f"{i}.jsonld", "gone") for i in range(12))
    finding = unit_finding(here("x", 0, 1), severity=Severity.ERROR)
    lines = "".join(render(report(finding, errors=errors), Style())).splitlines()
    assert sum(line.endswith("::gone") for line in lines) == len(lines) - 1 == 10
    assert lines[-1].startswith("kinlint: 3 more errors not annotated")


def test_messages_are_cut_to_what_the_runner_keeps() -> None:
    (line,) = github(unit_finding(here("x", 0, 1), message="%" * 5_000))
    message = line.rpartition("::")[2].replace("%25", "%")
    assert message == "%" * 4_095 + "…"
    (line,) = github(unit_finding(here("x", 0, 1), message="x" * 4_096))
    assert line.endswith("::" + "x" * 4_096)


def test_a_suppressed_finding_is_not_annotated() -> None:
    assert github(replace(unit_finding(here("x", 0, 1)), suppressed="known")) == []


def test_a_file_that_cannot_be_read_is_an_error() -> None:
    errors = (
        SourceError("a.jsonld", "no JSON", 3, 4),
        SourceError("b", "gone"),
        SourceError("c", "x", 2),
    )
    made = Report(errors=errors, root="/work")
    assert "".join(render(made, Style())) == (
        "::error title=kinlint,file=/work/a.jsonld,line=3,col=4::no JSON\n"
        "::error title=kinlint,file=/work/b::gone\n"
        "::error title=kinlint,file=/work/c,line=2::x\n"
    )


@pytest.mark.slow
@given(reports())
def test_a_finding_never_takes_more_than_its_line(made: Report) -> None:
    text = "".join(render(made, Style()))
    assert text.count("\n") == len(made.findings)
    assert all(line.startswith("::") for line in text.split("\n")[:-1])
    assert "\r" not in text
