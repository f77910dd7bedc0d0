"""Elements that are put into others, laid out like those that are there."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence

from kinlint.edits import Edit
from kinlint.formats.xml.editing.element_layout import BREAK, ElementLayout
from kinlint.formats.xml.editing.element_sites import Site
from kinlint.light_dataclasses import dataclass
from kinlint.text import Span

COMMENTS = re.compile(r"(?:[ \t]*<!--(?:[^-\r\n]|-(?!->))*-->)+(?=[ \t]*(?:[\r\n]|\Z))")


@dataclass(frozen=True)
class ElementStyle:
    """Layout of an element."""

    indent: str
    """Indentation of the element."""
    step: str
    """Further indentation of its children."""
    line_end: str
    """Line end; empty if all is in one line."""

    @property
    def space(self) -> str:
        """Return the space before the element."""
        return f"{self.line_end}{self.indent}" if self.line_end else ""

    @property
    def inner(self) -> ElementStyle:
        """Return the layout of its children."""
        return ElementStyle(f"{self.indent}{self.step}", self.step, self.line_end)


Written = Callable[[ElementStyle], str]
"""An element, to be written in some manner."""


def replacement(layout: ElementLayout, number: int, new: Written) -> Edit:
    """Return the edit that replaces an element by *new*."""
    return Edit(layout.whole(number), new(_manner(layout, number)))


def insertion(site: Site, new: Sequence[Written], before: int | None) -> Edit:
    """Return the edit that inserts *new* elements into *site*, behind the child *before*.

    They are the first children without one.
    """
    layout, parent = site.layout, site.number
    if layout.closed(parent):
        inside = within(_manner(layout, parent), new)
        return Edit(opening(layout, parent), f">{inside}</{site.tag}>")
    if before is None:
        return _first(layout, parent, new)
    manner = _manner(layout, before)
    at = layout.whole(before).end
    space = manner.space
    if manner.line_end:
        space = _gap(layout, parent, before) or space
        if comments := COMMENTS.match(layout.text, at):
            at = comments.end()
    else:
        start = layout.start(before)
        space = layout.text[layout.before(start, " \t") : start]
    return Edit(Span(at, at), "".join(f"{space}{each(manner)}" for each in new))


def _manner(layout: ElementLayout, number: int) -> ElementStyle:
    """Return the layout of an existing element."""
    indent, start = layout.indent(number), layout.start(number)
    if indent is None or layout.line_end(start) == "":
        return ElementStyle("", "", "")
    return ElementStyle(indent, layout.step(number), layout.line_end(start))


def _gap(layout: ElementLayout, parent: int, number: int) -> str | None:
    """Return the space between an element and the one before it, if nothing else is there."""
    siblings = layout.children[parent]
    index = siblings.index(number)
    if not index:
        return None
    space = layout.text[layout.whole(siblings[index - 1]).end : layout.start(number)]
    return space if space.isspace() and BREAK.search(space) else None


def opening(layout: ElementLayout, number: int) -> Span:
    """Return the span to remove from an element with one tag before content can be inserted."""
    end = layout.tag(number).end
    start = layout.before(end - 2)
    return Span(end - 2 if BREAK.search(layout.text, start, end) else start, end)


def within(manner: ElementStyle, new: Sequence[Written]) -> str:
    """Return *new* elements as the whole content of one that is laid out in *manner*."""
    inner = manner.inner
    return "".join(f"{inner.space}{each(inner)}" for each in new) + manner.space


def _first(layout: ElementLayout, parent: int, new: Sequence[Written]) -> Edit:
    """Return the edit that gives *new* elements to a parent with two tags and no element in it."""
    manner, content = _manner(layout, parent), layout.content(parent)
    text = layout.source[content]
    end = layout.before(content.end)
    if not text.strip():
        if not BREAK.search(text):
            return Edit(content, within(manner, new))
        end = content.start
    elif not BREAK.search(text):
        return Edit(Span(end, end), "".join(each(ElementStyle("", "", "")) for each in new))
    inner = manner.inner
    return Edit(Span(end, end), "".join(f"{inner.space}{each(inner)}" for each in new))
