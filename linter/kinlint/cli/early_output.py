"""Output that begins before the end of a run: findings are written once they are final."""

from __future__ import annotations

import sys
from collections.abc import Collection, Sequence
from typing import TYPE_CHECKING

from kinlint.cli.installed_findings import without_installed
from kinlint.cli.report_outputs import Outputs
from kinlint.finding import Finding
from kinlint.light_dataclasses import replace
from kinlint.report import Report

if TYPE_CHECKING:
    from kinlint.cli.gathered_outputs import GatheredOutputs


class EarlyOutput:
    """Writes findings to standard output, as the report would have them."""

    def __init__(self, outputs: Outputs, named: Collection[str], *, unsafe: bool | None) -> None:
        """Begin with nothing written.

        *named* are the files of the run; *unsafe* tells whether the run trusts unsafe fixes.
        """
        self.written = set[str]()
        """The names of the files whose findings are written."""
        self.counting = outputs.streams and not (outputs.verbose or outputs.summarises)
        """True if nothing but their number is asked of findings that are written."""
        self._gathered: GatheredOutputs | None = None
        if outputs.copies and self.counting:
            from kinlint.cli.gathered_outputs import GatheredOutputs  # noqa: PLC0415  few runs

            self._gathered = GatheredOutputs(outputs.copies, large=True)
        self._outputs = outputs
        self._named = named
        self._unsafe = unsafe

    def tell(self, findings: Sequence[Finding]) -> None:
        """Write *findings*: all those of some files, which come before those of others."""
        report = Report(findings=tuple(findings), unsafe=self._unsafe)
        report = without_installed(report, self._named)
        self._outputs.begin(report, sys.stdout)
        if self._gathered is not None:
            self._gathered.add(report)
        self.written.update(each.location.source.name for each in findings)

    def conclude(self, report: Report) -> Outputs:
        """Write what was gathered, with the rest of *report*; return the other outputs."""
        if self._gathered is None:
            return self._outputs
        left = [each for each in report.findings if each.location.source.name not in self.written]
        with self._gathered as made:
            made.add(replace(report, findings=tuple(left)))
            made.conclude(report)
        return replace(self._outputs, copies=())
