"""Parsing by expat; texts that are not well-formed are recovered and parsed again."""

from __future__ import annotations

import re
from collections.abc import Callable
from xml.parsers import expat
from xml.parsers.expat import errors

from kinlint.errors import SourceError
from kinlint.formats.xml.elements import Elements, TooLarge
from kinlint.formats.xml.recovery import RecoveredText, SyntaxFlaw, is_sound, recovered
from kinlint.formats.xml.span_lookup import NAME, Offsets
from kinlint.formats.xml.suppression_comments import Comments
from kinlint.formats.xml.tag_scanner import DEFINITION, first_tag
from kinlint.light_dataclasses import dataclass
from kinlint.text import SourceText, Span

MOST_CHARACTERS = 100_000_000

UNDEFINED = re.compile(r"<!DOCTYPE\s+[^\s\[<>]++\s*+>")
"""Names the root element and defines nothing."""

NO_ELEMENT, UNENDED, MISMATCH = (
    errors.codes[name]
    for name in (
        errors.XML_ERROR_NO_ELEMENTS,
        errors.XML_ERROR_UNCLOSED_TOKEN,
        errors.XML_ERROR_TAG_MISMATCH,
    )
)


@dataclass(frozen=True, slots=True)
class ExpatResult:
    """Result of expat."""

    elements: Elements
    """The elements."""
    comments: Comments
    """The comments that suppress findings."""
    offset: Offsets
    """Offsets in the text by those in bytes."""
    text: RecoveredText
    """The text as it was read, with repairs."""
    fatal: SyntaxFlaw | None = None
    """Reason why reading stopped; None if it did not."""

    @property
    def complete(self) -> bool:
        """Tell whether the root element was read to its end."""
        return self.elements.closed == 0


def parse(source: SourceText, fresh: Callable[[], Elements]) -> ExpatResult:
    """Parse *source* into the elements that *fresh* makes.

    Raises SourceError, with line and column, for a document type definition and for what is larger
    or deeper than any robot.
    """
    if len(source.text) > MOST_CHARACTERS:
        raise SourceError(source.name, f"more than {MOST_CHARACTERS} characters")
    if DEFINITION in source.text:
        _refuse_definitions(source)
    parsed = _parsed(source, RecoveredText(source.text), fresh())
    if parsed.fatal is None and is_sound(source.text):
        return parsed
    text = recovered(source.text)
    if text.flaws:
        parsed = _parsed(source, text, fresh())
    if parsed.fatal is not None and parsed.complete:
        at = parsed.fatal.span.start
        at -= source.text.startswith("<", at - 1)
        rest = source.text[at:].lstrip()
        at = len(source.text) - len(rest)
        line = rest.splitlines()[0] if rest else ""
        root = source.text[slice(*_tag(source, parsed, 0))]
        flaw = SyntaxFlaw(Span(at, at + len(line.rstrip())), f"content after the end of <{root}>")
        parsed = _parsed(source, text.cut(at, flaw), fresh())
    return parsed


def _parsed(source: SourceText, text: RecoveredText, elements: Elements) -> ExpatResult:
    offset, comments = Offsets(text.text, text.inserted), Comments(source)
    parser = expat.ParserCreate("utf-8")
    elements.listen(parser, text.stands_for)
    comments.listen(parser, elements)
    fatal = None
    try:
        parser.Parse(text.text.encode("utf-8", "surrogatepass"), True)  # noqa: FBT003
    except TooLarge as error:
        place = source.position(offset(error.byte))
        raise SourceError(source.name, str(error), place.line, place.column) from None
    except expat.ExpatError as error:
        at = offset(max(parser.ErrorByteIndex, 0))
        fatal = _fatal(source, ExpatResult(elements, comments, offset, text), error.code, at)
    return ExpatResult(elements, comments, offset, text, fatal)


def _refuse_definitions(source: SourceText) -> None:
    """Raise SourceError for a document type definition, before anything can act on it."""
    at = first_tag(source.text, DEFINITION)
    if at >= 0 and not UNDEFINED.match(source.text, at):
        place = source.position(at)
        cause = "a document type definition; kinlint reads none, and no robot needs one"
        raise SourceError(source.name, cause, place.line, place.column)


def _fatal(source: SourceText, parsed: ExpatResult, code: int, at: int) -> SyntaxFlaw:
    """Return the flaw that stopped expat at the character *at*."""
    frames = parsed.elements.frames
    number = frames[-1][3]
    if code == MISMATCH:
        at = source.text.rfind("</", 0, at + 2)
        end = source.text.find(">", at) + 1
        opened = source.text[slice(*_tag(source, parsed, number))]
        return SyntaxFlaw(Span(at, end), f"{source.text[at:end]} closes <{opened}>")
    if code == NO_ELEMENT and number >= 0:
        span = _tag(source, parsed, number)
        return SyntaxFlaw(span, f"<{source.text[slice(*span)]}> is never closed")
    if code == NO_ELEMENT:
        empty = not source.text.strip()
        reason = "the file is empty" if empty else "the file has no element"
        return SyntaxFlaw(Span(0, min(1, len(source.text))), reason)
    span = Span(at, min(at + 1, len(source.text)))
    if code == UNENDED:
        return SyntaxFlaw(span, "this tag, comment or section is never closed")
    return SyntaxFlaw(span, expat.ErrorString(code) or "a syntax error")


def _tag(source: SourceText, parsed: ExpatResult, number: int) -> Span:
    """Return the name of an element."""
    start = parsed.offset(parsed.elements.starts[number]) + 1
    match = NAME.match(source.text, start)
    return Span(start, match.end() if match else start)
