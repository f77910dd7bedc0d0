"""Findings as Markdown: a table by rule, then each at its place; for comments and wikis."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TypeAlias

from kinlint.finding import Finding
from kinlint.report import STDIN_NAMES, Report
from kinlint.reporters.markdown_text import address, escaped, link, table
from kinlint.reporters.repository_paths import Paths
from kinlint.reporters.summary import counts, verdict
from kinlint.reporters.terminal_style import Style

Address: TypeAlias = Callable[[str, int | None], str]
"""The URL of a line, or of all, of the file at a path."""


def render(report: Report, style: Style) -> Iterator[str]:  # noqa: ARG001
    """The verdict, the table, the findings by file and the files that cannot be read."""
    yield from head(report)
    yield from by_rule(report.unsuppressed)
    yield from listing(report.unsuppressed, Paths(report.root), address)
    yield from unread(report, Paths(report.root), address)


def head(report: Report) -> Iterator[str]:
    """Yield the verdict of the run as a heading and a sentence."""
    yield f"## kinlint\n\n{escaped(verdict(report))}\n"


def by_rule(findings: Sequence[Finding]) -> Iterator[str]:
    """Yield a table of the number of *findings* per rule, the most frequent first."""
    groups: dict[str, list[Finding]] = {}
    for finding in findings:
        groups.setdefault(finding.rule.code, []).append(finding)
    if not groups:
        return
    rows = []
    for group in sorted(groups.values(), key=lambda group: (-len(group), group[0].rule.code)):
        rule, worst = group[0].rule, max(finding.severity for finding in group)
        cells = link(rule.code, rule.iri), escaped(rule.title), worst.label, f"{len(group):,}"
        rows.append(cells)
    yield "\n" + table(("Rule", "What", "Severity", "Count"), rows, right=3)


def listing(
    findings: Iterable[Finding], paths: Paths, url: Address, level: int = 3
) -> Iterator[str]:
    """An item for each of *findings*, below the name of its file, a heading of *level*."""
    groups: dict[str, list[Finding]] = {}
    for finding in findings:
        groups.setdefault(finding.location.source.name, []).append(finding)
    for name, group in groups.items():
        path = paths.relative(name)
        shown = name not in STDIN_NAMES
        file = link(path, url(path, None) if shown else "")
        yield f"\n{'#' * level} {file} ({counts(group)})\n\n"
        for finding in group:
            line, column = finding.location.start
            place = link(f"{line}:{column}", url(path, line) if shown else "")
            rule = link(finding.rule.code, finding.rule.iri)
            message = escaped(finding.message)
            yield f"- {place} **{finding.severity.label}** {rule}: {message}\n"


def unread(report: Report, paths: Paths, url: Address) -> Iterator[str]:
    """An item for each file that cannot be read; nothing if all can."""
    if report.errors:
        yield "\n### Files that cannot be read\n\n"
    for error in report.errors:
        path = paths.relative(error.name)
        shown = error.name not in STDIN_NAMES
        place = f"{path}:{error.line}" if error.line else path
        target = url(path, error.line) if shown else ""
        yield f"- {link(place, target)} **error**: {escaped(error.cause)}\n"
