"""Applied fixes: the list of `--show-fixes`, and the last line of `--fix-only`."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from kinlint.report import Report
from kinlint.reporters.display_width import printable
from kinlint.reporters.fixability import fixable
from kinlint.reporters.summary import counts
from kinlint.reporters.terminal_style import INK_OF, Style
from kinlint.rule import Rule


def listing(report: Report, style: Style, *, would: bool = False) -> Iterator[str]:
    """Yield the fixes made, or that *would* be, by file and rule."""
    if not report.fixed:
        return
    yield f"{_verb(would=would)} {counts(report.fixed)}:\n"
    files: dict[str, Counter[str]] = {}
    rules: dict[str, Rule] = {}
    for finding in report.fixed:
        rules[finding.rule.code] = finding.rule
        files.setdefault(finding.location.source.name, Counter())[finding.rule.code] += 1
    width = max(len(f"{count:,}") for each in files.values() for count in each.values())
    for name, each in files.items():
        yield f"- {style.ink(printable(name, unicode=style.unicode), 'strong')}:\n"
        for code, count in sorted(each.items(), key=lambda one: (-one[1], one[0])):
            rule = rules[code]
            linked = style.ink(style.link(code, rule.iri), INK_OF[rule.severity])
            yield f"    {count:>{width},} x {linked} ({rule.name})\n"
    yield "\n"


def verdict(report: Report, *, would: bool = False) -> Iterator[str]:
    """Yield the number of fixes made, or that *would* be, in a run that reports nothing else."""
    more = fixable((*report.unsuppressed, *report.hidden), unsafe=report.unsafe).with_care
    what, word = (counts(report.fixed), "more") if report.fixed else ("nothing", "fixable")
    extra = f" ({more:,} {word} with `--unsafe-fixes`)" if more and report.unsafe is None else ""
    yield f"{_verb(would=would)} {what}{extra}.\n"


def _verb(*, would: bool) -> str:
    return "Would fix" if would else "Fixed"
