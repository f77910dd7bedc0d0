"""Limit of the time that one file takes in the main thread, where its text is recognised."""

from __future__ import annotations

import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType

from kinlint.errors import FileTimeout


@contextmanager
def time_limit(name: str, seconds: float | None) -> Iterator[None]:
    """Raise `FileTimeout` for the file called *name* when the block takes more than *seconds*.

    None is no limit. The signal interrupts Python and regular expressions, on systems that have it
    and in the main thread; elsewhere nothing is limited.
    """
    if not seconds or not _in_main_thread() or not hasattr(signal, "setitimer"):
        yield
        return

    def late(_signal: int, _frame: FrameType | None) -> None:
        raise FileTimeout(name, f"not read within {seconds:g} s (--file-timeout)")

    before = signal.signal(signal.SIGALRM, late)
    signal.setitimer(signal.ITIMER_REAL, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def _in_main_thread() -> bool:
    """Tell whether this is the main thread, without loading `threading` where nothing has."""
    threading = sys.modules.get("threading")
    return threading is None or threading.current_thread() is threading.main_thread()
