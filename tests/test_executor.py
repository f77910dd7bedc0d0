"""Executors: what workers report that come and go is what one process reports."""

from __future__ import annotations

from concurrent.futures import Executor, Future
from pathlib import Path

import pytest
from support.linting import book, source

from kinlint.configuration.settings import Settings
from kinlint.parallel.executor import WorkerPool, Workplace
from kinlint.parallel.runner import ParallelRunner
from kinlint.parallel.shard import Job

ROBOT = '<robot name="{0}"><link name="a"/><joint name="j"><parent link="a"/></joint></robot>'
POISON = "poison.urdf"


class WorkerLost(Exception):
    """A worker ended with its task."""


class Workers(Executor):
    """Workers that end with any task that has the poisonous file, and with two given after it.

    The result of one task is lost with the worker that had it.
    """

    def __init__(self) -> None:
        self.given: list[list[str]] = []
        self.lost: set[str] = set()
        self.beside = 0

    def submit(self, function, workplace, models, errors):  # type: ignore[override]
        names = [each.name for model in models for each in model]
        self.given.append(names)
        poisonous = POISON in names
        future: Future = Future()
        if poisonous or (self.beside and self.lost.isdisjoint(names)):
            self.beside = 2 if poisonous else self.beside - 1
            self.lost.update(names)
            future.set_exception(WorkerLost())
        elif names == ["r3.urdf"] and self.given.count(names) == 1:
            future.cancel()
            future.set_running_or_notify_cancel()
        else:
            future.set_result(function(workplace, models, errors))
        return future


def lint_with(workers: Workers, sources, monkeypatch):
    """Return the report of *workers* on *sources*."""
    job = Job(Settings(), book())
    runner = ParallelRunner(job, jobs=4)

    def lint(models, failed, linted, *, in_order):
        del in_order
        place = Workplace(job, failed, str(Path.cwd()))
        shares = [[model, *models[n + 1 : n + 2]] for n, model in enumerate(models)][::2]

        def done(number, outcomes):
            for offset, outcome in enumerate(outcomes):
                linted(2 * number + offset, outcome)

        WorkerPool(workers, place, lambda: 3, WorkerLost, lambda: None).lint(shares, done)

    monkeypatch.setattr(ParallelRunner, "_lint", lambda _, *given, **more: lint(*given, **more))
    return runner.report(sources, ())


@pytest.mark.slow
def test_lost_workers_lose_nothing(monkeypatch):
    """Tasks that were given beside the poisonous one are judged; its file alone is an error."""
    texts = [source(ROBOT.format(f"r{n}"), f"r{n}.urdf") for n in range(7)]
    alone = ParallelRunner(Job(Settings(), book())).report(texts, ())
    workers = Workers()
    report = lint_with(workers, [source(ROBOT.format("p"), POISON), *texts], monkeypatch)
    assert [str(each) for each in report.errors] == [
        f"{POISON}: each worker that linted it was lost"
    ]
    assert report.findings == alone.findings
    assert alone.findings
    assert report.files == alone.files
    assert len(workers.lost) > 2
    assert workers.given.count([POISON]) == 1


@pytest.mark.slow
def test_a_file_for_which_a_worker_lacks_memory_is_reported_and_no_other(monkeypatch):
    texts = [source(ROBOT.format(f"r{n}"), f"r{n}.urdf") for n in range(5)]
    alone = ParallelRunner(Job(Settings(), book())).report(texts, ())

    class Narrow(Workers):
        def submit(self, function, workplace, models, errors):  # type: ignore[override]
            if POISON not in [each.name for model in models for each in model]:
                return super().submit(function, workplace, models, errors)
            full: Future = Future()
            full.set_exception(MemoryError())
            return full

    report = lint_with(Narrow(), [source(ROBOT.format("p"), POISON), *texts], monkeypatch)
    assert [str(each) for each in report.errors] == [
        f"{POISON}: the worker that linted it has too little memory"
    ]
    assert report.findings == alone.findings
