"""A worker thread with a priority queue, separate from the thread of the protocol."""

from __future__ import annotations

import asyncio
import sys
import threading
from collections.abc import Callable
from concurrent.futures import Future
from itertools import count
from queue import PriorityQueue
from typing import Any, TypeVar

T = TypeVar("T")
LAST = -1
STACK = 1 << 26
"""Bytes of stack: what is nested deeply is read by recursion, and threads may get little."""
Job = tuple[int, int, "Future[Any]", Callable[[], Any]]


class Worker:
    """Does jobs one by one. The thread ends with the process, whatever it is at."""

    def __init__(self) -> None:
        self._jobs: PriorityQueue[Job] = PriorityQueue()
        self._numbers = count()
        before = threading.stack_size(STACK)
        self._thread = threading.Thread(target=self._work, name="kinlint", daemon=True)
        self._thread.start()
        threading.stack_size(before)

    def stop(self, seconds: float) -> bool:
        """Do no more jobs; whether the one that is being done ended within *seconds*."""
        self._jobs.put((LAST, next(self._numbers), Future(), sys.exit))
        self._thread.join(seconds)
        return not self._thread.is_alive()

    async def run(self, job: Callable[[], T], *, urgency: int = 0) -> T:
        """Return the result of *job*; jobs of lower *urgency* run first, then the older ones.

        A job that is cancelled before it starts is skipped; later, its result is dropped.
        """
        future: Future[T] = Future()
        self._jobs.put((urgency, next(self._numbers), future, job))
        return await asyncio.wrap_future(future)

    @property
    def has_waiting(self) -> bool:
        """Tell whether a job waits."""
        return not self._jobs.empty()

    def _work(self) -> None:
        while True:
            _, _, future, job = self._jobs.get()
            if not future.set_running_or_notify_cancel():
                continue
            if job is sys.exit:
                return
            try:
                result = job()
            except BaseException as error:  # noqa: BLE001  whoever waits for it gets it
                future.set_exception(error)
            else:
                future.set_result(result)
            del future, job
