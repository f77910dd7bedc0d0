"""Examples of rule files: their text, and what `[|...|]` marks in it."""

from __future__ import annotations

import re
import textwrap

from kinlint.light_dataclasses import dataclass
from kinlint.reporters.excerpt import Mark, underlined_text
from kinlint.reporters.terminal_style import Style
from kinlint.text import Location, SourceText, Span

_MARK = re.compile(r"\[\||\|\]")


@dataclass(frozen=True, slots=True)
class MarkedText:
    """The text of an example without its marks, and the spans that were marked."""

    format: str
    """Name of the format."""
    text: str
    """Text without marks."""
    marks: tuple[Span, ...]
    """Spans that were marked."""

    @property
    def longest_ticks(self) -> int:
        """The length of the longest run of backticks, which a fence must outdo."""
        return max(map(len, re.findall("`+", self.text)), default=0)

    def annotated(self, style: Style) -> str:
        """The text with carets in lines of their own below what is marked."""
        source = SourceText("", self.text)
        marks = [Mark(Location(source, span), "error", sign="^") for span in self.marks]
        return "\n".join(underlined_text(source, marks, style))

    def places(self) -> list[dict[str, int]]:
        """The marks as rows and columns from one, in code points; ends exclude."""
        source = SourceText("", self.text)
        ends = [(source.position(span.start), source.position(span.end)) for span in self.marks]
        return [
            {
                "row": start.line,
                "column": start.column,
                "end_row": end.line,
                "end_column": end.column,
            }
            for start, end in ends
        ]


def parse_marks(text: str, format: str) -> MarkedText:  # noqa: A002
    """An example as a rule file has it, unindented and without its marks."""
    text = textwrap.dedent(text).strip("\n")
    parts: list[str] = []
    opened: list[int] = []
    marks: list[Span] = []
    end = size = 0
    for match in _MARK.finditer(text):
        parts.append(text[end : match.start()])
        size += match.start() - end
        end = match.end()
        if match[0] == "[|":
            opened.append(size)
        elif opened:
            marks.append(Span(opened.pop(), size))
    parts.append(text[end:])
    return MarkedText(format, "".join(parts).rstrip(), tuple(sorted(marks)))
