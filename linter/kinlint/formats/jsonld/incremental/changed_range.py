"""The changed range between two versions of a text."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple


class Difference(NamedTuple):
    """A changed range: `start` to `old_end` in the old text, to `new_end` in the new one."""

    start: int
    old_end: int
    new_end: int

    @property
    def shift(self) -> int:
        """Return the offset by which the text after it has moved."""
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
    """Return the length of the longest equal prefix, at most *most*, by binary search."""
    low = 0
    while low < most:
        middle = (low + most + 1) // 2
        if equal(low, middle):
            low = middle
        else:
            most = middle - 1
    return low
