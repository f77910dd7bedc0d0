"""Work that stops between its phases once nobody wants its outcome any more."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager

from kinlint.phases import Phases
from kinlint.pipeline.analyzer import Cancelled


class CancellablePhases(Phases):
    """Phases that do not begin when *cancelled*: `Cancelled` is raised instead."""

    def __init__(self, cancelled: Callable[[], bool]) -> None:
        super().__init__()
        self._cancelled = cancelled

    @contextmanager
    def phase(self, name: str) -> Iterator[None]:
        """The phase *name*, if it is wanted."""
        if self._cancelled():
            raise Cancelled
        with super().phase(name):
            yield
