"""Read, lint and, if asked, fix the files found; return the report."""

from __future__ import annotations

import os
import sys
from argparse import Namespace
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from kinlint.catalogue.rulebook import Rulebook
from kinlint.cli.progress import ProgressBar
from kinlint.cli.report_outputs import Outputs
from kinlint.configuration.selection import Policies
from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.files.url_mirror import mirrored
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.phases import Phases
from kinlint.project.discovery import Found
from kinlint.report import Report
from kinlint.reporters.terminal_style import When
from kinlint.rule import Severity
from kinlint.text import SourceText
from kinlint.vocabulary import METAMODELS, SH

if TYPE_CHECKING:
    from kinlint.cli.early_output import EarlyOutput
    from kinlint.cli.fix_files import Changes
    from kinlint.fixes.offers import Sieve
    from kinlint.fixes.rounds import RoundsResult
    from kinlint.parallel.runner import ParallelRunner


CLEAN, FOUND, ABNORMAL = 0, 1, 2
"""The exit codes."""
THRESHOLD = "warning"
"""The least severity that makes a run fail by default."""


def profiled(options: Namespace) -> bool:
    """Tell whether *options* ask for the time that each rule takes."""
    return bool(options.statistics and options.verbose > 1)


def process_count(options: Namespace) -> int:
    """Return the number of processes that *options* ask for, else that of processors.

    Rules are timed in this process, so it is the only one then.
    """
    return 1 if profiled(options) else options.jobs or os.cpu_count() or 1


