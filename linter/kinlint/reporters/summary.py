"""What a run amounts to, in a line or a few."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from kinlint.report import Report
from kinlint.reporters.columns import shown
from kinlint.reporters.style import Style

_NOT_APPLIED = "0 rules applied: no known vocabulary"


def counted(number: int, noun: str, nouns: str = "") -> str:
    """*number* in front of a noun: `1 file`, `1,204 triples`."""
    return f"{number:,} {noun if number == 1 else nouns or noun + 's'}"


def errors(report: Report, style: Style) -> Iterator[str]:
    """One line for each file that could not be read."""
    for error in report.errors:
        text = shown(str(error), unicode=style.unicode)
        yield f"{style.ink('error', 'error')}: {text}\n"


def summary(report: Report, style: Style, *, verbose: bool = False) -> Iterator[str]:
    """A line for each file that no rule applied to, then what was found in all.

    With *verbose* a clean run says what was checked, too.
    """
    for name in report.unapplied:
        yield f"{shown(name, unicode=style.unicode)}: {_NOT_APPLIED}\n"
    yield _verdict(report, style, verbose=verbose) + _asides(report) + "\n"


def _verdict(report: Report, style: Style, *, verbose: bool) -> str:
    if report.open:
        return f"Found {_found(report)} ({_extent(report)})"
    if report.errors:
        unread = {error.name for error in report.errors}
        others = "; no findings in the others" if report.files else ""
        return f"{counted(len(unread), 'file')} could not be read{others}"
    if not report.files:
        return "No files were checked"
    if _idle(report):
        why = "no rule applies" if report.rules else "no rule is selected"
        return f"Nothing was checked: {why}"
    praise = style.ink("All checks passed!", "note")
    if not verbose:
        return praise
    return f"{praise} ({_extent(report)}, {counted(report.applied, 'rule')} applied)"


def _idle(report: Report) -> bool:
    """Whether no rule looked at any file."""
    return not report.rules or len(report.unapplied) == len(report.files)


def _found(report: Report) -> str:
    severities = Counter(finding.severity for finding in report.open)
    counts = [
        counted(severities[severity], severity.label)
        for severity in sorted(severities, reverse=True)
    ]
    names = {finding.location.source.name for finding in report.open}
    kinds = " and ".join([", ".join(counts[:-1]), counts[-1]] if counts[1:] else counts)
    return f"{kinds} in {counted(len(names), 'file')}"


def _extent(report: Report) -> str:
    parts = [counted(len(report.files), "file"), counted(report.triples, "triple")]
    if report.seconds is not None:
        parts.append(f"{report.seconds:.{1 if report.seconds >= 0.1 else 2}f} s")  # noqa: PLR2004
    return ", ".join(parts)


def _asides(report: Report) -> str:
    """What was found and is not shown, and the full stop before it."""
    parts = []
    if silenced := len(report.suppressed) + len(report.findings) - len(report.open):
        parts.append(f"{silenced:,} suppressed")
    if report.baseline:
        parts.append(f"{report.baseline:,} in the baseline")
    passed = not (report.open or report.errors) and report.files
    clean = passed and not _idle(report)
    if clean:
        return f" {', '.join(parts)}." if parts else ""
    return f"; {', '.join(parts)}." if parts else "."
