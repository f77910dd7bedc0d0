"""Counts of findings by rule: the table of `--statistics`."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.finding import Finding
from kinlint.report import Report
from kinlint.reporters.fixability import FIXABLE, PARTLY, WITH_CARE, fixable
from kinlint.reporters.terminal_style import INK_OF, Style

_HEADINGS = ("Count", "Code", "Fix", "Severity", "Anti-patterns", "Name")
_FIX = _HEADINGS.index("Fix")


def render(report: Report, style: Style) -> Iterator[str]:
    """The table, most frequent rule first: drawn in colour, aligned columns otherwise.

    What can be fixed has a column if anything can.
    """
    groups: dict[str, list[Finding]] = {}
    for finding in report.unsuppressed:
        groups.setdefault(finding.rule.code, []).append(finding)
    ordered = sorted(groups.values(), key=lambda group: (-len(group), group[0].rule.code))
    if not ordered:
        return
    rows = [_cells(group, unsafe=report.unsafe) for group in ordered]
    columns = [
        index
        for index in range(len(_HEADINGS))
        if index != _FIX or any(finding.fixes for finding in report.unsuppressed)
    ]
    if style.color:
        yield _drawn(rows, columns, ordered, style)
        return
    widths = [max(len(row[column]) for row in rows) for column in columns]
    for row in rows:
        count, *cells = (row[column] for column in columns)
        padded = (f"{cell:<{width}}" for cell, width in zip(cells, widths[1:], strict=True))
        yield f"{count:>{widths[0]}}  {'  '.join(padded)}".rstrip() + "\n"


def _cells(group: Sequence[Finding], *, unsafe: bool | None) -> tuple[str, ...]:
    """Return the row of the table for the findings of one rule."""
    rule = group[0].rule
    severities = sorted({finding.severity for finding in group}, reverse=True)
    return (
        f"{len(group):,}",
        rule.code,
        _sign(group, unsafe=unsafe),
        ",".join(severity.label for severity in severities),
        ",".join(rule.antipatterns) or "-",
        rule.name,
    )


def _sign(group: Sequence[Finding], *, unsafe: bool | None) -> str:
    """Return the sign for whether all of *group* can be fixed, some, or none."""
    now, with_care = fixable(group, unsafe=unsafe)
    if not now and not with_care:
        return "-"
    if now + with_care < len(group):
        return PARTLY
    return WITH_CARE if with_care else FIXABLE


def _drawn(
    rows: Sequence[tuple[str, ...]],
    columns: Sequence[int],
    groups: Sequence[Sequence[Finding]],
    style: Style,
) -> str:
    from rich.box import ASCII, SIMPLE_HEAD  # noqa: PLC0415
    from rich.table import Table  # noqa: PLC0415
    from rich.text import Text  # noqa: PLC0415

    from kinlint.reporters.rich_render import rich_text  # noqa: PLC0415

    inks = {"error": "bold red", "warning": "bold yellow", "info": "bold cyan"}
    table = Table(box=SIMPLE_HEAD if style.unicode else ASCII, pad_edge=False)
    for column in columns:
        heading = _HEADINGS[column]
        table.add_column(heading, justify="right" if heading == "Count" else "left")
    for row, group in zip(rows, groups, strict=True):
        worst = max(finding.severity for finding in group)
        count, code, fix, severity, tags, name = map(Text, row)
        if style.links:
            code.stylize(f"link {group[0].rule.iri}")
        severity.stylize(inks[INK_OF[worst]])
        cells = count, code, fix, severity, tags, name
        table.add_row(*(cells[column] for column in columns))
    return rich_text(table, style)
