"""Lints shares in processes that are killed when the time of a file is over.

The limit holds for all that is done with a text once it is decoded, native code and fixes included.
Where the system gives no processes, nothing limits the time.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from multiprocessing import Pipe, Process, connection
from multiprocessing.connection import Connection
from time import monotonic

from kinlint.errors import KinlintError, SourceError
from kinlint.light_dataclasses import dataclass, field
from kinlint.parallel import processes, shard
from kinlint.parallel.division import Answer, Task, TaskQueue
from kinlint.parallel.partition import Model
from kinlint.parallel.shard import Job, Outcome


@dataclass
class _Worker:
    """A process, and what it is at."""

    process: Process
    """The process."""
    pipe: Connection
    """The connection to it."""
    task: Task | None = None
    """Its task; None while it waits."""
    until: float = 0.0
    """Time, by the monotonic clock, at which the task has taken too long."""

    def give(self, task: Task, seconds: float) -> None:
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
    _tasks: TaskQueue = field(default_factory=TaskQueue)

    def lint(
        self, shares: Sequence[Sequence[Model]], done: Callable[[int, list[Outcome]], None]
    ) -> None:
        """Lint *shares*; *done* is called with the number and the outcomes of each.

        What takes longer than one model may is divided, as `TaskQueue.add_shares` says.
        """
        self._tasks.add_shares(shares, done)
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
