"""`rdjson`: all diagnostics as one `DiagnosticResult`."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.report import Report
from kinlint.reporters.json_escape import json_text
from kinlint.reporters.reviewdog.diagnostic import SOURCE, Diagnostics
from kinlint.reporters.terminal_style import Style


def render(report: Report, style: Style) -> Iterator[str]:
    """The result as JSON."""
    made = Diagnostics(unsafe=report.unsafe)
    listed = [*map(made.finding, report.unsuppressed), *map(made.error, report.errors)]
    yield json_text({"source": SOURCE, "diagnostics": listed}, style, indent=2) + "\n"
