from __future__ import annotations

import re
from dataclasses import replace

import pytest
from hypothesis import given
from reported import BOTH, INERTIA_FINDING, SAFE, UNSAFE, here, report, reports, unit_finding

from kinlint.errors import SourceError
from kinlint.report import Report
from kinlint.reporters.concise import render
from kinlint.reporters.terminal_style import Style

LINE = re.compile(r"(.+?):(\d+):(\d+): (error|warning|info): (.*) \[([A-Z]{1,8}\d{3})\]")


def test_each_finding_is_one_gnu_line() -> None:
    assert "".join(render(BOTH, Style())) == (
        "models/dynamics.jsonld:7:21: error: Inertia 'rob:link2-inertia' is seen by frame "
        "'rob:link1-root' of another body. [INE007]\n"
        "models/dynamics.jsonld:8:15: warning: Unit 'M' does not fit. [UNI002]\n"
    )


def test_line_ends_in_a_message_are_folded() -> None:
    finding = unit_finding(here("x", 0, 1), message="one\r\n  two\n\nthree")
    assert "".join(render(report(finding), Style())).endswith(": one two three [UNI002]\n")


def test_what_can_be_fixed_has_a_sign_before_the_message() -> None:
    """The code stays last, where editors look for it."""
    for fix, unsafe, sign in ((SAFE, None, "[*]"), (UNSAFE, None, "[*!]"), (UNSAFE, True, "[*]")):
        made = report(replace(INERTIA_FINDING, fixes=(fix,)), unsafe=unsafe)
        assert f": error: {sign} Inertia " in "".join(render(made, Style()))


def test_a_suppressed_finding_is_called_so() -> None:
    finding = replace(unit_finding(here("x", 0, 1)), suppressed="known")
    assert "does not fit. (suppressed) [UNI002]\n" in "".join(render(report(finding), Style()))


def test_a_file_that_cannot_be_read_is_a_gnu_line_too() -> None:
    errors = (SourceError("a.jsonld", "no JSON", 3, 4), SourceError("b.jsonld", "no\nfile"))
    assert "".join(render(Report(errors=errors), Style())) == (
        "a.jsonld:3:4: error: no JSON\nb.jsonld:1:1: error: no file\n"
    )


@pytest.mark.slow
@given(reports())
def test_every_line_parses_and_keeps_its_place(made: Report) -> None:
    text = "".join(render(made, Style()))
    lines = text.split("\n")
    assert lines.pop() == ""
    assert len(lines) == len(made.findings)
    for line, finding in zip(lines, made.findings, strict=True):
        match = LINE.fullmatch(line)
        assert match is not None
        assert (int(match[2]), int(match[3])) == finding.location.start
        assert match[4] == finding.severity.label
