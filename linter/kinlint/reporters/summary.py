"""The summary of a run, in one line or a few."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence

from kinlint.finding import Finding
from kinlint.formats.yaml.format import YAML
from kinlint.light_dataclasses import replace
from kinlint.report import Report
from kinlint.reporters.display_width import printable
from kinlint.reporters.fixability import FIXABLE, WITH_CARE, fixable
from kinlint.reporters.terminal_style import Style
from kinlint.rule import Severity


def plural(number: int, noun: str, nouns: str = "") -> str:
    """Return *number* with its noun: `1 file`, `1,204 triples`."""
    return f"{number:,} {noun if number == 1 else nouns or noun + 's'}"


def errors(report: Report, style: Style) -> Iterator[str]:
    """Yield one line for each file that could not be read."""
    for error in report.errors:
        text = printable(str(error), unicode=style.unicode)
        yield f"{style.ink('error', 'error')}: {text}\n"


def summary(report: Report, style: Style, *, verbose: bool = False) -> Iterator[str]:
    """A line for each file that no rule applied to, and one for all that was found.

    With *verbose* it says how much was checked, too.
    """
    for name in report.unapplied:
        file = printable(name, unicode=style.unicode)
        yield f"{file}: 0 rules applied: {cause_unapplied(name)}\n"
    asides = (*_fixability(report), *_asides(report))
    yield _sentence(_verdict(report, style, verbose=verbose), asides)


def cause_unapplied(name: str) -> str:
    """Return why no rule applies to the file *name*."""
    if name.lower().endswith(YAML.suffixes):
        return "it names no joint, link, frame or planning group"
    return "no known vocabulary"


def verdict(report: Report) -> str:
    """Return the result of the run in one sentence that does not depend on its duration."""
    timeless = replace(report, seconds=None)
    clean = not (report.unsuppressed or report.fixed)
    return _sentence(_verdict(timeless, Style(), verbose=clean), [*_asides(report)]).rstrip()


def _sentence(verdict: str, asides: Sequence[str]) -> str:
    """Return a line of *verdict* and *asides*."""
    return f"{'; '.join((verdict, *asides))}.\n"


def _fixability(report: Report) -> Iterator[str]:
    """Yield the number of findings shown that `--fix` fixes; nothing if there are none.

    Those not shown count only once files were fixed, which takes the proofs of all.
    """
    told = (*report.unsuppressed, *report.hidden) if report.fixed else report.unsuppressed
    now, more = fixable(told, unsafe=report.unsafe)
    if report.unsafe is False:
        more = 0
    careful = f"with --fix --unsafe-fixes {WITH_CARE}"
    if now:
        extra = f", {more:,} more {careful}" if more else ""
        yield f"{now:,} can be fixed with --fix {FIXABLE}{extra}"
    elif more:
        yield f"{more:,} can be fixed {careful}"


def _verdict(report: Report, style: Style, *, verbose: bool) -> str:
    """Return the result without a full stop; with *verbose* also how much was read."""
    if report.unsuppressed or report.fixed:
        return f"Found {_found(report)}" + (f" ({_extent(report)})" if verbose else "")
    if report.errors:
        unread = {error.name for error in report.errors}
        others = "; no findings in the others" if report.files else ""
        return f"{plural(len(unread), 'file')} could not be read{others}"
    if not report.files:
        return "No files were checked"
    if _idle(report):
        why = "no rule applies" if report.rules else "no rule is selected"
        return f"Nothing was checked: {why}"
    extent = f"{_extent(report)}, {plural(report.applied, 'rule')} applied"
    if report.hidden:
        most = max(each.severity for each in report.hidden)
        worse = " or ".join(f"{each.label}s" for each in reversed(Severity) if each > most)
        return f"No {worse} in {plural(len(report.files), 'file')}" + f" ({extent})" * verbose
    praise = style.ink("All checks passed", "note")
    return praise + (f" ({extent})" if verbose else f" in {plural(len(report.files), 'file')}")


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
    """Return the number of findings by severity, and how many files have them."""
    if report.fixed:
        left = (*report.unsuppressed, *report.hidden)
        numbers = f"{len(report.fixed):,} fixed, {len(left):,} remaining"
        return f"{_total((*report.fixed, *left))}: {numbers}"
    names = {finding.location.source.name for finding in report.unsuppressed}
    number, read = len(names), len(report.files)
    where = f"{number:,} of {read:,} files" if number < read else plural(number, "file")
    return f"{_total(report.unsuppressed)} in {where}"


def _total(findings: Sequence[Finding]) -> str:
    """Return the number of *findings*, by severity: `3 findings (2 errors, 1 warning)`."""
    if len({each.severity for each in findings}) == 1:
        return counts(findings)
    return f"{plural(len(findings), 'finding')} ({counts(findings).replace(' and ', ', ')})"


def _extent(report: Report) -> str:
    parts = [plural(len(report.files), "file"), plural(report.triples, "triple")]
    if report.seconds is not None:
        parts.append(f"{report.seconds:.{1 if report.seconds >= 0.1 else 2}f} s")  # noqa: PLR2004
    return ", ".join(parts)


def _asides(report: Report) -> Iterator[str]:
    """Yield the numbers of findings that are not shown, and why."""
    if report.hidden:
        least = min(each.severity for each in report.hidden).label
        yield f"{counts(report.hidden)} not shown (--show {least})"
    if silenced := len(report.suppressed) + _suppressed_shown(report):
        yield f"{silenced:,} suppressed"
    if report.baseline:
        yield f"{report.baseline:,} in the baseline"
    if report.elsewhere:
        yield f"{report.elsewhere:,} more in files that were not named"
    if report.installed:
        yield f"{report.installed:,} more in installed files"


def _suppressed_shown(report: Report) -> int:
    return len(report.findings) - len(report.unsuppressed)
