"""Limit of the time that an analysis or a request takes in the thread that works for the server."""

from __future__ import annotations

import ctypes
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import TypeVar

T = TypeVar("T")
S = TypeVar("S")
ANALYSIS, REQUEST = 120.0, 30.0
"""Seconds that the analysis of a model may take, unless configured, and that a request may."""


class TimeOver(BaseException):
    """The time of the work is over; no handler of ordinary errors stops it."""


@contextmanager
def thread_limit(seconds: float) -> Iterator[None]:
    """Raise `TimeOver` in this thread when the block takes more than *seconds*.

    Python is interrupted between two instructions; native code ends first.
    """
    thread, lock, over = threading.get_ident(), threading.Lock(), False

    def interrupt() -> None:
        with lock:
            if not over:
                _raise(thread, ctypes.py_object(TimeOver))

    timer = threading.Timer(seconds, interrupt)
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
        with lock:
            over = True
            _raise(thread, None)


def answered(ask: Callable[[S], T], subject: S) -> T | None:
    """Return the answer of *ask* about *subject*; None if it takes longer than a request may."""
    try:
        with thread_limit(REQUEST):
            return ask(subject)
    except TimeOver:
        return None


def _raise(thread: int, error: ctypes.py_object[type[BaseException]] | None) -> None:
    """Have *thread* raise *error*, or none that is still to be raised."""
    ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(thread), error)