@dataclass(frozen=True)
class LintRun:
    """A lint run as options ask for it."""

    settings: Settings
    """The settings."""
    found: Found
    """The files."""
    book: Rulebook
    """The rules."""
    phases: Phases
    """The stopwatch of the run."""
    watched: bool = False
    """True if progress is shown."""
    color: When = "auto"
    """The choice of `--color`, which progress follows."""
    read: list[SourceText] = field(default_factory=list)
    """The texts that were read, once they are."""
    paired: list[SourceText] = field(default_factory=list)
    """The texts of SRDF, with the robots by which they are judged."""
    early: EarlyOutput | None = None
    """The output that begins before the end, if it does."""
    _passed: list[SourceError] = field(default_factory=list)
    """Files that were passed over, and why they may have been meant."""

    def report(self, options: Namespace, outputs: Outputs, wanted: Sieve | None = None) -> Report:
        """The report for *outputs*; with `--fix` and its like, of what is left.

        Only findings that are *wanted* are fixed.
        """
        asides, new = self.found.asides, wanted
        if asides:
            from kinlint.cli import project_mode  # noqa: PLC0415  few runs leave files aside

            wanted = project_mode.exclude_asides(wanted, asides)
        if options.report_bug:
            from kinlint.cli.bug_report import write_reproducers  # noqa: PLC0415  kinlint rarely fails

            write_reproducers(
                *self.read_sources(), self.settings, self.book, Path(options.report_bug)
            )
        if options.add_ignore is not None:
            report = self._silenced(options, wanted)
        elif options.fix or options.fix_only or options.diff:
            report = self._mended(options, wanted)
        else:
            report = self.linted(
                process_count(options),
                fixing=outputs.tells_fixes,
                wanted=wanted,
                least=outputs.fixes_from,
                executor=options.executor or "",
            )
        if asides:
            report = project_mode.without_asides(report, asides, new)
        named = {one.name for one in self.found.inputs}
        if any(each.location.source.name not in named for each in report.findings):
            from kinlint.cli.installed_findings import without_installed  # noqa: PLC0415

            report = without_installed(report, named)
        return replace(
            report,
            unsafe=self.settings.unsafe_fixes,
            catalogue=self.book.digest,
            passed_over=tuple(self._passed),
        )

    def read_sources(
        self, bar: ProgressBar | None = None
    ) -> tuple[list[SourceText], list[SourceError]]:
        """The texts that were found, with what they were written for, and what cannot be read."""
        with self.phases.phase("imports"):
            from kinlint.formats.dependencies.companions import pair  # noqa: PLC0415
            from kinlint.project.reading import read_models  # noqa: PLC0415

        with self.phases.phase("decoding"):
            inputs = self.found.inputs if bar is None else bar.reading(self.found.inputs)
            sources, errors = read_models(inputs, self.settings, self._passed)
            if self.found.turtle:
                from kinlint.formats.options import ReadOptions  # noqa: PLC0415
                from kinlint.project.turtle_parts import TurtleParts, turtle_texts  # noqa: PLC0415

                texts = list(turtle_texts(self.found.turtle))
                reading = partial(ReadOptions.from_settings, self.settings)
                sources += TurtleParts().find(sources, texts, reading)
                if not sources:
                    why = "Turtle without a model that it is part of is read only where it is named"
                    models = (one for one in texts if METAMODELS in one.text and SH not in one.text)
                    self._passed.extend(SourceError(each.name, why) for each in models)
            sources = pair(sources, self.settings)
            if asides := self.found.asides:
                from kinlint.cli.project_mode import affecting_sources  # noqa: PLC0415

                sources = affecting_sources(sources, asides, self.settings)
            self.read[:] = sources
            self.paired[:] = (
                each
                for each in sources
                if each.pairing is not None or (each.format is not None and each.format.speaks_of)
            )
            return sources, [*self.found.errors, *errors]

    def _read_in_time(self, options: Namespace) -> tuple[list[SourceText], list[SourceError]]:
        """Return the texts and errors of `read_sources`, less the texts that take too long."""
        sources, failed = self.read_sources()
        if self.settings.file_timeout is None:
            return sources, failed
        from kinlint.errors import FileTimeout  # noqa: PLC0415
        from kinlint.parallel.runner import ParallelRunner  # noqa: PLC0415
        from kinlint.parallel.shard import Job  # noqa: PLC0415

        job = Job(self.settings, self.book, fixing=True)
        tried = ParallelRunner(job, process_count(options))
        found = tried.report(sources, failed).errors
        late = [each for each in found if isinstance(each, FileTimeout)]
        names = {each.name for each in late}
        return [each for each in sources if each.name not in names], [*failed, *late]

    def _mended(self, options: Namespace, wanted: Sieve | None) -> Report:
        from kinlint.cli import fix_files  # noqa: PLC0415  most runs change nothing

        inputs = self.found.inputs
        rounds = partial(
            fix_files.fix_in_rounds,
            least=fix_files.least_applicability(self.settings),
            streamed={one.name for one in inputs if one.path is None},
            kept=self.found.asides,
            wanted=wanted or fix_files.accept_all,
        )
        outcome, sources = self._changed_in_time(options, rounds)
        if outcome.restless and not options.silent:
            from kinlint.fixes.fix_circles import circle_warning  # noqa: PLC0415  most runs rest

            sys.stderr.write(f"kinlint: warning: {circle_warning(outcome.restless)}\n")
        if options.diff:
            fix_files.print_diffs(outcome.changed, options.color)
            return outcome.report
        report = fix_files.write_fixes(outcome, inputs)
        fix_files.write_streamed(sources, outcome.changed, inputs)
        return report

    def _silenced(self, options: Namespace, wanted: Sieve | None) -> Report:
        from kinlint.cli import add_ignore, fix_files  # noqa: PLC0415  most runs write nothing

        inputs = self.found.inputs
        rounds = partial(
            add_ignore.silence_in_rounds,
            reason=options.add_ignore or None,
            streamed={one.name for one in inputs if one.path is None},
            kept=self.found.asides,
            wanted=wanted or fix_files.accept_all,
        )
        outcome, sources = self._changed_in_time(options, rounds)
        return add_ignore.write_ignores(outcome, inputs, sources, silent=options.silent)

    def _changed_in_time(
        self, options: Namespace, rounds: Callable[..., RoundsResult]
    ) -> tuple[Changes, list[SourceText]]:
        """Return the outcome of *rounds*, and the texts; files that take too long are reported."""
        if self.settings.file_timeout is not None:
            from kinlint.parallel.shard import Job  # noqa: PLC0415  few runs have a limit
            from kinlint.parallel.timed_fixes import fix_in_time  # noqa: PLC0415

            sources, failed = self.read_sources()
            job = Job(self.settings, self.book, fixing=True)
            timed = fix_in_time(sources, failed, job, process_count(options), rounds)
            if timed is not None:
                return timed, sources
        sources, failed = self._read_in_time(options)
        return rounds(sources, failed, self.settings, self.book, phases=self.phases), sources

    def linted(
        self,
        jobs: int,
        *,
        fixing: bool,
        wanted: Sieve | None = None,
        least: Severity = Severity.INFO,
        executor: str = "",
    ) -> Report:
        """The report of *jobs* processes or *executor*; if *fixing*, with the fixes that it offers.

        Fixes are proven of findings of the severity *least* or more; where some are not *wanted*,
        of the others only, and afterwards.
        """
        with self.phases.phase("imports"):
            from kinlint.cache.report_cache import ReportCache  # noqa: PLC0415
            from kinlint.parallel.runner import ParallelRunner  # noqa: PLC0415
            from kinlint.parallel.shard import Job  # noqa: PLC0415  loads the readers

        first = fixing and wanted is None
        job = Job(self.settings, self.book, first, least=least, roots=mirrored())
        memory = None
        if not any(one.path is None for one in self.found.inputs):
            memory = ReportCache.from_settings(self.settings, self.book, fixing=first, least=least)
        with ProgressBar(len(self.found.inputs), wanted=self.watched, color=self.color) as bar:
            unread = None
            if executor or any(one.remote for one in self.found.inputs):
                from kinlint.parallel.survey import survey_found  # noqa: PLC0415

                unread = survey_found(self.found, job, jobs, executor, bar.advance, self._passed)
            sources, failed = unread or self.read_sources(bar)
            tell = partial(bar.step_aside, self.early.tell) if self.early is not None else None
            few = self.early is not None and self.early.counting
            parts = (job, jobs, memory, self.phases, bar.advance, executor, tell, few)
            report = ParallelRunner(*parts).report(sources, failed)
        if fixing and wanted is not None:
            keys = frozenset(each.key for each in wanted(report.findings) if each.rule.repairs)
            proving = replace(job, fixing=True, wanted=keys)
            report = _with_fixes(report, sources, ParallelRunner(proving, jobs, executor=executor))
        if report.files:
            return report
        # Nothing was read, so nothing decides which rules speak but what holds where kinlint runs.
        asked = Policies(self.settings, self.book.rules).enabled([""])
        return replace(report, rules=tuple(rule for rule in self.book.rules if rule.code in asked))


