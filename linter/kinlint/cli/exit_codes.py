"""The exit codes of `kinlint check`, and what decides between them."""

from __future__ import annotations

from kinlint.report import Report
from kinlint.rule import Severity

CLEAN, FOUND, ABNORMAL = 0, 1, 2
THRESHOLD = "warning"
"""The least severity that makes a run fail by default."""


def threshold(fail_on: str) -> Severity | None:
    """Return the least severity that makes a run fail; None if none does."""
    return None if fail_on == "none" else Severity[fail_on.upper()]


def exit_code(report: Report) -> int:
    """Return 2 if a file could not be read, 1 if findings make the run of *report* fail, else 0."""
    unparsed = any(one.rule.unparsable for one in report.unsuppressed)
    if report.errors or unparsed or (report.passed_over and not report.files):
        return ABNORMAL
    least = report.fails_from
    failed = least is not None and any(one.severity >= least for one in report.unsuppressed)
    return FOUND if failed else CLEAN
