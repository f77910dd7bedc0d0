"""Time of a run in seconds: by phase, and where that is wanted by the parts of phases."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import TypeAlias

Part: TypeAlias = tuple[str, str]
"""A kind of work, such as `rule`, and the name of the one that was done."""
_parts: ContextVar[dict[Part, float] | None] = ContextVar("parts", default=None)


@contextmanager
def part(kind: str, name: str) -> Iterator[None]:
    """Count the time spent within as time of the part *name* of a *kind*, if parts are counted."""
    found = _parts.get()
    if found is None:
        yield
        return
    started = time.perf_counter()
    try:
        yield
    finally:
        spent = time.perf_counter() - started
        found[kind, name] = found.get((kind, name), 0.0) + spent


class Phases:
    """Wall-clock seconds of the phases of a run and of their parts, in the order of beginning."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = {}
        self.parts: dict[Part, float] = {}

    @contextmanager
    def phase(self, name: str) -> Iterator[None]:
        """Count the time spent within as time of the phase *name*."""
        started = time.perf_counter()
        try:
            yield
        finally:
            spent = time.perf_counter() - started
            self.seconds[name] = self.seconds.get(name, 0.0) + spent

    @contextmanager
    def counting_parts(self, *, wanted: bool) -> Iterator[None]:
        """Count the time that this thread spends within on each part of the work, if *wanted*."""
        token = _parts.set(self.parts if wanted else None)
        try:
            yield
        finally:
            _parts.reset(token)
