"""What of a text is another than before."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple


class Difference(NamedTuple):
    """From `start` to `old_end` the old text had something else than the new one to `new_end`."""

    start: int
    old_end: int
    new_end: int

    @property
    def shift(self) -> int:
        """How far what follows has moved."""
        return self.new_end - self.old_end


def difference(old: str, new: str) -> Difference:
    """The one range in which *old* and *new* differ."""
    most = min(len(old), len(new))
    start = _same(most, lambda low, high: old[low:high] == new[low:high])
    end, own = len(old), len(new)
    tail = _same(
        most - start,
        lambda low, high: old[end - high : end - low] == new[own - high : own - low],
    )
    return Difference(start, end - tail, own - tail)


def _same(most: int, equal: Callable[[int, int], bool]) -> int:
    """Of how many things the first are *equal*, range by range; at most *most*."""
    low = 0
    while low < most:
        middle = (low + most + 1) // 2
        if equal(low, middle):
            low = middle
        else:
            most = middle - 1
    return low
