"""Fixes the files of a run, none of which makes the others wait."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Sequence
from multiprocessing import get_start_method
from time import perf_counter
from typing import NamedTuple

from kinlint.errors import SourceError
from kinlint.fixes.rounds import RoundsResult
from kinlint.light_dataclasses import replace
from kinlint.parallel.merge_reports import merge_reports
from kinlint.parallel.partition import partition
from kinlint.parallel.shard import Job, Outcome
from kinlint.parallel.timed_processes import TimedProcesses
from kinlint.report import Report
from kinlint.text import SourceText


class FixedTexts(NamedTuple):
    """The outcome of fixing the files of a run."""

    report: Report
    """The report on the changed texts."""
    changed: Sequence[tuple[SourceText, SourceText]]
    """The texts that changed, before and after."""
    restless: Sequence[str]
    """The rules, by their codes, whose fixes undo or feed each other, and are not made."""


def fix_in_time(
    sources: Sequence[SourceText],
    errors: Sequence[SourceError],
    job: Job,
    jobs: int,
    rounds: Callable[..., RoundsResult],
) -> FixedTexts | None:
    """Return the outcome of *rounds* over each model of *sources*, in at most *jobs* processes.

    Files that take longer than the settings of *job* allow are reported and stay as they are.
    *errors* are of files that could not be decoded. None where processes cannot be told how to fix.
    """
    started = perf_counter()
    job = replace(job, rounds=rounds)
    if get_start_method() != "fork" and not _may_be_sent(job):
        return None
    models = partition(sources, job.settings)
    found: dict[int, Outcome] = {}

    def done(number: int, outcomes: list[Outcome]) -> None:
        found[number] = outcomes[0]

    seconds = job.settings.file_timeout
    assert seconds is not None
    TimedProcesses(job, errors, jobs, seconds).lint([[each] for each in models], done)
    every = [found[number] for number in range(len(models))]
    place = {source.name: index for index, source in enumerate(sources)}
    own = [error for each in every for error in each.report.errors]
    own.sort(key=lambda error: place.get(error.name, len(place)))
    reports = [each.report for each in every] or [Report()]
    failed = [*errors, *own]
    report = merge_reports(reports, [*place], failed, perf_counter() - started)
    changed = [change for each in every for change in each.changed]
    return FixedTexts(report, changed, sorted({code for each in every for code in each.restless}))


def _may_be_sent(job: Job) -> bool:
    try:
        pickle.dumps(job)
    except (pickle.PicklingError, AttributeError, TypeError):
        return False
    return True
