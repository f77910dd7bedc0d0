"""Places in UTF-16 units, as SARIF's `columnKind` announces them."""

from __future__ import annotations

import re
from bisect import bisect_left
from functools import cached_property
from typing import Any

from kinlint.text import SourceText, Span

CONTEXT_UNITS = 200
"""A context region reaches at most so far before and after its region."""
_ASTRAL = re.compile("[\U00010000-\U0010ffff]")


class Regions:
    """The regions of one source. Offsets count from behind a byte order mark."""

    def __init__(self, source: SourceText) -> None:
        self._source = source

    def region(self, span: Span) -> dict[str, Any]:
        """The `region` of *span*; one of several lines is cut to the first of them.

        Small on purpose: GitHub shows an alert in a pull request only if the change holds
        every line of its region.
        """
        return self._region(self._trimmed(span))

    def exact(self, span: Span) -> dict[str, Any]:
        """The `region` of all of *span*, by lines and columns and by offset and length."""
        region = self._region(span)
        del region["snippet"]
        return region

    def context(self, span: Span) -> dict[str, Any] | None:
        """The `contextRegion`, properly larger than the region, or None if nothing is."""
        span = self._trimmed(span)
        text, starts = self._source.text, self._source.line_starts
        line = self._source.position(span.start).line
        first = max(starts[max(0, line - 2)], span.start - CONTEXT_UNITS)
        end = starts[line + 1] if line + 1 < len(starts) else len(text)
        last = min(end, span.end + CONTEXT_UNITS)
        first += text[max(0, first - 1) : first + 1] == "\r\n"
        if (first, last) == span:
            return None
        whole = text[first:last]
        trimmed = first + len(whole.rstrip("\r\n"))
        if trimmed >= span.end and (first, trimmed) != span:
            last = trimmed
        return self._region(Span(first, last))

    def _region(self, span: Span) -> dict[str, Any]:
        start, end = self._source.position(span.start), self._source.position(span.end)
        offset, stop = self._units(span.start), self._units(span.end)
        return {
            "startLine": start.line,
            "startColumn": offset - self._line_units(start.line) + 1,
            "endLine": end.line,
            "endColumn": stop - self._line_units(end.line) + 1,
            "charOffset": offset,
            "charLength": stop - offset,
            "snippet": {"text": self._source[span]},
        }

    def _trimmed(self, span: Span) -> Span:
        size = len(self._source.text)
        start = max(0, min(span.start, size))
        end = max(start, min(span.end, size))
        line = self._source.position(start).line
        text, starts = self._source.text, self._source.line_starts
        stop = starts[line] if line < len(starts) else size
        while stop > start and text[stop - 1] in "\r\n":
            stop -= 1
        if end > stop:
            end = start + len(text[start:stop].rstrip())
        if (start, end) == (0, size) and size > 1:
            end = 1
        return Span(start, end)

    def _line_units(self, line: int) -> int:
        return self._units(self._source.line_starts[line - 1])

    def _units(self, offset: int) -> int:
        """The UTF-16 units before *offset*."""
        return offset + bisect_left(self._astral, offset)

    @cached_property
    def _astral(self) -> list[int]:
        """The offsets of the characters that take two units."""
        if self._source.text.isascii():
            return []
        return [match.start() for match in _ASTRAL.finditer(self._source.text)]
