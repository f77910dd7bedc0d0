"""Tells findings before the end of a run, in the order of its report."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from kinlint.finding import Finding
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
        self._tell = tell

    def has_told(self, report: Report) -> bool:
        """Tell whether no finding of *report*, which is done, waits for others."""
        if self._passed == len(self._order):
            return True
        until = self._firsts[self._order[self._passed]]
        return all(each.location.source.name < until for each in report.findings)

    def done(self, number: int, report: Report) -> None:
        """Take the *report*, which is final, of the model with this *number*."""
        self._done.add(number)
        self._waiting += report.findings
        before, order = self._passed, self._order
        while self._passed < len(order) and order[self._passed] in self._done:
            self._passed += 1
        if self._passed == before:
            return
        ready, waiting = self._waiting, list[Finding]()
        if self._passed < len(order):
            until = self._firsts[order[self._passed]]
            ready = [each for each in self._waiting if each.location.source.name < until]
            waiting = [each for each in self._waiting if each.location.source.name >= until]
        self._waiting = waiting
        if ready:
            self._tell(once(ready))
