"""Layout of one text: places of its elements, indentation, line ends."""

from __future__ import annotations

import re
from functools import cached_property
from typing import NamedTuple

from kinlint.edits import NotExpressible
from kinlint.errors import SourceError
from kinlint.formats.xml.element_types import Schema
from kinlint.formats.xml.elements import Elements
from kinlint.formats.xml.expat_parsing import parse
from kinlint.formats.xml.span_lookup import WRITTEN, ElementPlaces, Tag
from kinlint.formats.xml.value_reading import SPACE
from kinlint.text import SourceText, Span

BREAK = re.compile(r"\r\n|\r|\n")
SECTION = "<![CDATA["
DEFAULT_INDENT = "  "


class Attribute(NamedTuple):
    """An attribute of a start tag: its name, the place of that, and of its value inside quotes."""

    name: str
    """The name."""
    key: Span
    """Place of the name."""
    value: Span
    """Place of the value, without quotes."""

    @property
    def end(self) -> int:
        """Offset behind the closing quote."""
        return self.value.end + 1


class ElementLayout:
    """The elements of *source*, numbered in order; `parents` has -1 for the root.

    Raises NotExpressible for what is not read as XML.
    """

    def __init__(self, source: SourceText) -> None:
        if not source.encoding:
            raise NotExpressible("some bytes of the file are not in its encoding")
        try:
            parsed = parse(source, lambda: Elements("<>", Schema("", {}, {}, {})))
        except SourceError as error:
            raise NotExpressible("the text is not read") from error
        if parsed.fatal is not None:
            raise NotExpressible("the text is not well-formed")
        self.source, self.text = source, source.text
        found = parsed.elements
        self.places = ElementPlaces(
            source.text, parsed.offset, found.index, found.starts, found.ends
        )
        self.parents: list[int] = []
        self.children: list[list[int]] = []
        self._number: dict[int, int] = {}
        self._last_children: dict[int, dict[str, int]] = {}
        self._nest(found.starts, found.ends)

    def _nest(self, starts: list[int], ends: list[int]) -> None:
        around: list[int] = []
        for number, start in enumerate(starts):
            while around and ends[around[-1]] <= start:
                around.pop()
            self.parents.append(around[-1] if around else -1)
            self.children.append([])
            if around:
                self.children[around[-1]].append(number)
            around.append(number)
            self._number[self.places.offset(start)] = number

    def number(self, start: int) -> int | None:
        """Return the element that begins at *start*."""
        return self._number.get(start)

    def tag(self, number: int) -> Tag:
        """Return the start tag of an element."""
        return self.places.tag(number)

    def name(self, number: int) -> str:
        """Return the tag of an element."""
        return self.source[self.tag(number).name]

    def last_children(self, number: int) -> dict[str, int]:
        """Return the last child of each name in an element, the very last one first."""
        if number not in self._last_children:
            children = self._last_children[number] = {}
            for child in reversed(self.children[number]):
                children.setdefault(self.name(child), child)
        return self._last_children[number]

    def start(self, number: int) -> int:
        """Return the offset of an element's start."""
        return self.tag(number).name.start - 1

    def whole(self, number: int) -> Span:
        """Return an element with its tags."""
        return self.places.whole(number)

    def closed(self, number: int) -> bool:
        """Tell whether an element has one tag only."""
        return self.text[self.tag(number).end - 2] == "/"

    def content(self, number: int) -> Span:
        """Return the span between the tags of an element that has two."""
        return self.places.content(number)

    def names(self, number: int) -> list[Span]:
        """Return the name of an element, in each of its tags."""
        first = self.tag(number).name
        if self.closed(number):
            return [first]
        start = self.content(number).end + 2
        return [first, Span(start, start + first.end - first.start)]

    def attributes(self, number: int) -> list[Attribute]:
        """Return all attributes of an element, also those that are given twice."""
        found, at = [], self.tag(number).name.end
        while match := WRITTEN.match(self.text, at):
            value = Span(*match.span(2 if match[2] is not None else 3))
            found.append(Attribute(match[1], Span(*match.span(1)), value))
            at = match.end()
        return found

    def in_section(self, at: int) -> bool:
        """Tell whether only space is between *at* and the beginning of a CDATA section."""
        return self.text.startswith(SECTION, self.before(at) - len(SECTION))

    def before(self, at: int, space: str = SPACE) -> int:
        """Return the end of what stands before *at* and the *space* there."""
        while at and self.text[at - 1] in space:
            at -= 1
        return at

    def behind(self, at: int, space: str = SPACE) -> int:
        """Return the beginning of what stands behind *at* and the *space* there."""
        while at < len(self.text) and self.text[at] in space:
            at += 1
        return at

    def begins_line(self, at: int) -> bool:
        """Tell whether only blanks precede *at* in its line."""
        edge = self.before(at, " \t")
        return edge == 0 or self.text[edge - 1] in "\r\n"

    def ends_line(self, at: int) -> bool:
        """Tell whether only blanks follow *at* in its line."""
        edge = self.behind(at, " \t")
        return edge == len(self.text) or self.text[edge] in "\r\n"

    def indent(self, number: int) -> str | None:
        """Return the space before an element; None if something else is before it in its line."""
        start = self.start(number)
        return self.text[self.before(start, " \t") : start] if self.begins_line(start) else None

    def line_end(self, at: int) -> str:
        """Return the line end of the line of *at*, or else of the first.

        Empty if there is one line only.
        """
        found = BREAK.search(self.text, at) or BREAK.search(self.text)
        return found[0] if found else ""

    def step(self, number: int) -> str:
        """Return the further indentation of an element's children, real or likely."""
        for each in (number, self.parents[number]):
            if each >= 0 and (found := self._step(each)):
                return found
        return self._usual_step

    def _step(self, number: int) -> str:
        own = self.indent(number)
        if own is None:
            return ""
        for child in self.children[number]:
            inner = self.indent(child)
            if inner is not None and inner.startswith(own) and inner != own:
                return inner[len(own) :]
        return ""

    @cached_property
    def _usual_step(self) -> str:
        steps = (self._step(number) for number in range(len(self.parents)))
        return next(filter(None, steps), DEFAULT_INDENT)

    def quote(self, number: int) -> str:
        """Return the mark round attribute values in an element, or else where the next ones are."""
        at = number
        while at >= 0:
            if written := self.attributes(at):
                return self.text[written[-1].value.end]
            at = self.parents[at]
        return '"'

    @cached_property
    def ending(self) -> str:
        """Return the usual end of elements without content."""
        return " />" if self.text.count(" />") * 2 > self.text.count("/>") else "/>"
