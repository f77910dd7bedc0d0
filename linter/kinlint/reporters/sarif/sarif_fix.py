"""Fixes as SARIF has them, in a form that viewers apply like the specification.

The viewer of VS Code moves a region that starts in the indentation of a line to the end of that,
so no region here starts at a blank (sarif-vscode-extension, `resultActions`); byte offsets, which
it takes for those of a binary file, are left out.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from kinlint.edits import Edit
from kinlint.finding import Fix
from kinlint.reporters.sarif.sarif_message import escaped
from kinlint.text import Span

ZERO_WIDTH = "\ufeff"
"""White space in JavaScript that is none in Python."""


def fix_object(fix: Fix, changes: list[dict[str, Any]]) -> dict[str, Any]:
    """The `fix` object that makes *changes*, with how far it may be trusted and its update."""
    properties = {
        "kinlint/applicability": fix.applicability.label,
        "kinlint/sparqlUpdate": fix.update,
    }
    if fix.why:
        properties["kinlint/why"] = fix.why
    return {
        "description": {"text": escaped(fix.title)},
        "artifactChanges": changes,
        "properties": properties,
    }


def anchored(text: str, edits: Sequence[Edit]) -> list[Edit]:
    """Edits that make of *text* what *edits* make of it, and start at no blank.

    *edits* are in order. An edit begins later where it would write again what stands there, or
    else earlier, so that it writes again the characters before the blanks; two that meet are one.
    At the beginning of a text with nothing before, it stays where it is.
    """
    made: list[Edit] = []
    for span, new in edits:
        start = _start(text, span, new)
        grown = Edit(Span(start, span.end), text[start : span.start] + new)
        if start > span.start:
            grown = Edit(Span(start, span.end), new[start - span.start :])
        if made and grown.span.start <= made[-1].span.end:
            last = made.pop()
            between = text[last.span.end : span.start]
            grown = Edit(Span(last.span.start, span.end), last.text + between + new)
        made.append(grown)
    return made


def _start(text: str, span: Span, new: str) -> int:
    """The offset nearest to the start of *span* from which on an edit can say the same."""
    at = span.start
    for old, again in zip(text[at : span.end], new, strict=False):
        if old != again or not _blank(old):
            break
        at += 1
    if not _blank(text[at : at + 1]):
        return at
    at = span.start
    while at > 0 and _blank(text[at : at + 1]):
        at -= 1
    return span.start if _blank(text[at : at + 1]) else at


def _blank(char: str) -> bool:
    """Tell whether *char* is white space, or the end of the text."""
    return not char or char.isspace() or char == ZERO_WIDTH
