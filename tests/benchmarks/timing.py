"""Times things side by side, so that what else the machine does hits all of them alike."""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Sequence
from statistics import median

try:
    import resource
except ImportError:  # Windows counts in ticks only.
    resource = None

PATIENCE = 90.0
"""Seconds after which what has run at least once is not run again."""


def interleaved(
    actions: Sequence[Callable[[], object]],
    runs: int,
    clock: Callable[[], float] = time.perf_counter,
) -> tuple[float, ...]:
    """The median seconds, by *clock*, of each of *actions*, which take turns in *runs* rounds.

    One that has taken longer than `PATIENCE` in all sits out the rounds that remain.
    """
    taken: list[list[float]] = [[] for _ in actions]
    for _ in range(runs):
        for action, seconds in zip(actions, taken, strict=True):
            if sum(seconds) < PATIENCE:
                seconds.append(timed(action, clock))
    return tuple(median(seconds) for seconds in taken)


def timed(action: Callable[[], object], clock: Callable[[], float] = time.perf_counter) -> float:
    """The seconds, by *clock*, that *action* takes."""
    started = clock()
    action()
    return clock() - started


def processor_time() -> float:
    """The seconds that processors have worked for this process and those that it waited for."""
    if resource is None:
        return sum(os.times()[:4])
    kinds = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    spent = [resource.getrusage(kind) for kind in kinds]
    return sum(each.ru_utime + each.ru_stime for each in spent)
