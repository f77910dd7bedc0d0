"""Origin of a node in the text, and the attributes of its start tag."""

from __future__ import annotations

import re
from functools import cached_property
from typing import NamedTuple

from kinlint.light_dataclasses import dataclass
from kinlint.text import SourceText, Span

_ATTRIBUTE = re.compile(r"""[ \t\r\n]+([^ \t\r\n=/>]+)[ \t\r\n]*=[ \t\r\n]*("[^"]*"|'[^']*')""")


class AttributeSpans(NamedTuple):
    """The places of an attribute's name, and of its value without quotes."""

    name: Span
    """Place of the name."""
    value: Span
    """Place of the value, without quotes."""


def attributes(text: str, start: int, end: int) -> dict[str, AttributeSpans]:
    """Return the attributes of the start tag of *text* from *start* to *end*, by name.

    The text is well-formed.
    """
    return {
        match[1]: AttributeSpans(Span(*match.span(1)), Span(match.start(2) + 1, match.end(2) - 1))
        for match in _ATTRIBUTE.finditer(text, start, end)
    }


@dataclass
class Origin:
    """Text that wrote a node: `start` to `end` of `source`."""

    source: SourceText
    """Text of the file."""
    start: int
    """Offset of the first character."""
    end: int
    """Offset behind the last character."""
    inside: int = 0
    """End of the start tag of an element; else that of the node."""
    closing: int = 0
    """Start of the end tag of an element; the end if it has none."""

    @property
    def span(self) -> Span:
        """All of it."""
        return Span(self.start, self.end)

    @cached_property
    def attributes(self) -> dict[str, AttributeSpans]:
        """Return the spans of the attributes of the start tag."""
        return attributes(self.source.text, self.start, self.inside)

    @property
    def stripped(self) -> Span:
        """The span without the blanks at its ends."""
        text = self.source.text[self.start : self.end]
        start = self.start + len(text) - len(text.lstrip())
        return Span(start, max(start, self.start + len(text.rstrip())))

    @cached_property
    def tag(self) -> Span:
        """The name in the start tag."""
        text, at = self.source.text, self.start + 1
        end = at
        while end < self.inside and text[end] not in " \t\r\n/>":
            end += 1
        return Span(at, end)
