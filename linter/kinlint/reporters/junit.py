"""Findings as failed tests in JUnit's XML, which dashboards of all servers read.

A suite is a file, a test in it is a finding; a file without one has a test that passes, so that no
dashboard is empty. Failures agree with the exit code: a finding below `--fail-on` is the output of
a test that passes. A file that cannot be read or parsed has a test that could not be run. Servers
tell tests by class and name, so those of one rule in one file are numbered.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from kinlint.finding import Finding
from kinlint.report import Report
from kinlint.reporters.display_width import fold_lines
from kinlint.reporters.repository_paths import Paths
from kinlint.reporters.terminal_style import Style
from kinlint.reporters.xml_text import HEAD, content, tag
from kinlint.rule import Severity

PACKAGE = "org.kinlint"
_TIME = {"time": "0"}
_PASSED = "system-out"
"""The element for what a test says that passes."""


class _Case(NamedTuple):
    """A test by its name; where it fails, as what (`failure` or `error`), how bad and why.

    One of the kind `system-out` passes and says something.
    """

    name: str
    """Name of the test."""
    place: Mapping[str, int]
    """File, line and column."""
    kind: str = ""
    """`failure`, `error` or `system-out`; empty if the test passes."""
    severity: str = ""
    """Severity of the finding."""
    message: str = ""
    """Text of the message."""


def render(report: Report, style: Style) -> Iterator[str]:
    """A suite for each file that was read or named, in order."""
    suites = _suites(report)
    every = [case for cases in suites.values() for case in cases]
    totals = {"name": "kinlint", **_counts(every), **_TIME}
    yield HEAD + tag("testsuites", totals, style, empty=False) + "\n"
    for name, cases in suites.items():
        about = {"name": name, "package": PACKAGE, **_counts(cases), **_TIME}
        yield f"  {tag('testsuite', about, style, empty=False)}\n"
        for case in cases:
            yield from _test(case, name, style)
        yield "  </testsuite>\n"
    yield "</testsuites>\n"


def _test(case: _Case, name: str, style: Style) -> Iterator[str]:
    about = {"name": case.name, "classname": name, "file": name, **case.place, **_TIME}
    yield f"    {tag('testcase', about, style, empty=not case.kind)}\n"
    if case.kind:
        failed = case.kind != _PASSED
        outcome = {"type": case.severity, "message": case.message} if failed else {}
        whole = ":".join(map(str, (name, *case.place.values()))) + f": {case.message}"
        opened = tag(case.kind, outcome, style, empty=False)
        yield f"      {opened}{content(whole, style)}</{case.kind}>\n"
        yield "    </testcase>\n"


def _suites(report: Report) -> dict[str, list[_Case]]:
    paths, seen = Paths(report.root), Counter[tuple[str, str]]()
    suites: dict[str, list[_Case]] = {paths.relative(name): [] for name in report.files}
    for finding in report.unsuppressed:
        file, code = paths.relative(finding.location.source.name), finding.rule.code
        seen[file, code] += 1
        number = f" ({seen[file, code]})" if seen[file, code] > 1 else ""
        place = dict(zip(("line", "column"), finding.location.start, strict=True))
        name, severity = f"{PACKAGE}.{code}{number}", finding.severity.label
        case = _Case(name, place, _kind(finding, report), severity, fold_lines(finding.message))
        suites.setdefault(file, []).append(case)
    for error in report.errors:
        known = {"line": error.line, "column": error.column}
        place = {key: value for key, value in known.items() if value is not None}
        case = _Case(PACKAGE, place, "error", Severity.ERROR.label, fold_lines(error.cause))
        suites.setdefault(paths.relative(error.name), []).append(case)
    return {name: cases or [_Case(PACKAGE, {})] for name, cases in suites.items()}


def _kind(finding: Finding, report: Report) -> str:
    """Return the element of a test that says *finding*."""
    if finding.rule.unparsable:
        return "error"
    fails = report.fails_from is not None and finding.severity >= report.fails_from
    return "failure" if fails else _PASSED


def _counts(cases: list[_Case]) -> dict[str, int]:
    kinds = Counter(case.kind for case in cases)
    return {
        "tests": len(cases),
        "failures": kinds["failure"],
        "errors": kinds["error"],
        "skipped": 0,
    }
