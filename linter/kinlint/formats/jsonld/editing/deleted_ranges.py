"""The ranges of a text that are no more."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator

from kinlint.text import Span


class Cuts:
    """Ranges, of which any two are apart or one within the other, as tokens of JSON are."""

    def __init__(self) -> None:
        # The widest ones, ascending.
        self._starts: list[int] = []
        self._ends: list[int] = []

    def add(self, span: Span) -> None:
        """*span* is no more."""
        if span in self:
            return
        first = bisect_right(self._starts, span.start - 1)
        last = bisect_right(self._starts, span.end - 1)
        self._starts[first:last] = [span.start]
        self._ends[first:last] = [span.end]

    def __contains__(self, span: Span) -> bool:
        at = bisect_right(self._starts, span.start) - 1
        return at >= 0 and span.end <= self._ends[at]

    def __iter__(self) -> Iterator[Span]:
        return map(Span, self._starts, self._ends)
