"""Lints shares in processes that are killed when the time of a file is over.

The limit holds for all that is done with a text once it is decoded, native code and fixes included.
Where the system gives no processes, nothing limits the time.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from functools import partial
from multiprocessing import Pipe, Process, connection
from multiprocessing.connection import Connection
from time import monotonic
from typing import TypeAlias

from kinlint.errors import FileTimeout, KinlintError, SourceError
from kinlint.files.tracked_io import Record
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.parallel import processes, shard
from kinlint.parallel.partition import Model
from kinlint.parallel.shard import Job, Outcome
from kinlint.report import Report
from kinlint.text import SourceText

Answer: TypeAlias = list[Outcome] | str
"""Outcomes of a task, or why there are none."""


@dataclass
class _Task:
    """Models for one process, and what to do with their outcomes."""

    models: Sequence[Model]
    """The models."""
    done: Callable[[Answer], None]
    """A function of the outcomes, or of why there are none."""
    errors: Sequence[SourceError] = ()
    """The errors in other files of the same model."""

    @property
    def files(self) -> int:
        """The number of files that are judged together, at most."""
        return max(map(len, self.models))


@dataclass
class _Worker:
    """A process, and what it is at."""

    process: Process
    """The process."""
    pipe: Connection
    """The connection to it."""
    task: _Task | None = None
    """Its task; None while it waits."""
    until: float = 0.0
    """Time, by the monotonic clock, at which the task has taken too long."""

    def give(self, task: _Task, seconds: float) -> None:
        """Begin *task*, of which each file may take *seconds*."""
        self.task, self.until = task, monotonic() + seconds * task.files
        with suppress(OSError):  # A process that is gone has no answer either.
            self.pipe.send((task.models, task.errors))

    def answer(self) -> Answer | Exception:
        """Return what the process answers; an error is one that ends the run."""
        try:
            received: list[Outcome] | Exception = self.pipe.recv()
        except (EOFError, OSError):
            self.process.join()
            return f"the process that linted it ended with {self.process.exitcode}"
        return received

    def end(self) -> None:
        """Kill the process and wait for its end."""
        self.process.kill()
        self.process.join()
        self.pipe.close()


@dataclass
class TimedProcesses:
    """Processes that lint *job*; *errors* are of files that could not be decoded."""

    job: Job
    """The files and settings to lint with."""
    errors: Sequence[SourceError]
    """The errors in files that could not be decoded."""
    count: int
    """The largest number of processes at once."""
    seconds: float
    """The time that a file may take."""
    _tasks: deque[_Task] = field(default_factory=deque)

    def lint(
        self, shares: Sequence[Sequence[Model]], done: Callable[[int, list[Outcome]], None]
    ) -> None:
        """Lint *shares*; *done* is called with the number and the outcomes of each.

        A share that takes longer than one of its models may is divided into models; a model that
        does, into files. Those files that take too long by themselves are reported, and the others
        judged as if these could not be read; if there is none, all are reported.
        """
        for number, each in enumerate(shares):
            self._tasks.append(self._share(each, partial(done, number)))
        with self._workers() as workers:
            while self._tasks or any(each.task for each in workers):
                self._turn(workers)

    def _turn(self, workers: list[_Worker]) -> None:
        """Give tasks to idle processes, and wait for the next answer or end of time."""
        for worker in workers:
            if worker.task is None and self._tasks:
                worker.give(self._tasks.popleft(), self.seconds)
        busy = {each.pipe: each for each in workers if each.task}
        patience = max(0.0, min(each.until for each in busy.values()) - monotonic())
        ready = {*connection.wait([*busy], patience)}
        for pipe, worker in busy.items():
            over = monotonic() >= worker.until
            if pipe not in ready and not over:
                continue
            late = f"not linted within {self.seconds:g} s (--file-timeout)"
            task, answer = worker.task, worker.answer() if pipe in ready else late
            worker.task = None
            if isinstance(answer, str):
                worker.end()
                workers[workers.index(worker)] = self._started()
            if isinstance(answer, Exception):
                raise answer
            if task is not None:
                task.done(answer)

    @contextmanager
    def _workers(self) -> Iterator[list[_Worker]]:
        found: list[_Worker] = []
        try:
            found.extend(self._started() for _ in range(min(self.count, len(self._tasks))))
            yield found
        finally:
            for each in found:
                each.end()

    def _started(self) -> _Worker:
        here, there = Pipe()
        process = Process(target=_work, args=(there, self.job, self.errors), daemon=True)
        process.start()
        there.close()
        return _Worker(process, here)

    def _share(self, models: Sequence[Model], done: Callable[[list[Outcome]], None]) -> _Task:
        """Return the task to lint *models*, one by one if that takes too long."""
        if len(models) == 1:
            return self._model(models[0], lambda outcome: done([outcome]))
        found: dict[int, Outcome] = {}

        def one(number: int, outcome: Outcome) -> None:
            found[number] = outcome
            if len(found) == len(models):
                done([found[each] for each in range(len(models))])

        def divided(answer: Answer) -> None:
            if not isinstance(answer, str):
                done(answer)
                return
            for number, model in enumerate(models):
                self._tasks.append(self._model(model, partial(one, number)))

        return _Task(models, divided)

    def _model(self, model: Model, done: Callable[[Outcome], None]) -> _Task:
        """Return the task to lint *model*, without the files that take too long by themselves."""
        return _Task([model], _Division(model, done, self._tasks.append).whole)


@dataclass
class _Division:
    """A model that is linted as a whole or, if that takes too long, less its slow files."""

    model: Model
    """The model."""
    done: Callable[[Outcome], None]
    """A function of the outcome."""
    add: Callable[[_Task], None]
    """A function that adds a task."""
    _slow: dict[str, str] = field(default_factory=dict)
    _quick: list[SourceText] = field(default_factory=list)

    def whole(self, answer: Answer) -> None:
        """Take the *answer* for the whole model."""
        if not isinstance(answer, str):
            self.done(answer[0])
        elif len(self.model) == 1:
            self._give_up(answer)
        else:
            for source in self.model:
                self.add(_Task([[source]], partial(self._alone, source, answer)))

    def _alone(self, source: SourceText, why: str, answer: Answer) -> None:
        """Take the *answer* for *source* alone; *why* there was none for the whole model."""
        if isinstance(answer, str):
            self._slow[source.name] = answer
        else:
            self._quick.append(source)
        if len(self._slow) + len(self._quick) < len(self.model):
            return
        if not self._slow or not self._quick:
            self._give_up(why)
            return
        failed = _given_up(self._slow, self.model).report.errors
        others = [each for each in self.model if each.name not in self._slow]
        self.add(_Task([others], partial(self._others, failed), failed))

    def _others(self, failed: Sequence[SourceError], answer: Answer) -> None:
        """Take the *answer* for the files that are not slow; *failed* are the errors of these."""
        if isinstance(answer, str):
            self._give_up(answer)
            return
        report = replace(answer[0].report, errors=(*failed, *answer[0].report.errors))
        self.done(answer[0]._replace(report=report))

    def _give_up(self, why: str) -> None:
        self.done(_given_up({each.name: why for each in self.model}, self.model))


def _given_up(reasons: Mapping[str, str], model: Model) -> Outcome:
    """Return the outcome of *model*, of which some files are given up, for *reasons* by name."""
    others = len(model) - 1
    beside = f", checked with {others} other{'s' * (others > 1)}" if others else ""
    errors = tuple(FileTimeout(name, f"{why}{beside}") for name, why in reasons.items())
    return Outcome(Report(errors=errors), Record())


def _work(pipe: Connection, job: Job, errors: Sequence[SourceError]) -> None:
    """Answer tasks until there are no more."""
    processes.depend_on_parent()
    with suppress(EOFError, OSError):
        while True:
            models, more = pipe.recv()
            try:
                pipe.send(shard.lint_shard(models, [*errors, *more], job))
            except (KinlintError, MemoryError) as error:
                pipe.send(error)
