"""Lints shares on an executor, such as a cluster, whose workers may go and come."""

from __future__ import annotations

import gc
import os
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from contextlib import chdir
from threading import Lock, Thread
from typing import Any, TypeVar

from kinlint.errors import KinlintError, SourceError
from kinlint.light_dataclasses import dataclass
from kinlint.parallel import shard
from kinlint.parallel.division import Task, TaskQueue
from kinlint.parallel.partition import Model
from kinlint.parallel.shard import Job, Outcome
from kinlint.parallel.unread import Survey, survey
from kinlint.project.discovery import Input

Done = TypeVar("Done")
PATIENCE = 5.0
"""Seconds between looks at whether there is still somebody who works."""
MOST_DROPPED = 50
"""Times in a row that an executor may drop all its tasks, as with workers that have the results."""
_alone = Lock()
"""Held by the thread of a worker that lints, since all its threads have one working directory."""


@dataclass(frozen=True)
class Workplace:
    """All that a worker needs to know beside the models, sent to it once."""

    job: Job
    """The settings and rules."""
    errors: Sequence[SourceError]
    """The errors in files that could not be decoded."""
    directory: str
    """The working directory, from which files are named."""


@dataclass(frozen=True)
class WorkerPool:
    """Workers that an executor reaches."""

    executor: Executor
    """The executor."""
    workplace: Any
    """A `Workplace`, or what the executor replaces by one on the worker."""
    width: Callable[[], int]
    """A function of no arguments: how many tasks are given at once now, waiting ones included."""
    lost: type[Exception]
    """Exception of a task that ended its worker each time that it was tried."""
    watch: Callable[[], None]
    """A function that raises KinlintError if nobody works any more."""

    def lint(
        self, shares: Sequence[Sequence[Model]], done: Callable[[int, list[Outcome]], None]
    ) -> None:
        """Lint *shares*; *done* is called with the number and the outcomes of each.

        What ends its workers is divided, as `TaskQueue.add_shares` says, and tried alone at the
        end: a worker takes with it what else it was given.
        """
        tasks, suspects = TaskQueue(), deque[Task]()
        tasks.add_shares(shares, done)
        pending: dict[Future[list[Outcome]], Task] = {}
        dropped = 0
        try:
            while tasks or suspects or pending:
                while tasks and len(pending) < self.width():
                    task = tasks.popleft()
                    pending[self._begin(task)] = task
                alone = not pending
                if alone:
                    task = suspects.popleft()
                    pending[self._begin(task)] = task
                finished, _ = wait(pending, PATIENCE, FIRST_COMPLETED)
                if not finished or any(each.cancelled() for each in finished):
                    self.watch()
                for each in finished:
                    task, dropped = pending.pop(each), dropped + 1 if each.cancelled() else 0
                    if dropped > MOST_DROPPED * self.width():
                        raise KinlintError("the executor drops all work that it takes")
                    if each.cancelled():
                        (suspects if alone else tasks).appendleft(task)
                    else:
                        suspects.extend(self._conclude(task, each, tasks, alone=alone))
        finally:
            for each in pending:
                each.cancel()

    def survey(self, chunks: Sequence[Sequence[Input]]) -> Iterator[Survey]:
        """Yield what workers see in *chunks*; what a lost one was at is looked at by others."""
        found, left = dict[int, Survey](), deque(range(len(chunks)))
        pending: dict[Future[Survey], int] = {}
        for number in range(len(chunks)):
            while number not in found:
                while left and len(pending) < self.width():
                    begun = left.popleft()
                    pending[self._look(chunks[begun])] = begun
                finished, _ = wait(pending, PATIENCE, FIRST_COMPLETED)
                if not finished or any(each.cancelled() for each in finished):
                    self.watch()
                for each in finished:
                    if each.cancelled():
                        left.appendleft(pending.pop(each))
                    else:
                        found[pending.pop(each)] = self._seen(each)
            yield found.pop(number)

    def _look(self, chunk: Sequence[Input]) -> Future[Survey]:
        return self.executor.submit(survey_at, self.workplace, chunk)

    def _seen(self, finished: Future[Survey]) -> Survey:
        try:
            return finished.result()
        except self.lost:
            raise KinlintError("--executor: each worker that read some files was lost") from None

    def _conclude(
        self, task: Task, finished: Future[list[Outcome]], tasks: TaskQueue, *, alone: bool
    ) -> Sequence[Task]:
        """Pass on what came of *task*; return what is to be tried alone, if it ended its worker."""
        try:
            outcomes = finished.result()
        except self.lost:
            if not alone and not task.is_divisible:
                return [task]
            waiting = len(tasks)
            task.done("each worker that linted it was lost")
            return [tasks.pop() for _ in range(len(tasks) - waiting)]
        except MemoryError:
            task.done("the worker that linted it has too little memory")
            return ()
        except KinlintError:
            raise
        except Exception as error:  # noqa: BLE001  of the executor: a worker raises no others
            raise KinlintError(f"--executor: {type(error).__name__}: {error}") from None
        task.done(outcomes)
        return ()

    def _begin(self, task: Task) -> Future[list[Outcome]]:
        return self.executor.submit(lint_at, self.workplace, task.models, task.errors)


def lint_at(
    workplace: Workplace, models: Sequence[Model], errors: Sequence[SourceError]
) -> list[Outcome]:
    """Return the outcomes of *models* at *workplace*; *errors* are of files of the same models.

    Raises KinlintError if this worker does not have the working directory, or fails otherwise: not
    every exception can be sent.
    """
    every = [*workplace.errors, *errors]
    return _done_at(workplace, lambda: shard.lint_shard(models, every, workplace.job))


def survey_at(workplace: Workplace, chunk: Sequence[Input]) -> Survey:
    """Return what is seen in *chunk* at *workplace*. Raises KinlintError as `lint_at` does."""
    job = workplace.job
    return _done_at(workplace, lambda: survey(job.settings, job.roots, chunk))


def _done_at(workplace: Workplace, work: Callable[[], Done]) -> Done:
    """Return what *work* returns at *workplace*, alone."""
    job = workplace.job
    if not os.path.isdir(workplace.directory) and not job.roots:  # noqa: PTH112  no path of this run
        raise KinlintError(f"a worker has no directory {workplace.directory}: it needs the files")
    try:
        with _alone, chdir("." if job.roots else workplace.directory):
            return _done_apart(work)
    except (KinlintError, MemoryError):
        raise
    except Exception as error:  # noqa: BLE001  see above
        raise KinlintError(f"a worker failed: {type(error).__name__}: {error}") from None


def _done_apart(work: Callable[[], Done]) -> Done:
    """Return what *work* returns in a thread that nobody looks into.

    Iterators of the engine can only be freed by the thread that made them. Dask samples the frames
    of threads that run its tasks, and frees those that end meanwhile; and any thread of a worker
    may be the one that looks for garbage next.
    """
    told = Future[Done]()

    def run() -> None:
        gc.disable()
        try:
            told.set_result(work())
        except BaseException as error:  # noqa: BLE001  whatever it is, it is raised below
            told.set_exception(error.with_traceback(None))
        finally:
            gc.collect()
            gc.enable()

    thread = Thread(target=run, daemon=True)
    thread.start()
    thread.join()
    return told.result()
