"""A run over the files of several models: recalls what is known of them, and lints the others."""

from __future__ import annotations

import gc
from collections.abc import Callable, Sequence
from contextlib import AbstractContextManager, nullcontext, suppress
from time import perf_counter
from typing import TYPE_CHECKING

from kinlint.cache.report_cache import ReportCache
from kinlint.errors import FileTimeout, InternalError, SourceError
from kinlint.finding import Finding
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.parallel import shard
from kinlint.parallel.merge_reports import merge_reports
from kinlint.parallel.partition import Model, partition, split_in_order, split_into_shares
from kinlint.parallel.shard import Job, Outcome
from kinlint.parallel.unread import texts
from kinlint.phases import Phases
from kinlint.report import Report
from kinlint.suppression.suppression_faults import UNUSED
from kinlint.text import SourceText

if TYPE_CHECKING:
    from kinlint.parallel.early_findings import EarlyFindings

SHARES = 4
"""Number of shards for each process, so that none waits long for the last one."""


def _nobody(_files: int) -> None:
    """Hears of progress where nobody watches it."""


@dataclass(frozen=True)
class ParallelRunner:
    """A runner of a lint job in several processes."""

    job: Job
    """Settings and rules."""
    jobs: int = 1
    """Number of processes."""
    memory: ReportCache | None = None
    """The cache of reports, if it may be used."""
    phases: Phases = field(default_factory=Phases)
    """The stopwatch of the run."""
    advance: Callable[[int], None] = _nobody
    """A function that is called with the number of files done."""
    executor: str = ""
    """The address of the cluster that lints, `dask://HOST:PORT`; empty for processes here."""
    tell: Callable[[Sequence[Finding]], None] | None = None
    """A function that is told findings as soon as it is clear that none comes before them."""
    counting: bool = False
    """True if of findings that were told only their number is kept."""

    def report(self, sources: Sequence[SourceText], errors: Sequence[SourceError]) -> Report:
        """Lint *sources*; *errors* are of files that could not even be decoded.

        The report is that of one process which lints all of them.
        """
        started = perf_counter()
        models = partition(sources, self.job.settings)
        early = None
        if self.tell is not None and len(models) > 1:
            from kinlint.parallel.early_findings import EarlyFindings  # noqa: PLC0415  few outputs

            early = EarlyFindings(models, self.tell)
        reports, recalled = self._reports(models, (), early)
        own = [error for report in reports for error in report.errors]
        place = {source.name: index for index, source in enumerate(sources)}
        own.sort(key=lambda error: place.get(error.name, len(place)))
        failed = [*errors, *own]
        if failed:
            # No suppression is called unused unless everything could be read.
            again = [n for n, one in enumerate(reports) if not one.errors and _calls_unused(one)]
            changed, _ = self._reports([models[n] for n in again], failed)
            for number, report in zip(again, changed, strict=True):
                reports[number] = report
        if self.memory is not None:
            self.memory.close()
        seconds = perf_counter() - started
        known = None if self.memory is None else recalled
        return merge_reports(reports, [source.name for source in sources], failed, seconds, known)

    def _reports(
        self,
        models: Sequence[Model],
        failed: Sequence[SourceError],
        early: EarlyFindings | None = None,
    ) -> tuple[list[Report], int]:
        """The report of each of *models*, and how many files' were recalled.

        *failed* are errors in other files of the run. What is final is told *early*.
        """

        def done(number: int, report: Report) -> None:
            found[number] = report
            if early is not None and not _calls_unused(report):
                told = early.done(number, report)
                if self.counting:
                    from kinlint.parallel.early_findings import counted  # noqa: PLC0415  see above

                    found.update((each, counted(found[each])) for each in told)

        found: dict[int, Report] = {}
        if self.memory is not None:
            with self.phases.phase("recalling"):
                for number, model in enumerate(models):
                    report = self._recalled(self.memory, model, failed)
                    if report is not None:
                        done(number, report)
                        self._advance(model, failed)
        recalled = sum(len(models[number]) for number in found)
        left = [number for number in range(len(models)) if number not in found]

        def linted(number: int, outcome: Outcome) -> None:
            done(left[number], self._with_own_rules(outcome.report))
            failures = (
                isinstance(error, (InternalError, FileTimeout)) for error in outcome.report.errors
            )
            if self.memory is not None and not any(failures):
                with suppress(SourceError):
                    read = texts(models[left[number]])
                    self.memory.keep(read, outcome.report, outcome.record, complete=not failed)

        self._lint([models[n] for n in left], failed, linted, in_order=early is not None)
        return [found[number] for number in range(len(models))], recalled

    def _with_own_rules(self, report: Report) -> Report:
        """Return *report* with the rules of this process, not the copies that a worker sends."""
        own = {rule.code: rule for rule in self.job.book.rules}
        if all(own.get(rule.code, rule) is rule for rule in report.rules):
            return report

        def told(findings: Sequence[Finding]) -> tuple[Finding, ...]:
            return tuple(replace(one, rule=own.get(one.rule.code, one.rule)) for one in findings)

        return replace(
            report,
            rules=tuple(own.get(rule.code, rule) for rule in report.rules),
            findings=told(report.findings),
            suppressed=told(report.suppressed),
        )

    def _recalled(
        self, memory: ReportCache, model: Model, failed: Sequence[SourceError]
    ) -> Report | None:
        try:
            return memory.recall(texts(model), complete=not failed)
        except SourceError:
            return None  # whoever lints it says why

    def _lint(
        self,
        models: Sequence[Model],
        failed: Sequence[SourceError],
        linted: Callable[[int, Outcome], None],
        *,
        in_order: bool,
    ) -> None:
        """Lint *models*; *linted* is called with the number of each and its outcome.

        If *in_order*, about in the order of the names of their files, else the largest first.
        """
        least = self.jobs * SHARES if self.jobs > 1 or self.executor else 1
        split = split_in_order if in_order else split_into_shares
        planned = split(models, least, self.job.settings, recorded=self.memory is not None)
        left = [[models[number] for number in each] for each in planned]
        finished = set[int]()

        def done(number: int, outcomes: list[Outcome]) -> None:
            finished.add(number)
            for model, outcome in zip(planned[number], outcomes, strict=True):
                linted(model, outcome)
                self._advance(models[model], failed)

        if left and self.executor:
            from kinlint.parallel.dask_cluster import worker_pool  # noqa: PLC0415  few runs

            with self.phases.phase("linting"), worker_pool(self.executor, self.job, failed) as pool:
                pool.lint(left, done)
        elif left and (seconds := self.job.settings.file_timeout):
            from kinlint.parallel.timed_processes import TimedProcesses  # noqa: PLC0415  few runs

            with self.phases.phase("linting"):
                TimedProcesses(self.job, failed, self.jobs, seconds).lint(left, done)
        elif self.jobs > 1 and len(left) > 1:
            from kinlint.parallel import processes  # noqa: PLC0415  small runs are one process

            with self.phases.phase("linting"):
                processes.lint_in_processes(left, failed, self.job, self.jobs, done)
        with _collecting() if len(left) > 1 else nullcontext():
            for number, each in enumerate(left):
                if number not in finished:
                    done(number, shard.lint_shard(each, failed, self.job, self.phases))
                    if number < len(left) - 1:
                        gc.collect()  # documents are circles of objects

    def _advance(self, model: Model, failed: Sequence[SourceError]) -> None:
        if not failed:  # What is linted anew was counted before.
            self.advance(len(model))


def _collecting() -> AbstractContextManager[None]:
    from kinlint import garbage  # noqa: PLC0415  a recalled report makes none

    return garbage.only_new()


def _calls_unused(report: Report) -> bool:
    return any(one.rule.name == UNUSED for one in (*report.findings, *report.suppressed))
