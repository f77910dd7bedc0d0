"""`rdjsonl`: a diagnostic a line."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.report import Report
from kinlint.reporters.json_escape import json_text
from kinlint.reporters.reviewdog.diagnostic import SOURCE, Diagnostics
from kinlint.reporters.terminal_style import Style


def render(report: Report, style: Style) -> Iterator[str]:
    """A line for each finding, then one for each file that cannot be read."""
    made = Diagnostics(unsafe=report.unsafe)
    for one in (*map(made.finding, report.unsuppressed), *map(made.error, report.errors)):
        yield json_text({**one, "source": SOURCE}, style) + "\n"
