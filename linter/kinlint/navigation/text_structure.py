"""Parts of a text that can be folded and selected, as far as it is written."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kinlint.formats.json_text.unfinished_json import UnfinishedJson
from kinlint.formats.recognition import with_format
from kinlint.formats.xml.unfinished_text import UnfinishedText
from kinlint.text import SourceText, Span

_STATEMENT = re.compile(r"(?m)^[^\s#@][^\n]*(?:\n(?:[ \t][^\n]*|(?=\n)))*")
_WORD = re.compile(r"[\w:.#/-]+")
_VALUE = re.compile(r"\"[^\"<>\r\n]*\"|'[^'<>\r\n]*'|[^\s\"'<>=]+")


class Part(NamedTuple):
    """A part of a text."""

    span: Span
    """Place of it."""
    inner: Span
    """Place of its content, without what begins and ends it."""
    is_comment: bool = False
    """True of a comment."""


def parts(source: SourceText) -> Sequence[Part]:
    """Return the elements, objects or statements of *source*, outer ones before those in them."""
    form = with_format(source).format
    if form is None:
        return ()
    found = _elements if form.fence == "xml" else _nodes if form.fence == "json" else _statements
    return sorted(found(source.text), key=lambda each: (each.span.start, -each.span.end))


def selections(source: SourceText, offset: int) -> Sequence[Span]:
    """Return the parts of *source* around *offset*, the innermost first, each in the next."""
    around = [each for each in parts(source) if each.span.start <= offset <= each.span.end]
    spans = [span for each in around for span in (each.span, each.inner)]
    spans += _words(source, offset)
    spans.append(Span(0, len(source.text)))
    holding = {each for each in spans if each.start <= offset <= each.end and each.start < each.end}
    found: list[Span] = []
    for each in sorted(holding, key=lambda span: (span.end - span.start, span)):
        if not found or (each.start <= found[-1].start and found[-1].end <= each.end):
            found.append(each)
    return found


def _words(source: SourceText, offset: int) -> Iterator[Span]:
    """Yield the word and the value in the line of *offset* that it is in."""
    start = source.line_starts[source.position(offset).line - 1]
    line = source.line(source.position(offset).line)
    for pattern in (_WORD, _VALUE):
        for match in pattern.finditer(line):
            span = Span(start + match.start(), start + match.end())
            yield span
            if match[0][:1] in "\"'":
                yield Span(span.start + 1, span.end - 1)


def _elements(text: str) -> Iterator[Part]:
    read = UnfinishedText(text)
    for each in read.elements:
        closing = each.end if each.is_open else text.rfind("</", each.content, each.end)
        inner = Span(each.content, closing if closing >= 0 else each.content)
        yield Part(Span(each.start, max(each.end, each.content)), inner)
    for comment in read.comments:
        whole = Span(comment.start - len("<!--"), min(comment.end + len("-->"), len(text)))
        yield Part(whole, comment, is_comment=True)


def _nodes(text: str) -> Iterator[Part]:
    for each in UnfinishedJson(text, -1).nodes:
        yield Part(
            each.span, Span(each.span.start + 1, max(each.span.end - 1, each.span.start + 1))
        )


def _statements(text: str) -> Iterator[Part]:
    for match in _STATEMENT.finditer(text):
        span = Span(match.start(), match.start() + len(match[0].rstrip()))
        yield Part(span, span)
