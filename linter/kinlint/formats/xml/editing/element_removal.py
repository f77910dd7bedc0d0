"""Elements that go, with the lines that they leave empty."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinlint.edits import Edit
from kinlint.formats.xml.editing.element_layout import BREAK, ElementLayout
from kinlint.text import Span


def removals(layout: ElementLayout, numbers: Iterable[int]) -> Iterator[Edit]:
    """Yield the edits that delete elements, none of which is within another."""
    for span in _runs(layout, sorted(layout.whole(number) for number in numbers)):
        yield Edit(with_lines(layout, span), "")


def _runs(layout: ElementLayout, spans: Iterable[Span]) -> list[Span]:
    """Return *spans*, those merged that only space separates."""
    runs: list[Span] = []
    for span in spans:
        if runs and layout.behind(runs[-1].end) == span.start:
            runs[-1] = Span(runs[-1].start, span.end)
        else:
            runs.append(span)
    return runs


def with_lines(layout: ElementLayout, span: Span) -> Span:
    """Return *span* with the lines that it fills alone, or with the blanks that separate it."""
    text = layout.text
    start, end = layout.before(span.start, " \t"), layout.behind(span.end, " \t")
    if layout.begins_line(span.start):
        if not layout.ends_line(span.end):
            return Span(span.start, end)
        if following := BREAK.match(text, end):
            return Span(start, _one_blank_line(layout, start, following.end()))
        return span
    return Span(start, span.end) if start > 0 and text[start - 1] == ">" else span


def _one_blank_line(layout: ElementLayout, start: int, end: int) -> int:
    """Return *end*, or a later end of the removal if blank lines are on both sides."""
    above = layout.before(start, "\r\n \t")
    behind = layout.behind(end, " \t")
    following = BREAK.match(layout.text, behind)
    if following and len(BREAK.findall(layout.text, above, start)) > 1:
        return following.end()
    return end
