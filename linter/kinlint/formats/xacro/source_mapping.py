"""The way back from an expanded text to the texts that wrote it."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterator, Mapping
from functools import cached_property
from typing import NamedTuple, TypeVar

from kinlint.light_dataclasses import dataclass
from kinlint.text import Span

_Key = TypeVar("_Key")
_Place = TypeVar("_Place")


class MappedRange(NamedTuple):
    """Range of an expanded text, written from `start` to `end` of the source."""

    at: int
    """Offset in the expanded text."""
    start: int
    """Offset of its first character in the source."""
    end: int
    """Offset behind its last character in the source."""
    exact: bool
    """True if both are equal character by character."""


@dataclass(frozen=True)
class MappedText:
    """Expanded text with the ranges that wrote it."""

    text: str
    """The expanded text."""
    leaves: tuple[MappedRange, ...]
    """Ranges that cover all of it, in order."""

    @cached_property
    def _starts(self) -> tuple[int, ...]:
        return tuple(leaf.at for leaf in self.leaves)

    def span(self, span: Span) -> Span:
        """Return the source of *span* of the text, from that of its first part to that of its last.

        If these are not in order in one text, as where a macro was called, only the first part.
        """
        first = self._leaf(span.start)
        last = self._leaf(max(span.start, span.end - 1))
        start = self._start(first, span.start)
        end = self._end(last, span.end) if span.end > span.start else start
        if first is last or start <= end:
            return Span(start, end)
        return Span(start, max(start, first.end))

    def _leaf(self, offset: int) -> MappedRange:
        return self.leaves[max(0, bisect_right(self._starts, offset) - 1)]

    @staticmethod
    def _start(leaf: MappedRange, offset: int) -> int:
        return min(leaf.start + offset - leaf.at, leaf.end) if leaf.exact else leaf.start

    @staticmethod
    def _end(leaf: MappedRange, offset: int) -> int:
        return min(leaf.start + offset - leaf.at, leaf.end) if leaf.exact else leaf.end


class MappedPlaces(Mapping[_Key, _Place]):
    """The places of *inner* as *back* moves them, each when it is asked for, and *own* ones."""

    def __init__(
        self,
        inner: Mapping[_Key, _Place],
        back: Callable[[_Place], _Place],
        own: Mapping[_Key, _Place],
    ) -> None:
        self._inner = inner
        self._back = back
        self._own = own

    def __getitem__(self, key: _Key) -> _Place:
        own = self._own.get(key)
        return self._back(self._inner[key]) if own is None else own

    def __iter__(self) -> Iterator[_Key]:
        yield from self._inner
        yield from (key for key in self._own if key not in self._inner)

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def __contains__(self, key: object) -> bool:
        return key in self._own or key in self._inner
