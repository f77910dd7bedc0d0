"""Output that begins before the end of a run: findings are written once they are final."""

from __future__ import annotations

import sys
from collections.abc import Collection, Sequence

from kinlint.cli.installed_findings import without_installed
from kinlint.cli.report_outputs import Outputs
from kinlint.finding import Finding
from kinlint.report import Report


class EarlyOutput:
    """Writes findings to standard output, as the report would have them."""

    def __init__(self, outputs: Outputs, named: Collection[str], *, unsafe: bool | None) -> None:
        """Begin with nothing written.

        *named* are the files of the run; *unsafe* tells whether the run trusts unsafe fixes.
        """
        self.written = set[str]()
        """The names of the files whose findings are written."""
        self.counting = not (outputs.copies or outputs.verbose or outputs.summarises)
        """True if nothing but their number is asked of findings that are written."""
        self._outputs = outputs
        self._named = named
        self._unsafe = unsafe

    def tell(self, findings: Sequence[Finding]) -> None:
        """Write *findings*: all those of some files, which come before those of others."""
        report = Report(findings=tuple(findings), unsafe=self._unsafe)
        self._outputs.begin(without_installed(report, self._named), sys.stdout)
        self.written.update(each.location.source.name for each in findings)
