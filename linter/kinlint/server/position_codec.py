"""Places in a text as a client counts them: lines from zero, columns in the agreed units."""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Mapping
from functools import cached_property
from itertools import accumulate

from lsprotocol.types import Position, PositionEncodingKind, Range

from kinlint.text import SourceText, Span

WIDE: Mapping[str, re.Pattern[str]] = {
    PositionEncodingKind.Utf8: re.compile("[^\0-\x7f]"),
    PositionEncodingKind.Utf16: re.compile("[\U00010000-\U0010ffff]"),
}
"""The characters that take more than one unit."""
MARK = "\ufeff"


def _more(char: str, encoding: str) -> int:
    """Return the number of code units that *char* takes beyond one in *encoding*."""
    if encoding == PositionEncodingKind.Utf16:
        return int(char > "\uffff")
    if encoding == PositionEncodingKind.Utf8:
        return (char > "\x7f") + (char > "\u07ff") + (char > "\uffff")
    return 0


class PositionCodec:
    """Converts between offsets of one text and places in it.

    `encoding` is the kind of units in which columns count. *marked* tells that the client counts
    the byte order mark of the text, too, as it stands in its buffer. A conversion takes a time that
    grows with the logarithm of the text.
    """

    def __init__(self, source: SourceText, encoding: str, *, marked: bool = False) -> None:
        self.source = source
        self._encoding = encoding
        self._lead = 1 + _more(MARK, encoding) if marked else 0

    def position(self, offset: int) -> Position:
        """The place of *offset*; offsets outside the text are moved to its ends."""
        offset = max(0, min(offset, len(self.source.text)))
        starts = self.source.line_starts
        line = bisect_right(starts, offset) - 1
        return Position(line, self._units(starts[line], offset) + (0 if line else self._lead))

    def range(self, span: Span) -> Range:
        """The place of *span*."""
        return Range(self.position(span.start), self.position(span.end))

    def offset(self, position: Position) -> int:
        """The offset of *position*, which is moved to the end of its line or the text if beyond.

        Within a character, it is where the character begins.
        """
        starts, text = self.source.line_starts, self.source.text
        if position.line >= len(starts):
            return len(text)
        start = starts[position.line]
        end = len(text)
        if position.line + 1 < len(starts):
            end = starts[position.line + 1] - 1
            end -= end > start and text[end - 1 : end + 1] == "\r\n"
        units = position.character - (0 if position.line else self._lead)
        places = range(start, end + 1)
        return max(start, start + bisect_right(places, units, key=self._offset_to_units(start)) - 1)

    def span(self, place: Range) -> Span:
        """The span at *place*."""
        start = self.offset(place.start)
        return Span(start, max(start, self.offset(place.end)))

    def _offset_to_units(self, start: int) -> Callable[[int], int]:
        return lambda offset: self._units(start, offset)

    def _units(self, start: int, end: int) -> int:
        """Return the number of code units between two offsets."""
        wide, more = self._wide
        if not wide:
            return end - start
        return end - start + more[bisect_left(wide, end)] - more[bisect_left(wide, start)]

    @cached_property
    def _wide(self) -> tuple[list[int], list[int]]:
        """Return the offsets of wide characters and the cumulative count of their extra units."""
        pattern, text = WIDE.get(self._encoding), self.source.text
        if pattern is None or text.isascii():
            return [], [0]
        found = [(each.start(), each[0]) for each in pattern.finditer(text)]
        more = accumulate((_more(char, self._encoding) for _, char in found), initial=0)
        return [at for at, _ in found], list(more)
