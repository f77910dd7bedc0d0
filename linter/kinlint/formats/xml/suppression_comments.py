"""Comments that silence rules: `kinlint: ignore[CODE, ...] reason`, `kinlint: file-ignore[...]`.

A comment on a line of its own is about the element that begins next, and about all within it; one
behind a tag is about the element of that tag. A reason may begin with an end:
`until 2030-01-31, the new gripper`.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, NamedTuple

from kinlint.formats.source_layer import SourceLayer
from kinlint.terms import Term, iri, literal
from kinlint.text import SourceText, Span
from kinlint.vocabulary import KL

if TYPE_CHECKING:
    from xml.parsers.expat import XMLParserType

    from kinlint.formats.xml.elements import Elements
    from kinlint.formats.xml.span_lookup import Offsets

MARK = "kinlint:"
DIRECTIVE = re.compile(r"<!--\s*kinlint:\s*(file-)?ignore\b\s*(?:\[([^\]]*)\])?(.*?)-->", re.DOTALL)
SELECTOR = re.compile(r"[^\s,]+")
UNTIL = re.compile(r"[\s:,;-]*until\s+(\d[\w-]*)")
INTRODUCTION = re.compile(r"[\s:,;-]*(?:--|\u2014|\u2013)?\s*")


class _Comment(NamedTuple):
    """Comment with a directive."""

    at: int
    """Offset in bytes."""
    holder: int
    """Element around it."""
    before: int
    """Element whose tag was read last."""
    behind: int
    """Next element, if one follows."""


class Comments:
    """The comments of a text that speak to kinlint."""

    def __init__(self, source: SourceText) -> None:
        self._text = source.text
        self._found: list[_Comment] = []

    def listen(self, parser: XMLParserType, elements: Elements) -> None:
        """Have *parser* tell of comments, if there is one that matters."""
        if MARK not in self._text:
            return

        def comment(text: str) -> None:
            if text.lstrip().startswith(MARK):
                holder, begun = elements.frames[-1][3], len(elements.starts)
                before = holder if holder == begun - 1 else elements.closed
                self._found.append(_Comment(parser.CurrentByteIndex, holder, before, begun))

        parser.CommentHandler = comment

    def state(self, layer: SourceLayer, elements: Elements, offset: Offsets) -> None:
        """Put what they silence into *layer*."""
        nodes, last, alone = list(elements.index), -1, False
        for each in self._found:
            match = DIRECTIVE.match(self._text, offset(each.at))
            if match is None:
                continue
            before = self._before(match.start())
            alone = alone if before == last else before == 0 or self._text[before - 1] in "\r\n"
            last = match.end()
            covered = each.before
            if alone:
                inside = each.behind < len(nodes) and (
                    each.holder < 0 or elements.starts[each.behind] < elements.ends[each.holder]
                )
                covered = each.behind if inside else -1
            state_directive(match, layer, nodes[covered] if 0 <= covered < len(nodes) else None)

    def _before(self, at: int) -> int:
        """Return the end of what is written before *at*, or of its line."""
        while at and self._text[at - 1] in " \t":
            at -= 1
        return at


def state_directive(match: re.Match[str], layer: SourceLayer, covered: Term | None) -> None:
    """State the directive *match* of the node *covered*; of a file it needs none.

    Its groups are `file-` or nothing, the codes, and what follows them.
    """
    note = layer.add_node("Comment", Span(*match.span()), ("node", covered))
    place = Span(*match.span())
    target = layer.document if match[1] else covered or note
    layer.triples[target, iri(f"{KL}ignore"), note] = place
    codes = list(SELECTOR.finditer(match[2] or ""))
    for code in codes:
        at = match.start(2)
        layer.triples[note, iri(f"{KL}rule"), literal(code[0])] = Span(
            at + code.start(), at + code.end()
        )
    if not codes:
        layer.triples[note, iri(f"{KL}rule"), literal("")] = place
    start, end = match.span(3)
    if until := UNTIL.match(match[0], start - match.start(), end - match.start()):
        ending = Span(match.start() + until.start(1), match.start() + until.end(1))
        layer.triples[note, iri(f"{KL}until"), literal(until[1])] = ending
        start = ending.end
    written = match.string[start:end]
    introduction = INTRODUCTION.match(written)
    reason = written[introduction.end() if introduction else 0 :].strip()
    if reason:
        start += written.index(reason)
        said = literal(" ".join(reason.split()))
        layer.triples[note, iri(f"{KL}reason"), said] = Span(start, start + len(reason))
