"""Changes of a text, and the changes of a graph that they stand for."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from kinlint.light_dataclasses import dataclass
from kinlint.terms import Triple
from kinlint.text import Span

ZERO = re.compile(r"[+-]?0*\.?0*([eE][+-]?\d+)?", re.ASCII)


class Edit(NamedTuple):
    """Replacement of characters of a text."""

    span: Span
    """The characters that go; an empty span inserts."""
    text: str
    """The text in their place; an empty one deletes."""


@dataclass(frozen=True, slots=True)
class Delta:
    """Change of a document, without what stays."""

    removed: tuple[Triple, ...] = ()
    """Triples that go, as the document spells them."""
    added: tuple[Triple, ...] = ()
    """Triples that come; their new nodes are blank."""

    def __bool__(self) -> bool:
        return bool(self.removed or self.added)


class NotExpressible(Exception):
    """A delta cannot be written into the text, for the reason given."""


def negated(number: str) -> str:
    """Return the spelling of the negative of *number*: only its sign changes, if it is not 0."""
    if ZERO.fullmatch(number):
        return number
    return number[1:] if number.startswith("-") else f"-{number.lstrip('+')}"


def applied(text: str, edits: Iterable[Edit]) -> str:
    """*text* after all of *edits*, which must not overlap; of insertions at one place, in order."""
    pieces, at = [], 0
    for span, new in sorted(edits, key=lambda edit: edit.span):
        assert span.start >= at, "edits overlap"
        pieces += [text[at : span.start], new]
        at = span.end
    return "".join([*pieces, text[at:]])


def overlap(one: Sequence[Edit], other: Sequence[Edit]) -> bool:
    """Tell whether two groups of edits touch the same characters, or insert at the same place."""
    return any(
        a.span == b.span or (a.span.start < b.span.end and b.span.start < a.span.end)
        for a in one
        for b in other
    )
