"""A place where a text breaks the rules of XML."""

from __future__ import annotations

from typing import NamedTuple

from kinlint.text import Span


class SyntaxFlaw(NamedTuple):
    """Syntax error at *span*; *attribute* is the name of one given twice."""

    span: Span
    reason: str
    attribute: str | None = None
