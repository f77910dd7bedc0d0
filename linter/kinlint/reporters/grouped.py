"""Findings below the name of their file, a line for each."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.report import Report
from kinlint.reporters.display_width import fold_lines, printable
from kinlint.reporters.fixability import sign as fix_sign
from kinlint.reporters.terminal_style import INK_OF, Style


def render(report: Report, style: Style) -> Iterator[str]:
    """The files with findings, then those that cannot be read, each with a blank line after it."""
    groups: dict[str, list[tuple[str, str]]] = {}
    for finding in report.findings:
        kind = style.ink(finding.severity.label, INK_OF[finding.severity])
        aside = "" if finding.suppressed is None else " (suppressed)"
        code = style.link(finding.rule.code, finding.rule.iri)
        mark = f"{sign} " if (sign := fix_sign(finding, unsafe=report.unsafe)) else ""
        text = f"{kind}: {mark}{fold_lines(finding.message, unicode=style.unicode)}{aside} [{code}]"
        line, column = finding.location.start
        groups.setdefault(finding.location.source.name, []).append((f"{line}:{column}", text))
    for error in report.errors:
        text = f"{style.ink('error', 'error')}: {fold_lines(error.cause, unicode=style.unicode)}"
        groups.setdefault(error.name, []).append((f"{error.line or 1}:{error.column or 1}", text))
    for name, rows in groups.items():
        yield f"{style.ink(printable(name, unicode=style.unicode), 'strong')}:\n"
        width = max(len(place) for place, _ in rows)
        yield from (f"  {place:<{width}}  {text}\n" for place, text in rows)
        yield "\n"
