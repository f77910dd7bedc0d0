"""Findings as JSON objects, one a line."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.report import Report
from kinlint.reporters.finding_object import error_object, finding_object
from kinlint.reporters.json_escape import json_text
from kinlint.reporters.terminal_style import Style


def render(report: Report, style: Style) -> Iterator[str]:
    """A line for each finding, then one for each file that cannot be read."""
    for thing in (
        *map(finding_object, report.findings),
        *map(error_object, report.errors),
    ):
        yield json_text(thing, style) + "\n"
