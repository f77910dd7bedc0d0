"""Puts the reports of models together: one report, as if they had been linted as one."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from kinlint.errors import SourceError
from kinlint.finding import Finding
from kinlint.light_dataclasses import replace
from kinlint.report import Report
from kinlint.structure import Structure


def merge_reports(
    reports: Sequence[Report],
    names: Sequence[str],
    errors: Sequence[SourceError],
    seconds: float,
    recalled: int | None = None,
) -> Report:
    """Merge *reports* into one, in the order of *names*; duplicates at one place are dropped.

    *errors* replace theirs. *recalled* is as in a report.
    """
    if len(reports) == 1:
        return replace(reports[0], errors=tuple(errors), seconds=seconds, recalled=recalled)
    place = {name: index for index, name in enumerate(names)}
    rules = {rule.code: rule for report in reports for rule in report.rules}
    files = order_names((name for report in reports for name in report.files), place)
    return Report(
        findings=once(finding for report in reports for finding in report.findings),
        suppressed=once(finding for report in reports for finding in report.suppressed),
        files=files,
        unapplied=order_names((name for report in reports for name in report.unapplied), place),
        errors=tuple(errors),
        rules=tuple(rules[code] for code in sorted(rules)),
        triples=sum(report.triples for report in reports),
        applied=len(rules) if files else 0,
        seconds=seconds,
        recalled=recalled,
        unfixed=tuple(refusal for report in reports for refusal in report.unfixed),
        fixed=tuple(finding for report in reports for finding in report.fixed),
        structures=_drawn(reports, place),
    )


def order_names(names: Iterable[str], place: Mapping[str, int]) -> tuple[str, ...]:
    """*names* by their *place*."""
    return tuple(sorted(names, key=lambda name: place.get(name, len(place))))


def _drawn(reports: Sequence[Report], place: Mapping[str, int]) -> tuple[Structure, ...]:
    """The robots of all, in the order of the files that describe them first."""
    found = [each for report in reports for each in report.structures]
    return tuple(sorted(found, key=lambda each: place.get((*each.files, "")[0], len(place))))


def once(findings: Iterable[Finding]) -> tuple[Finding, ...]:
    """Return *findings* as a report has them: sorted, and of duplicates at one place the first."""
    told = sorted(findings, key=lambda finding: finding.sort_key)
    return tuple({finding.identity: finding for finding in reversed(told)}.values())[::-1]
