"""Comments to the end of a line that silence rules."""

from __future__ import annotations

import re
from collections.abc import Iterable

from kinlint.edits import Edit
from kinlint.formats.line_directives import DIRECTIVE
from kinlint.formats.xml.comment_edit import LINE_END
from kinlint.formats.xml.suppression_comments import INTRODUCTION
from kinlint.text import SourceText, Span

_BLANK = re.compile(r"[ \t]*")


def comment_edit(source: SourceText, place: Span, codes: Iterable[str], reason: str | None) -> Edit:
    """Return the edit that silences *codes* in what begins on the line of *place*.

    It joins a comment above that gives the same reason, or adds a line.
    """
    text, said = source.text, " ".join((reason or "").split())
    listed = ", ".join(codes)
    start = _line(text, place.start)
    indentation = _BLANK.match(text, start)
    assert indentation is not None
    at = start
    while at:
        at = _line(text, at - (2 if text[at - 2 : at] == "\r\n" else 1))
        blank = _BLANK.match(text, at)
        there = DIRECTIVE.match(text, blank.end() if blank else at)
        if there is None:
            break
        if there[2] is not None and not there[1] and _reason(there[3]) == said:
            end = there.end(2)
            return Edit(Span(end, end), f", {listed}" if there[2].strip() else listed)
    found = LINE_END.search(text)
    written = f"# kinlint: ignore[{listed}]{' ' * bool(said)}{said}"
    return Edit(Span(start, start), f"{indentation[0]}{written}{found[0] if found else chr(10)}")


def _line(text: str, at: int) -> int:
    """Return where the line of *at* begins."""
    return max(text.rfind("\n", 0, at), text.rfind("\r", 0, at)) + 1


def _reason(said: str) -> str:
    introduction = INTRODUCTION.match(said)
    return " ".join(said[introduction.end() if introduction else 0 :].split())
