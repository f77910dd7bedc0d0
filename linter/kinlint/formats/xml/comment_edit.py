"""Comments that silence rules, for elements of XML."""

from __future__ import annotations

import re
from collections.abc import Iterable

from kinlint.edits import Edit, NotExpressible
from kinlint.formats.xml.suppression_comments import DIRECTIVE, INTRODUCTION
from kinlint.text import SourceText, Span

ELEMENT = re.compile(r"<[^\s<>/!?]")
"""The beginning of an element, as opposed to a comment or an instruction."""
LINE_END = re.compile(r"\r\n?|\n")
STRANGE = re.compile(r"--|-$|[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""Text that a comment of XML cannot hold (XML 1.0, productions 2 and 15)."""


def comment_edit(
    source: SourceText, element: Span, codes: Iterable[str], reason: str | None
) -> Edit:
    """Return the edit that silences *codes* in the element that *element* covers.

    It joins a comment that is there for the same reason; else it is a line above the element, or
    follows the element if that does not begin its line.

    Raises NotExpressible for a reason that no comment can hold.
    """
    text, said = source.text, " ".join((reason or "").split())
    if STRANGE.search(said):
        raise NotExpressible("no comment in XML can hold this reason")
    listed = ", ".join(codes)
    start, above = _beginning(text, element.start)
    there = _above(text, start) if above is not None else DIRECTIVE.match(text, element.end)
    while there is not None and not _same(there, said):
        there = _above(text, there.start()) if above is not None else None
    if there is not None:
        at = there.end(2)
        return Edit(Span(at, at), f", {listed}" if there[2].strip() else listed)
    written = f"<!-- kinlint: ignore[{listed}]{' ' * bool(said)}{said} -->"
    if above is None:
        return Edit(Span(element.end, element.end), written)
    return Edit(Span(start, start), f"{above}{written}{_line_end(text, start)}")


def _beginning(text: str, at: int) -> tuple[int, str | None]:
    """Return where the line of *at* begins, and its indentation; None if *at* is further in."""
    start = max(text.rfind("\n", 0, at), text.rfind("\r", 0, at)) + 1
    before = text[start:at]
    return start, before if not before.strip(" \t") else None


def _above(text: str, at: int) -> re.Match[str] | None:
    """Return the comment for kinlint on its own line that only space parts from *at*."""
    end = _trimmed(text, at)
    begin = text.rfind("<!--", 0, end)
    if begin < 0 or not text.startswith("-->", end - 3):
        return None
    found = DIRECTIVE.match(text, begin)
    alone = _beginning(text, begin)[1] is not None
    return found if found and alone and found.end() == end and not found[1] else None


def _trimmed(text: str, at: int) -> int:
    while at and text[at - 1].isspace():
        at -= 1
    return at


def _same(found: re.Match[str], reason: str) -> bool:
    """Tell whether the comment *found* gives *reason* and no other, for a list of rules."""
    said = found[3]
    introduction = INTRODUCTION.match(said)
    told = " ".join(said[introduction.end() if introduction else 0 :].split())
    return found[2] is not None and not found[1] and told == reason


def _line_end(text: str, at: int) -> str:
    """Return the line end before *at*, or else the first one."""
    if at:
        return "\r\n" if text[at - 2 : at] == "\r\n" else text[at - 1]
    found = LINE_END.search(text)
    return found[0] if found else "\n"
