"""Lints shares in several processes."""

from __future__ import annotations

import gc
import os
import pickle
import signal
from collections.abc import Callable, Sequence
from threading import Thread
from typing import TYPE_CHECKING

from kinlint import garbage
from kinlint.errors import SourceError
from kinlint.parallel import shard
from kinlint.parallel.partition import Model
from kinlint.parallel.shard import Job, Outcome

if TYPE_CHECKING:
    from concurrent.futures import ProcessPoolExecutor

PATIENCE = 5.0
"""Seconds to wait for processes to end."""
_jobs: list[tuple[Job, Sequence[SourceError]]] = []
"""The job of this worker process, and the files that could not be decoded."""


def lint_in_processes(
    shares: Sequence[Sequence[Model]],
    errors: Sequence[SourceError],
    job: Job,
    processes: int,
    done: Callable[[int, list[Outcome]], None],
) -> bool:
    """Lint *shares* in at most so many *processes*.

    *done* is called with the number of each share and what came of it, in the order in which they
    are done. False where the system gives no processes, or takes one away: then some are not done.
    """
    try:
        from concurrent.futures import (  # noqa: PLC0415  slow to import
            ProcessPoolExecutor,
            as_completed,
        )
        from concurrent.futures.process import BrokenProcessPool  # noqa: PLC0415

        pool = ProcessPoolExecutor(
            min(processes, len(shares)), initializer=_begin, initargs=(job, errors)
        )
    except (ImportError, NotImplementedError, OSError, ValueError):
        return False
    try:
        pending = {pool.submit(_one, each): number for number, each in enumerate(shares)}
        for future in as_completed(pending):
            done(pending[future], future.result())
    except (BrokenProcessPool, OSError, pickle.PicklingError):
        _end(pool)
        return False
    except BaseException:
        _end(pool)
        raise
    pool.shutdown()
    return True


def _begin(job: Job, errors: Sequence[SourceError]) -> None:
    depend_on_parent()
    garbage.pass_over()
    _jobs.append((job, errors))


def depend_on_parent() -> None:
    """Leave interrupts to the process that began this one, and end when it ends."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    Thread(target=_outlive_nobody, daemon=True).start()


def _outlive_nobody() -> None:
    from multiprocessing import parent_process  # noqa: PLC0415

    if (parent := parent_process()) is not None:
        parent.join()
        os._exit(1)


def _end(pool: ProcessPoolExecutor) -> None:
    """End the processes of *pool* without waiting for what they are at."""
    from multiprocessing import active_children  # noqa: PLC0415

    processes, manager = active_children(), getattr(pool, "_executor_manager_thread", None)
    pool.shutdown(wait=False, cancel_futures=True)
    for process in processes:
        process.terminate()
    if manager is not None:
        # It closes pipes that the end of the interpreter would write to meanwhile, with an error.
        manager.join(PATIENCE)


def _one(models: Sequence[Model]) -> list[Outcome]:
    job, errors = _jobs[-1]
    outcomes = shard.lint_shard(models, errors, job)
    gc.collect()  # documents are circles of objects
    return outcomes
