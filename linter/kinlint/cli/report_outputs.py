"""Writes a report: one format to standard output or a file, others to files of their own."""

from __future__ import annotations

import os
import sys
from collections.abc import Collection
from pathlib import Path
from typing import TextIO

from kinlint.cli.output_files import replacing
from kinlint.errors import UsageError
from kinlint.light_dataclasses import dataclass, replace
from kinlint.report import Report
from kinlint.reporters.display_width import printable
from kinlint.reporters.reporter_registry import (
    FORMATS,
    gathers,
    write,
    write_fixed,
    write_statistics,
    write_summary,
    write_verdict,
)
from kinlint.reporters.terminal_style import Style, When, detect_style
from kinlint.rule import Severity

SUMMARY = "GITHUB_STEP_SUMMARY"
"""The variable that names the file in which GitHub expects the summary of a step."""


@dataclass(frozen=True, slots=True)
class Outputs:
    """The outputs of a run."""

    main: str
    """The format of the main report."""
    path: Path | None = None
    """The file of the main report; None for standard output."""
    copies: tuple[tuple[str, Path], ...] = ()
    """Further formats, each with its file."""
    show: Severity = Severity.INFO
    """Least severity of the findings that formats for people show."""
    color: When = "auto"
    """Choice of when reports are coloured."""
    statistics: bool = False
    """True if numbers of findings by rule are printed."""
    quiet: bool = False
    """True if there is no summary."""
    silent: bool = False
    """True if nothing is printed but errors."""
    verbose: bool = False
    """True if the run is described, too."""
    show_fixes: bool = False
    """True if the fixes that were made are listed."""
    only_fixes: bool = False
    """True if what was not fixed is omitted."""
    would: bool = False
    """True if fixes were shown, not made."""

    @property
    def tells_fixes(self) -> bool:
        """Tell whether any output contains fixes."""
        formats = [FORMATS[name] for name in self._written]
        summed = not (self.quiet or self.silent) and any(not each.machine for each in formats)
        return summed or self._tabulates or any(each.fixes for each in formats)

    @property
    def fixes_from(self) -> Severity:
        """Least severity of findings whose fixes are told; what is not shown is only counted."""
        machine = any(FORMATS[name].machine for name in self._written)
        return Severity.INFO if machine or self._tabulates or self.verbose else self.show

    @property
    def _tabulates(self) -> bool:
        """Tell whether a table counts what can be fixed, of all severities."""
        return self.statistics and not self.silent

    @property
    def watched(self) -> bool:
        """Tell whether the report is for people, who may want to see progress."""
        return not (self._machine or self.quiet or self.silent)

    @property
    def shows_structure(self) -> bool:
        """Tell whether any output shows the structure of robots."""
        return self.summarises or any(FORMATS[name].drawn for name in self._written)

    @property
    def begins_early(self) -> bool:
        """Tell whether findings can be written one by one, before all are known."""
        apart = self.path is not None or self.silent or self.statistics or self.only_fixes
        return FORMATS[self.main].early and not apart

    @property
    def streams(self) -> bool:
        """Tell whether nothing that is written needs all findings at once."""
        large = (gathers(*each) for each in self.copies)
        shown = self.begins_early or (self.silent and not self.statistics)
        return shown and self.path is None and all(large)

    def begin(self, report: Report, out: TextIO) -> None:
        """Write the findings of *report*, a part, in the main format, and see that they arrive."""
        self._write(report, self.main, out)
        out.flush()

    def emit(
        self, report: Report, out: TextIO | None = None, written: Collection[str] = ()
    ) -> None:
        """Write *report* everywhere; what a machine format leaves unsaid goes to stderr.

        *out* is standard output, or what takes its place where it has something else; findings in
        the files *written* are there. A file that cannot be written raises `UsageError` when the
        others are.
        """
        out = out or sys.stdout
        told = replace(report, findings=()) if self.only_fixes else report
        failures: list[UsageError] = []
        for name, path in self.copies:
            try:
                if gathers(name, path):
                    _gather(told, name, path)
                    continue
                with replacing(path) as stream:
                    self._write(told, name, stream)
                    if not FORMATS[name].machine:
                        self._conclude(report.shown_from(self.show), stream)
            except UsageError as error:
                failures.append(error)
        if self.path is not None and gathers(self.main, self.path):
            _gather(told, self.main, self.path)
        elif self.path is not None:
            with replacing(self.path) as stream:
                self._main(report, told, stream)
        elif not self.silent:
            left = (one for one in told.findings if one.location.source.name not in written)
            self._main(report, replace(told, findings=tuple(left)) if written else told, out)
        self._aside(report, told, out)
        if self.summarises:
            from kinlint.cli.github_step_summary import append  # noqa: PLC0415  only on GitHub

            append(told, Path(os.environ[SUMMARY]))
        if failures:
            raise failures[0]

    def _main(self, report: Report, told: Report, stream: TextIO) -> None:
        if self.statistics and not self._machine:
            write_statistics(told, stream, self._style(stream))
        else:
            self._write(told, self.main, stream)
        if not self._machine:
            self._conclude(report if self.statistics else report.shown_from(self.show), stream)

    def _write(self, report: Report, name: str, stream: TextIO) -> None:
        """Write *report* in the format called *name*, without a summary."""
        if not FORMATS[name].machine:
            report = replace(report.shown_from(self.show), derived=self.verbose)
        write(report, name, stream, self._style(stream), summarise=False)

    def _aside(self, report: Report, told: Report, out: TextIO) -> None:
        """Write to standard error what standard output leaves out."""
        if self.path is not None or self.silent or self._machine or self.statistics:
            for error in report.errors:
                sys.stderr.write(f"kinlint: error: {printable(str(error))}\n")
        if self.silent or not self._machine or (self.path is None and out is sys.stderr):
            return
        if self.statistics:
            write_statistics(told, sys.stderr, self._style(sys.stderr))
        self._conclude(report, sys.stderr)

    def _conclude(self, report: Report, stream: TextIO) -> None:
        """Say what was fixed, if that is asked for, and what the run amounts to."""
        style = self._style(stream)
        if self.show_fixes:
            write_fixed(report, stream, style, would=self.would)
        if self.quiet or self.silent:
            return
        if self.only_fixes:
            write_verdict(report, stream, would=self.would)
        else:
            write_summary(report, stream, style, verbose=self.verbose)

    def _style(self, stream: TextIO) -> Style:
        return detect_style(stream, self._color(stream))

    def _color(self, stream: TextIO) -> When:
        return self.color if stream in (sys.stdout, sys.stderr) else "auto"

    @property
    def _written(self) -> list[str]:
        copies = [name for name, _ in self.copies]
        return copies if self.path is None and self.silent else [self.main, *copies]

    @property
    def summarises(self) -> bool:
        """Tell whether GitHub shows a summary of this step beside the annotations."""
        return "github" in self._written and bool(os.environ.get(SUMMARY))

    @property
    def _machine(self) -> bool:
        return FORMATS[self.main].machine


def _gather(report: Report, name: str, path: Path) -> None:
    """Write the findings of *report* to a database or in parts. Raises `UsageError`."""
    from kinlint.cli.gathered_outputs import GatheredOutputs  # noqa: PLC0415  few runs do

    with GatheredOutputs([(name, path)], large=False) as made:
        made.add(report)
        made.conclude(report)
