"""Spans that lie within each other or apart, as elements do: which of them hold a place."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from typing import Generic, TypeVar

from kinlint.light_dataclasses import dataclass
from kinlint.text import Span

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class IntervalIndex(Generic[T]):
    """Spans that nest, each with a content.

    No span is longer than one that it begins in, but equal ones may come several times.
    """

    spans: Sequence[Span]
    """Spans, by their beginning."""
    outer: Sequence[int]
    """Index of the smallest span around each; -1 for none."""
    contents: Sequence[T]
    """Content of each."""

    @classmethod
    def from_spans(cls, found: Iterable[tuple[Span, T]]) -> IntervalIndex[T]:
        """The nest of all that is *found*."""
        ordered = sorted(found, key=lambda pair: (pair[0].start, -pair[0].end))
        spans = [span for span, _ in ordered]
        outer: list[int] = []
        for number, span in enumerate(spans):
            around = number - 1
            while around >= 0 and spans[around].end < span.end:
                around = outer[around]
            outer.append(around)
        return cls(spans, outer, [one for _, one in ordered])

    def containing(self, place: Span) -> Iterator[T]:
        """Yield the contents of all intervals that contain *place*, the innermost first."""
        at = bisect_right(self.spans, place.start, key=lambda span: span.start) - 1
        while at >= 0:
            if place.end <= self.spans[at].end:
                yield self.contents[at]
            at = self.outer[at]
