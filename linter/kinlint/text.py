"""Source text and places in it: offsets inside, lines and columns only at the edge."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Callable
from functools import cached_property
from itertools import accumulate
from typing import Generic, NamedTuple, TypeVar

from kinlint.file_format import Format
from kinlint.light_dataclasses import dataclass, field

XML_COMMENT = re.compile(r"<!--.*?(?:-->|\Z)", re.DOTALL)
"""A comment in XML; one that does not end is the rest of the text."""

T = TypeVar("T")


class Span(NamedTuple):
    """A half-open range of code points of a text: the only coordinate inside kinlint."""

    start: int
    """Offset of the first code point."""
    end: int
    """Offset behind the last code point."""


class Position(NamedTuple):
    """A line and a column as people count them: from one, columns in code points."""

    line: int
    """Line, from one."""
    column: int
    """Column in code points, from one."""


@dataclass(frozen=True, slots=True)
class Pairing:
    """The description of a robot by which a text is judged that only speaks of the robot."""

    partner: str
    """The name of its file; empty if it was not found."""
    reason: str
    """A clause that says why it is that one."""
    others: tuple[str, ...] = ()
    """Names of the files of other robots that have the same name."""
    elsewhere: tuple[str, ...] = ()
    """Parts that the text names and only those others have."""
    certain: bool = True
    """False if each of the others may be meant as well."""
    annotations: tuple[str, ...] = ()
    """Names of the SRDF files with the planning groups of the robots."""
    stated: bool = False
    """True if a configuration or a launch file says that it is that robot."""


@dataclass(frozen=True, slots=False)
class SourceText:
    """The text of one file.

    Line ends are kept as they stand.
    """

    name: str
    """Name of the file, as the user wrote it."""
    text: str = field(repr=False)
    """The text; offsets count from the character after a byte order mark."""
    bom: bool = False
    """True if a byte order mark stood before the text."""
    misread: tuple[tuple[Span, str], ...] = field(default=(), repr=False)
    """Places where the bytes were not what their encoding has, with what is wrong there."""
    companion: bool = False
    """True if it is only read along with others that speak of it, such as the URDF of an SRDF:
    nothing is reported of it.
    """
    named: bool = True
    """True if the user named this file, or gave this text, rather than a directory that it was
    found in.
    """
    pairing: Pairing | None = field(default=None, repr=False)
    """The choice of the URDF by which an SRDF is judged, once it is known."""
    encoding: str = "utf-8"
    """Turns the text into the bytes that it was read from; "" if nothing does."""
    original: bytes = field(default=b"", repr=False)
    """The bytes, if no encoding turns the text into them."""
    format: Format | None = field(default=None, repr=False, compare=False)
    """The recognised format; None before that, and for what is not known."""

    @cached_property
    def line_starts(self) -> tuple[int, ...]:
        """The offset at which each line begins; LF, CRLF and CR end a line."""
        text = self.text
        lengths = [len(line) + 1 for line in text.split("\n")]
        starts = list(accumulate(lengths[:-1], initial=0))
        lone_return = "\r" in text.replace("\r\n", "")
        if lone_return:
            returns = (
                i + 1 for i, c in enumerate(text) if c == "\r" and text[i + 1 : i + 2] != "\n"
            )
            starts = sorted({*starts, *returns})
        return tuple(starts)

    def position(self, offset: int) -> Position:
        """Return the line and column of *offset*, which is clamped to the text."""
        offset = max(0, min(offset, len(self.text)))
        line = bisect_right(self.line_starts, offset)
        return Position(line, offset - self.line_starts[line - 1] + 1)

    def line(self, number: int) -> str:
        """Line *number*, counted from one, without its end."""
        starts = self.line_starts
        end = starts[number] if number < len(starts) else len(self.text)
        return self.text[starts[number - 1] : end].rstrip("\r\n")

    def __getitem__(self, span: Span) -> str:
        return self.text[span.start : span.end]


@dataclass(frozen=True, slots=True)
class Location:
    """A span of a source; `start` and `end` are for those who print."""

    source: SourceText
    """Text of the file."""
    span: Span
    """Place in it."""

    @property
    def start(self) -> Position:
        """Line and column of the first character."""
        return self.source.position(self.span.start)

    @property
    def end(self) -> Position:
        """Line and column just after the last character."""
        return self.source.position(self.span.end)


class PerText(Generic[T]):
    """Results of a function of texts, each kept until another text has the same name."""

    def __init__(self, make: Callable[[SourceText], T]) -> None:
        self._make = make
        self._made: dict[str, tuple[SourceText, T]] = {}

    def __call__(self, source: SourceText) -> T:
        """Return the result for *source*."""
        known = self._made.get(source.name)
        if known is None or known[0] is not source:
            known = self._made[source.name] = source, self._make(source)
        return known[1]

    def clear(self) -> None:
        """Forget all results."""
        self._made.clear()
