"""Comments that silence rules, for text layers."""

from __future__ import annotations

from collections.abc import Iterable

from kinlint.edits import Edit
from kinlint.formats import line_comments as lines
from kinlint.text import SourceText, Span


def comment_edit(source: SourceText, place: Span, codes: Iterable[str], reason: str | None) -> Edit:
    """Return the edit that silences *codes* in what begins on the line of *place*.

    Nothing may stand before the first line: what is wrong there is silenced for the whole file.
    """
    end = source.text.find("\n") + 1
    if place.start >= end > 0:
        return lines.comment_edit(source, place, codes, reason)
    said = " ".join((reason or "").split())
    comment = f"# kinlint: file-ignore[{', '.join(codes)}] {said}".rstrip()
    text = f"{comment}\n" if end else f"\n{comment}"
    at = end or len(source.text)
    return Edit(Span(at, at), text)
