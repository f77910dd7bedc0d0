"""Signals that would end a run at a moment when it has something to put back in order."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from types import FrameType

ENDS = ("SIGINT", "SIGTERM", "SIGHUP")
"""Signals that end a process, as far as the system has them."""


class Interruptions:
    """Makes signals exceptions, which may be held back."""

    def __init__(self) -> None:
        self._held = self._ignored = False
        self._waiting: int | None = None

    @contextmanager
    def raised(self) -> Iterator[None]:
        """Raise an exception where a signal would end the process."""
        before = {}
        for name in ENDS:
            with suppress(AttributeError, ValueError):  # unknown there; not the main thread
                number = getattr(signal, name)
                before[number] = signal.signal(number, self._take)
        try:
            yield
        finally:
            for number, earlier in before.items():
                signal.signal(number, earlier)

    @contextmanager
    def held(self) -> Iterator[None]:
        """Raise what comes meanwhile at the end; a second signal at once."""
        self._held = True
        try:
            yield
        finally:
            self._held = False
        if self._waiting is not None:
            _raise(self._waiting)

    def ignore(self) -> None:
        """Raise nothing from now on."""
        self._ignored = True

    def _take(self, number: int, _frame: FrameType | None) -> None:
        if self._ignored:
            return
        if self._held and self._waiting is None:
            self._waiting = number
        else:
            _raise(number)


def _raise(number: int) -> None:
    raise KeyboardInterrupt if number == signal.SIGINT else SystemExit(128 + number)
