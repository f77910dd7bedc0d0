"""Findings as Checkstyle reports violations: in XML, by file; many servers read that.

There is no schema. What readers know is `<checkstyle version><file name><error line column severity
message source>`, where severity is `error`, `warning`, `info` or `ignore`. The version is that of
Checkstyle whose reports these are like.
"""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.report import Report
from kinlint.reporters.display_width import fold_lines
from kinlint.reporters.repository_paths import Paths
from kinlint.reporters.terminal_style import Style
from kinlint.reporters.xml_text import HEAD, tag

VERSION = "4.3"
UNREADABLE = "kinlint"
"""The source of an error that no rule found."""


def render(report: Report, style: Style) -> Iterator[str]:
    """An element for each file: first those with findings, then those that cannot be read."""
    yield HEAD + tag("checkstyle", {"version": VERSION}, style, empty=False) + "\n"
    for name, errors in _by_file(report).items():
        yield f"  {tag('file', {'name': name}, style, empty=False)}\n"
        yield from (f"    {tag('error', error, style)}\n" for error in errors)
        yield "  </file>\n"
    yield "</checkstyle>\n"


def _by_file(report: Report) -> dict[str, list[dict[str, object]]]:
    paths = Paths(report.root)
    found: dict[str, list[dict[str, object]]] = {}
    for finding in report.unsuppressed:
        line, column = finding.location.start
        found.setdefault(paths.relative(finding.location.source.name), []).append(
            {
                "line": line,
                "column": column,
                "severity": finding.severity.label,
                "message": fold_lines(finding.message),
                "source": finding.rule.code,
            }
        )
    for error in report.errors:
        found.setdefault(paths.relative(error.name), []).append(
            {
                "line": error.line or 1,
                "column": error.column or 1,
                "severity": "error",
                "message": fold_lines(error.cause),
                "source": UNREADABLE,
            }
        )
    return found