def _with_fixes(report: Report, sources: Sequence[SourceText], runner: ParallelRunner) -> Report:
    """Return *report* with the fixes that *runner* proves of what it wants, in these models."""
    from kinlint.parallel.partition import partition  # noqa: PLC0415  loads the readers

    names = {name for _, name, _, _ in runner.job.wanted or ()}
    models = partition(sources, runner.job.settings) if names else ()
    concerned = [model for model in models if any(each.name in names for each in model)]
    if not concerned:
        return report
    proven = runner.report([source for model in concerned for source in model], ())
    fixes = {each.key: each.fixes for each in proven.findings if each.fixes}
    findings = (replace(each, fixes=fixes.get(each.key, ())) for each in report.findings)
    return replace(report, findings=tuple(findings), unfixed=proven.unfixed)


def threshold(fail_on: str) -> Severity | None:
    """Return the least severity that makes a run fail; None if none does."""
    return None if fail_on == "none" else Severity[fail_on.upper()]


def exit_code(report: Report) -> int:
    """Return 2 if a file could not be read, 1 if findings make the run of *report* fail, else 0."""
    unparsed = any(one.rule.unparsable for one in report.unsuppressed)
    if report.errors or unparsed or (report.passed_over and not report.files):
        return ABNORMAL
    least = report.fails_from
    failed = least is not None and any(one.severity >= least for one in report.unsuppressed)
    return FOUND if failed else CLEAN
