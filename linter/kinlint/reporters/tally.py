"""How often each rule found something: the table of `--statistics`."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from kinlint.model import Rule
from kinlint.report import Report
from kinlint.reporters.style import INK_OF, Style

_HEADINGS = ("Count", "Code", "Severity", "Anti-patterns", "Name")


def render(report: Report, style: Style) -> Iterator[str]:
    """The table, most frequent rule first: drawn in colour, aligned columns otherwise."""
    counts = Counter(finding.rule.code for finding in report.open)
    rules = {finding.rule.code: finding.rule for finding in report.open}
    order = sorted(rules.values(), key=lambda rule: (-counts[rule.code], rule.code))
    rows = [(f"{counts[rule.code]:,}", *_cells(rule)) for rule in order]
    if not rows:
        return
    if style.color:
        yield _drawn(rows, order, style)
        return
    widths = [max(len(row[column]) for row in rows) for column in range(len(_HEADINGS))]
    for count, *cells in rows:
        padded = (f"{cell:<{width}}" for cell, width in zip(cells, widths[1:], strict=True))
        yield f"{count:>{widths[0]}}  {'  '.join(padded)}".rstrip() + "\n"


def _cells(rule: Rule) -> tuple[str, ...]:
    return rule.code, rule.severity.label, ",".join(rule.antipatterns) or "-", rule.name


def _drawn(rows: list[tuple[str, ...]], rules: list[Rule], style: Style) -> str:
    from rich.box import ASCII, SIMPLE_HEAD  # noqa: PLC0415
    from rich.table import Table  # noqa: PLC0415
    from rich.text import Text  # noqa: PLC0415

    from kinlint.reporters.drawing import drawn  # noqa: PLC0415

    inks = {"error": "bold red", "warning": "bold yellow", "info": "bold cyan"}
    table = Table(box=SIMPLE_HEAD if style.unicode else ASCII, pad_edge=False)
    for heading in _HEADINGS:
        table.add_column(heading, justify="right" if heading == "Count" else "left")
    for row, rule in zip(rows, rules, strict=True):
        count, code, severity, *rest = row
        code_style = f"link {rule.iri}" if style.links else ""
        table.add_row(
            count, Text(code, code_style), Text(severity, inks[INK_OF[rule.severity]]), *rest
        )
    return drawn(table, style)
