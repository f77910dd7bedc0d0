"""Elements of a text that is being typed, and the place of the cursor among them.

Nothing has to be well-formed: a tag that is not closed is passed over, and an end tag ends the
innermost element of its name.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from enum import Enum, auto
from functools import cached_property

from kinlint.light_dataclasses import dataclass, field
from kinlint.text import Span

_MARKUP = re.compile(
    r"""<!--(?P<comment>.*?)(?:-->|\Z) | <\?.*?(?:\?>|\Z) | <!\[CDATA\[.*?(?:\]\]>|\Z)
    | </(?P<ended>[^\s<>/]*)\s*>?
    | <(?P<tag>[^\s<>/=\"'!?&]+)(?P<attributes>(?:[^<>"']|"[^"<]*"|'[^'<]*')*?)(?P<empty>/?)>""",
    re.DOTALL | re.VERBOSE,
)
_ATTRIBUTE = re.compile(r"""([^\s<>=/"']+)\s*=\s*(?:"([^"<]*)"|'([^'<]*)')""")
_VALUE_START = re.compile(r"""([^\s<>=/"']+)\s*=\s*(["'])""")
_REST_OF_NAME = re.compile(r"[^\s<>/=\"']*")
_TAG_END = re.compile(r"[<>]")
_NAME_START = re.compile(r"<(/?)([^\s<>/=\"']*)\Z")
_PARTIAL = re.compile(r"(?:\A|(?<=\s))[^\s<>=/\"']*\Z")


class Spot(Enum):
    """Kind of place that the cursor is at."""

    TAG = auto()
    """In the name of a start tag."""
    END_TAG = auto()
    """In the name of an end tag."""
    ATTRIBUTE = auto()
    """In the name of an attribute, or before one."""
    VALUE = auto()
    """In the value of an attribute."""
    TEXT = auto()
    """In the text of an element."""
    COMMENT = auto()
    """In a comment."""


@dataclass(eq=False)
class TextElement:
    """An element as far as it is written."""

    tag: str
    """Its tag, with a prefix if it has one."""
    written: str
    """The text of its attributes."""
    start: int
    """Offset of its start tag."""
    parent: TextElement | None = None
    """The element that it is in; None for the outermost ones."""
    children: list[TextElement] = field(default_factory=list)
    """The elements in it, in their order."""
    content: int = 0
    """Offset behind its start tag."""
    end: int = 0
    """Offset behind its end tag, or of the end of the text."""
    is_open: bool = False
    """True if nothing ends it."""

    @cached_property
    def attributes(self) -> Mapping[str, str]:
        """The values of its attributes as they are written, by name."""
        return {
            match[1]: match[2] if match[2] is not None else match[3]
            for match in _ATTRIBUTE.finditer(self.written)
        }

    @property
    def ancestors(self) -> Iterator[TextElement]:
        """Yield the elements that it is in, the innermost first."""
        at = self.parent
        while at is not None:
            yield at
            at = at.parent


@dataclass
class Cursor:
    """The place of the cursor."""

    spot: Spot
    """Kind of the place."""
    token: Span
    """The name, value or text that is written there, up to its end."""
    parent: TextElement | None
    """The innermost element around; of a tag that is being written, the one around that."""
    element: TextElement | None = None
    """The element whose start tag the cursor is in."""
    attribute: str = ""
    """The attribute whose value the cursor is in."""


class UnfinishedText:
    """The elements of *text*."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.elements: list[TextElement] = []
        self.comments: list[Span] = []
        stack: list[TextElement] = []
        for match in _MARKUP.finditer(text):
            if match["comment"] is not None:
                self.comments.append(Span(*match.span("comment")))
            elif match["ended"] is not None:
                self._end(stack, match)
            elif match["tag"] is not None:
                self._begin(stack, match)
        for each in stack:
            each.end, each.is_open = len(text), True

    def _begin(self, stack: list[TextElement], match: re.Match[str]) -> None:
        parent = stack[-1] if stack else None
        element = TextElement(match["tag"], match["attributes"], match.start(), parent)
        element.content = element.end = match.end()
        self.elements.append(element)
        if parent is not None:
            parent.children.append(element)
        if not match["empty"]:
            stack.append(element)

    @staticmethod
    def _end(stack: list[TextElement], match: re.Match[str]) -> None:
        depths = (n for n in range(len(stack) - 1, -1, -1) if stack[n].tag == match["ended"])
        for each in stack[(depth := next(depths, len(stack))) :]:
            each.end, each.is_open = match.start(), True
        if depth < len(stack):
            stack[depth].end, stack[depth].is_open = match.end(), False
        del stack[depth:]

    def around(self, offset: int) -> TextElement | None:
        """Return the innermost element whose content *offset* is in."""
        found = None
        for each in self.elements:
            if each.start >= offset:
                break
            if each.content <= offset < each.end + each.is_open:
                found = each
        return found

    def cursor(self, offset: int) -> Cursor:
        """Return the place of *offset*."""
        text = self.text
        for comment in self.comments:
            if comment.start <= offset <= comment.end:
                return Cursor(Spot.COMMENT, comment, self.around(offset))
        start = text.rfind("<", 0, offset)
        before = text[start:offset] if start >= 0 else ""
        if not before or before.startswith(("<!", "<?")) or _closed(before):
            at = max(start, text.rfind(">", 0, offset) + 1, 0)
            return Cursor(Spot.TEXT, Span(at, offset), self.around(offset))
        parent = self.around(start)
        if name := _NAME_START.match(before):
            token = Span(start + name.start(2), self._name_end(offset))
            return Cursor(Spot.END_TAG if name[1] else Spot.TAG, token, parent)
        return self._in_tag(start, offset, parent)

    def _in_tag(self, start: int, offset: int, parent: TextElement | None) -> Cursor:
        """Return the place of *offset* in the start tag that begins at *start*."""
        before = self.text[start:offset]
        tag = re.split(r"[\s<>/=\"']", before[1:], maxsplit=1)[0]
        element = TextElement(tag, self._tag_text(start, offset)[1 + len(tag) :], start, parent)
        value = _open_value(before, 1 + len(tag))
        if value is not None:
            end = self._value_end(offset, value[2])
            return Cursor(Spot.VALUE, Span(start + value.end(), end), parent, element, value[1])
        partial = _PARTIAL.search(before)
        if partial is None:
            return Cursor(Spot.TEXT, Span(offset, offset), parent, element)
        end = self._name_end(offset)
        if self.text[end : end + 1] == "=":
            end = offset
        return Cursor(Spot.ATTRIBUTE, Span(start + partial.start(), end), parent, element)

    def _name_end(self, offset: int) -> int:
        match = _REST_OF_NAME.match(self.text, offset)
        return match.end() if match else offset

    def _value_end(self, offset: int, quote: str) -> int:
        """Return the end of the value that *offset* is in, if it ends in this line."""
        match = re.compile(rf"[^{quote}<>\r\n]*(?={quote})").match(self.text, offset)
        return match.end() if match else offset

    def _tag_text(self, start: int, offset: int) -> str:
        """Return the start tag at *start*, without what is being typed at *offset*."""
        stop = _TAG_END.search(self.text, offset)
        return self.text[start : stop.start() if stop else len(self.text)]


def _open_value(before: str, at: int) -> re.Match[str] | None:
    """Return the beginning of the value at the end of *before*, a tag that is read from *at*."""
    while (match := _VALUE_START.search(before, at)) is not None:
        end = before.find(match[2], match.end())
        if end < 0:
            return match
        at = end + 1
    return None


def _closed(before: str) -> bool:
    """Tell whether *before*, which begins with <, has the > that ends its tag."""
    return ">" in re.sub(r"\"[^\"]*\"|'[^']*'", "", before)
