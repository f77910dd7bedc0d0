"""The workers of a Dask cluster (https://distributed.dask.org), which run shares of a run."""

from __future__ import annotations

import os
import pickle
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import CancelledError, Executor, Future
from contextlib import contextmanager, suppress
from functools import partial
from time import monotonic
from typing import Any

from kinlint import __version__
from kinlint.errors import KinlintError, SourceError, UsageError
from kinlint.files.url_mirror import end
from kinlint.parallel.executor import WorkerPool, Workplace
from kinlint.parallel.shard import Job

SCHEME = "dask://"
TIMEOUT = 10
"""Seconds in which a scheduler answers."""
GRACE = 60
"""Seconds in which workers are expected to come, or to come back if they are lost."""
WAITING = 3
"""Number of tasks that wait for each thread that works on one."""


@contextmanager
def worker_pool(address: str, job: Job, errors: Sequence[SourceError]) -> Iterator[WorkerPool]:
    """Give the workers of the cluster at *address*, `dask://HOST:PORT`, which know *job*.

    Raises UsageError without Dask, and KinlintError if nobody is there or has another version.
    """
    if job.settings.file_timeout:
        raise UsageError("--executor: file-timeout holds for processes here only; set it to 0")
    try:
        import distributed  # noqa: PLC0415  few runs use a cluster
    except ImportError:
        raise UsageError("--executor dask://: pip install 'kinlint[dask]'") from None
    place = address.removeprefix(SCHEME)
    try:
        connect: Any = distributed.Client
        client = connect(f"tcp://{place}", timeout=TIMEOUT, set_as_default=False)
    except (OSError, ValueError) as error:
        raise KinlintError(f"--executor: no scheduler answers at {address}: {error}") from None
    with client:
        _compare(client)
        # A task's result is worked out again if all workers that hold it are lost; data is not.
        known = pickle.dumps(Workplace(job, errors, os.getcwd()))  # noqa: PTH109  as files are named
        workplace = client.submit(pickle.loads, known, pure=False)
        seen = monotonic()

        def threads() -> int:
            """Return how many threads lint; 0 while all workers are lost, or the scheduler is."""
            with suppress(OSError):
                return sum(client.nthreads().values()) if client.status == "running" else 0
            return 0

        def watch() -> None:
            nonlocal seen
            if threads():
                seen = monotonic()
            elif monotonic() - seen > GRACE:
                raise KinlintError(f"--executor: {address} has had no workers for {GRACE} s")

        try:
            yield WorkerPool(
                _Cluster(client),
                workplace,
                lambda: max(1, threads()) * (1 + WAITING),
                distributed.KilledWorker,
                watch,
            )
        finally:
            if job.roots and client.status == "running":
                client.run(end, job.roots, on_error="ignore")


class _Cluster(Executor):
    """Gives tasks to *client*, and waits on where a worker is lost with the result of one.

    `Client.get_executor` does not: it takes the result, which is worked out again, for an error.
    """

    def __init__(self, client: Any) -> None:
        self._client = client
        self._given = dict[Future[Any], Any]()

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Let a worker call *fn*."""
        told = Future[Any]()
        # A result is kept on its worker as long as there is somebody who refers to it.
        given = self._given[told] = self._client.submit(fn, *args, **kwargs, pure=False)
        given.add_done_callback(partial(self._conclude, told))
        return told

    def _conclude(self, told: Future[Any], given: Any) -> None:
        try:
            result = given.result()
        except CancelledError:
            told.cancel()
            told.set_running_or_notify_cancel()  # wakes those who wait
        except Exception as error:  # noqa: BLE001  whatever the worker raised
            if told.set_running_or_notify_cancel():
                told.set_exception(error)
        else:
            if told.set_running_or_notify_cancel():
                told.set_result(result)
        finally:
            del self._given[told]


def _compare(client: Any) -> None:
    """Raise KinlintError unless all workers that answer have this version of kinlint.

    There may be none yet, and those that are lost meanwhile do not answer.
    """
    for worker, version in client.run(_version, on_error="return").items():
        if isinstance(version, ImportError | AttributeError):
            raise KinlintError(f"--executor: the worker {worker} lacks kinlint: {version}")
        if isinstance(version, str) and version != __version__:
            raise KinlintError(
                f"--executor: the worker {worker} has kinlint {version}, this is {__version__}"
            )


def _version() -> str:
    return __version__
