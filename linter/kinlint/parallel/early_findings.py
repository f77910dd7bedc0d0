"""Tells findings before the end of a run, in the order of its report."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from kinlint.finding import Finding, Fix
from kinlint.light_dataclasses import replace
from kinlint.parallel.merge_reports import once
from kinlint.parallel.partition import Model, first_name
from kinlint.report import Report
from kinlint.text import Location, SourceText


def counted(report: Report) -> Report:
    """Return *report* with what a summary counts of its findings, and without their texts."""
    return replace(
        report,
        findings=tuple(map(_counted, report.findings)),
        suppressed=tuple(map(_counted, report.suppressed)),
        unfixed=(),
        structures=(),
    )


def _counted(finding: Finding) -> Finding:
    bare = SourceText(finding.location.source.name, "")
    return replace(
        finding,
        location=Location(bare, finding.location.span),
        related=(),
        because=(),
        consequences=(),
        members=(),
        fixes=tuple(Fix("", each.applicability, (), "") for each in finding.fixes),
    )


class EarlyFindings:
    """The findings of models that are done, as far as nothing can come before them any more.

    Reports are sorted by the names of files. Those of a model begin at the first of its names, or
    anywhere if it may include other files.
    """

    def __init__(self, models: Sequence[Model], tell: Callable[[Sequence[Finding]], None]) -> None:
        """Begin with *tell*, a function that is told findings, those of one file all at once."""
        self._firsts = list(map(first_name, models))
        self._order = sorted(range(len(models)), key=self._firsts.__getitem__)
        self._done = set[int]()
        self._passed = 0
        self._waiting: list[Finding] = []
        self._lasts = dict[int, str]()
        self._tell = tell

    def done(self, number: int, report: Report) -> list[int]:
        """Take the *report*, which is final, of the model with this *number*.

        Return the numbers of the models of which everything is told now, and was not before.
        """
        self._done.add(number)
        self._waiting += report.findings
        names = (each.location.source.name for each in report.findings)
        self._lasts[number] = max(names, default="")
        before, order = self._passed, self._order
        while self._passed < len(order) and order[self._passed] in self._done:
            self._passed += 1
        if self._passed == before:
            return []
        ready, waiting = self._waiting, list[Finding]()
        told = [*self._lasts]
        if self._passed < len(order):
            until = self._firsts[order[self._passed]]
            told = [each for each, last in self._lasts.items() if last < until]
            ready = [each for each in self._waiting if each.location.source.name < until]
            waiting = [each for each in self._waiting if each.location.source.name >= until]
        self._waiting = waiting
        if ready:
            self._tell(once(ready))
        for each in told:
            del self._lasts[each]
        return told
