"""Findings as one JSON array of objects."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.report import Report
from kinlint.reporters.finding_object import error_object, finding_object
from kinlint.reporters.json_escape import json_text
from kinlint.reporters.terminal_style import Style


def render(report: Report, style: Style) -> Iterator[str]:
    """The array, an object at a time: findings first, then the files that cannot be read."""
    things = *map(finding_object, report.findings), *map(error_object, report.errors)
    lead = "[\n"
    for thing in things:
        text = json_text(thing, style, indent=2)
        yield lead + "\n".join(f"  {line}" for line in text.split("\n"))
        lead = ",\n"
    yield "\n]\n" if things else "[]\n"
