"""Lines of a source with marks under them, cut to the width of the terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.light_dataclasses import dataclass
from kinlint.reporters.display_width import fold_lines, printable, width
from kinlint.reporters.terminal_style import Ink, Style
from kinlint.text import Location, SourceText, Span

CONTEXT_LINES = 2


@dataclass(frozen=True, slots=True)
class Mark:
    """A place to underline: `^` for what a finding is about, `-` for what it speaks of."""

    location: Location
    """Place to underline."""
    ink: Ink
    """Colour."""
    label: str = ""
    """Text behind the underline."""
    sign: str = "-"
    """Character of the underline: `^` for the finding, `-` for places related to it."""

    @property
    def line(self) -> int:
        """The line of the mark; a span of several lines is marked on its first."""
        return self.location.start.line

    @property
    def start(self) -> int:
        """The offset at which the mark begins."""
        return self.location.span.start


@dataclass(frozen=True, slots=True)
class Cut:
    """The part of a line that is shown."""

    start: int
    """Offset in the source at which it begins."""
    end: int
    """Offset at which it ends."""
    before: bool
    """True if the line has more before it."""
    after: bool
    """True if the line has more after it."""

    def holds(self, offset: int) -> bool:
        """Tell whether *offset* is shown; the end of the line belongs to the line."""
        return self.start <= offset < self.end or (offset == self.end and not self.after)


def cut_line(source: SourceText, line: int, at: int, style: Style) -> Cut:
    """The widest part of *line* that fits the style's width and shows what stands at *at*."""
    first, last = bounds(source, line)
    limit = style.width - 12
    text = source.text
    if last - first <= limit and width(printable(text[first:last], unicode=style.unicode)) <= limit:
        return Cut(first, last, before=False, after=False)
    at = max(first, min(at, last))
    start, room = _walk(source, at, first, limit // 3, style)
    end, room = _walk(source, at, last, limit - limit // 3 + room, style)
    start, _ = _walk(source, start, first, room, style)
    return Cut(start, end, before=start > first, after=end < last)


def excerpt_rows(
    marks: Sequence[Mark], style: Style, gutter: int, context: int = 0
) -> Iterator[str]:
    """The lines of all *marks*, which are of one source, with up to *context* lines before.

    The first mark is the one that matters most: its line is cut round it.
    """
    source = marks[0].location.source
    by_line: dict[int, list[Mark]] = {}
    for mark in marks:
        by_line.setdefault(mark.line, []).append(mark)
    previous = 0
    for line in _lines(source, by_line, marks[0].line, context):
        if previous and line > previous + 1:
            yield style.ink("." * 3, "place")
        previous = line
        own = by_line.get(line, [])
        part = cut_line(source, line, own[0].start if own else 0, style)
        bar = style.ink(f"{line:>{gutter}} |", "place")
        yield f"{bar} {_text(source, part, style)}".rstrip()
        for mark in own:
            bar = style.ink(f"{'':>{gutter}} |", "place")
            yield f"{bar} {_underline(mark, part, style)}"


def underlined_text(source: SourceText, marks: Sequence[Mark], style: Style) -> Iterator[str]:
    """All lines of a short source as they are, with the marks below."""
    for number in range(1, len(source.line_starts) + 1):
        part = Cut(*bounds(source, number), before=False, after=False)
        yield _text(source, part, style)
        for mark in marks:
            if mark.line == number:
                yield _underline(mark, part, style)


def line_text(source: SourceText, line: int, at: int, style: Style) -> str:
    """Return *line* as shown, cut around the offset *at* if it exceeds the style's width."""
    return _text(source, cut_line(source, line, at, style), style)


def _lines(source: SourceText, marked: dict[int, list[Mark]], main: int, context: int) -> list[int]:
    """The lines to show; a single line between two of them is shown too."""
    before = range(max(1, main - context), main)
    blank = 0
    for line in before:
        if source.line(line).strip():
            break
        blank += 1
    wanted = {*marked, *before[blank:]}
    return sorted(wanted | {line + 1 for line in wanted if line + 2 in wanted})


def bounds(source: SourceText, line: int) -> tuple[int, int]:
    """The offsets of a line without its end; the text is not copied."""
    starts = source.line_starts
    first = starts[line - 1]
    last = starts[line] if line < len(starts) else len(source.text)
    while last > first and source.text[last - 1] in "\r\n":
        last -= 1
    return first, last


def _walk(source: SourceText, at: int, stop: int, room: int, style: Style) -> tuple[int, int]:
    """Return the offset reached within *room* columns from *at* to *stop*, and the room left."""
    step = 1 if stop > at else -1
    while at != stop:
        char = source.text[at if step > 0 else at - 1]
        needed = width(printable(char, unicode=style.unicode))
        if needed > room:
            break
        room -= needed
        at += step
    return at, room


def _text(source: SourceText, part: Cut, style: Style) -> str:
    more = _ellipsis(style)
    text = printable(source[Span(part.start, part.end)], unicode=style.unicode)
    return (more if part.before else "") + text + (more if part.after else "")


def _underline(mark: Mark, part: Cut, style: Style) -> str:
    span, source = mark.location.span, mark.location.source
    before = source[Span(part.start, min(span.start, part.end))]
    lead = width(printable(before, unicode=style.unicode))
    lead += len(_ellipsis(style)) if part.before else 0
    marked = source[Span(span.start, min(span.end, part.end))].rstrip(" \t")
    signs = mark.sign * max(1, width(printable(marked, unicode=style.unicode)))
    label = fold_lines(mark.label, unicode=style.unicode)
    return " " * lead + style.ink(f"{signs} {label}".rstrip(), mark.ink)


def _ellipsis(style: Style) -> str:
    return "…" if style.unicode else "..."
