"""The summary of a run, in one line or a few."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from kinlint.finding import Finding
from kinlint.light_dataclasses import replace
from kinlint.report import Report
from kinlint.reporters.display_width import printable
from kinlint.reporters.fixability import FIXABLE, WITH_CARE, fixable
from kinlint.reporters.terminal_style import Style

_NOT_APPLIED = "0 rules applied: no known vocabulary"


def plural(number: int, noun: str, nouns: str = "") -> str:
    """Return *number* with its noun: `1 file`, `1,204 triples`."""
    return f"{number:,} {noun if number == 1 else nouns or noun + 's'}"


def errors(report: Report, style: Style) -> Iterator[str]:
    """Yield one line for each file that could not be read."""
    for error in report.errors:
        text = printable(str(error), unicode=style.unicode)
        yield f"{style.ink('error', 'error')}: {text}\n"


def summary(report: Report, style: Style, *, verbose: bool = False) -> Iterator[str]:
    """A line for each file that no rule applied to, what was found in all, and what can be fixed.

    With *verbose* a clean run says what was checked, too.
    """
    for name in report.unapplied:
        yield f"{printable(name, unicode=style.unicode)}: {_NOT_APPLIED}\n"
    yield _verdict(report, style, verbose=verbose) + _asides(report) + "\n"
    yield from hint(report)


def verdict(report: Report) -> str:
    """Return the result of the run in one sentence that does not depend on its duration."""
    timeless = replace(report, seconds=None)
    return _verdict(timeless, Style(), verbose=True) + _asides(report)


def hint(report: Report) -> Iterator[str]:
    """Yield a line with the number of findings that `--fix` fixes; nothing if there are none."""
    now, more = fixable(report.unsuppressed, unsafe=report.unsafe)
    if report.unsafe is False:
        more = 0
    if now and more:
        extra = f" ({WITH_CARE} {more:,} more with `--fix --unsafe-fixes`)"
        yield f"{FIXABLE} {now:,} fixable with `--fix`{extra}.\n"
    elif now:
        yield f"{FIXABLE} {now:,} fixable with `--fix`.\n"
    elif more:
        yield f"{WITH_CARE} {more:,} fixable with `--fix --unsafe-fixes`.\n"


def _verdict(report: Report, style: Style, *, verbose: bool) -> str:
    if report.unsuppressed or report.fixed:
        return f"Found {_found(report)}"
    if report.errors:
        unread = {error.name for error in report.errors}
        others = "; no findings in the others" if report.files else ""
        return f"{plural(len(unread), 'file')} could not be read{others}"
    if not report.files:
        return "No files were checked"
    if _idle(report):
        why = "no rule applies" if report.rules else "no rule is selected"
        return f"Nothing was checked: {why}"
    praise = style.ink("All checks passed!", "note")
    if not verbose:
        return praise
    return f"{praise} ({_extent(report)}, {plural(report.applied, 'rule')} applied)"


def _idle(report: Report) -> bool:
    """Tell whether no rule looked at any file."""
    return not report.rules or len(report.unapplied) == len(report.files)


def counts(findings: Sequence[Finding]) -> str:
    """Return the number of *findings* of each severity: `2 errors and 1 warning`."""
    severities = Counter(finding.severity for finding in findings)
    each = [
        plural(severities[severity], severity.label)
        for severity in sorted(severities, reverse=True)
    ]
    return " and ".join([", ".join(each[:-1]), each[-1]] if each[1:] else each)


def _found(report: Report) -> str:
    if report.fixed:
        left = f"{len(report.fixed):,} fixed, {len(report.unsuppressed):,} remaining"
        return f"{counts((*report.fixed, *report.unsuppressed))} ({left})"
    names = {finding.location.source.name for finding in report.unsuppressed}
    return f"{counts(report.unsuppressed)} in {plural(len(names), 'file')} ({_extent(report)})"


def _extent(report: Report) -> str:
    parts = [plural(len(report.files), "file"), plural(report.triples, "triple")]
    if report.seconds is not None:
        parts.append(f"{report.seconds:.{1 if report.seconds >= 0.1 else 2}f} s")  # noqa: PLR2004
    return ", ".join(parts)


def _asides(report: Report) -> str:
    """Return the number of findings that are not shown, and the full stop before it."""
    parts = []
    if silenced := len(report.suppressed) + len(report.findings) - len(report.unsuppressed):
        parts.append(f"{silenced:,} suppressed")
    if report.baseline:
        parts.append(f"{report.baseline:,} in the baseline")
    if report.elsewhere:
        parts.append(f"{report.elsewhere:,} more in files that were not named")
    passed = not (report.unsuppressed or report.errors or report.fixed) and report.files
    clean = passed and not _idle(report)
    if clean:
        return f" {', '.join(parts)}." if parts else ""
    return f"; {', '.join(parts)}." if parts else "."
