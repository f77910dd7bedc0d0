"""Counts of findings by severity, rule, anti-pattern and file."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

from kinlint.finding import Finding
from kinlint.report import Report
from kinlint.reporters.antipatterns import ANTIPATTERNS
from kinlint.reporters.fixability import fixable
from kinlint.reporters.picture.escape import element, text
from kinlint.reporters.picture.finding_badges import sign
from kinlint.rule import Severity

FILES = 200
"""Number of files above which only those with the most findings have a row."""


def tables(report: Report) -> Iterator[str]:
    """The section of tables; nothing if nothing was found."""
    if not report.unsuppressed:
        return
    yield '<section id="counts" aria-labelledby="counts-title">\n'
    yield '<h2 id="counts-title">Counts</h2>\n<div class="tables">\n'
    yield _by_severity(report)
    yield _by_rule(report.unsuppressed)
    yield _by_antipattern(report.unsuppressed)
    yield _by_file(report.unsuppressed)
    yield "</div>\n</section>\n"


def _by_severity(report: Report) -> str:
    groups = {
        severity: [one for one in report.unsuppressed if one.severity is severity]
        for severity in sorted(Severity, reverse=True)
    }
    rows = []
    for severity, group in groups.items():
        if group:
            now, more = fixable(group, unsafe=report.unsafe)
            rows.append((chip(severity), f"{len(group):,}", f"{now:,}", f"{more:,}"))
    return _table("By severity", ("Severity", "Findings", "Safe fixes", "Unsafe fixes"), rows)


def _by_rule(findings: Sequence[Finding]) -> str:
    groups: dict[str, list[Finding]] = {}
    for one in findings:
        groups.setdefault(one.rule.code, []).append(one)
    rows = [
        (
            (
                f"{chip(max(one.severity for one in group), '')} "
                f'<a href="#{rule_id(group[0])}">{text(group[0].rule.code)}</a> '
                f"{text(group[0].rule.title)}"
            ),
            f"{len(group):,}",
        )
        for group in sorted(groups.values(), key=lambda group: (-len(group), group[0].rule.code))
    ]
    return _table("By rule", ("Rule", "Findings"), rows)


def _by_antipattern(findings: Iterable[Finding]) -> str:
    counts = Counter(each for one in findings for each in one.rule.antipatterns)
    rows = [
        (f"{pattern.id} {text(pattern.name)}", f"{counts[pattern.id]:,}")
        for pattern in ANTIPATTERNS
        if counts[pattern.id]
    ]
    return _table("By anti-pattern", ("Anti-pattern", "Findings"), rows)


def _by_file(findings: Iterable[Finding]) -> str:
    groups: dict[str, list[Finding]] = {}
    for one in findings:
        groups.setdefault(one.location.source.name, []).append(one)
    numbers = {name: number for number, name in enumerate(groups, 1)}
    ordered = sorted(groups.items(), key=lambda pair: (-len(pair[1]), pair[0]))
    rows = [
        (
            f'<a class="place" href="#file-{numbers[name]}">{text(name)}</a>',
            *(
                f"{count:,}" if count else "–"  # noqa: RUF001
                for severity in sorted(Severity, reverse=True)
                for count in (sum(one.severity is severity for one in group),)
            ),
        )
        for name, group in ordered[:FILES]
    ]
    if len(ordered) > FILES:
        rows.append((f"and {len(ordered) - FILES:,} more files", "", "", ""))
    return _table("By file", ("File", "Errors", "Warnings", "Infos"), rows)


def _table(title: str, heads: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table; the cells of *rows* are markup, the first heads its row."""
    if not rows:
        return ""
    head = "".join(f'<th scope="col">{each}</th>' for each in heads)
    body = "".join(
        f'<tr><th scope="row">{row[0]}</th>{"".join(f"<td>{each}</td>" for each in row[1:])}</tr>'
        for row in rows
    )
    return (
        f'<div class="table"><table><caption>{title}</caption>'
        f"<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>\n"
    )


def chip(severity: Severity, word: str | None = None) -> str:
    """The sign of *severity* in its colour, with its word, or with another one."""
    mark = f'<span aria-hidden="true">{sign(severity)}</span>'
    said = severity.label if word is None else word
    hidden = f'<span class="hidden">{severity.label}</span>' if not said else f" {text(said)}"
    return element("span", mark + hidden, class_=f"chip {severity.label}")


def rule_id(finding: Finding) -> str:
    """The id of the documentation of the rule of *finding*, on the page."""
    return f"rule-{''.join(each if each.isalnum() else '-' for each in finding.rule.code)}"
