"""Makes a text well-formed that its usual readers read although it is not.

No character moves: what is in the way gives way to as many others, and what has to be inserted
counts for nothing (`Offsets`).
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

from kinlint.formats.xml.tag_scanner import LOST
from kinlint.light_dataclasses import dataclass
from kinlint.text import Span


class SyntaxFlaw(NamedTuple):
    """A syntax error."""

    span: Span
    """Its place."""
    reason: str
    """The fault, in words."""
    attribute: str | None = None
    """Name of an attribute that is given twice."""


DECLARATION = re.compile(r"<\?[xX][mM][lL](?=[\s?])")
SOUND = re.compile(
    r"""<\?xml\s+version\s*=\s*(?:"1\.\d+"|'1\.\d+')
    (?:\s+encoding\s*=\s*(?:"[A-Za-z][\w.-]*"|'[A-Za-z][\w.-]*'))?
    (?:\s+standalone\s*=\s*(?:"(?:yes|no)"|'(?:yes|no)'))?\s*\?>""",
    re.VERBOSE | re.ASCII,
)
OTHERWISE_SOUND = re.compile(SOUND.pattern.replace(r"1\.\d+", r"[^<>\"']*"), SOUND.flags)
LEADING = re.compile(r"(?:\s|<\?[xX][mM][lL][\s?][^>]*>)+")
MARKS = re.compile("\ufeff+")
"""Byte order marks after the first one, which is not in the text."""
STRAY = re.compile(r"\s*+([^\s<][^<]*+)(?=<[A-Za-z?!])")
"""Text before the first tag, such as a comment without its <."""
CONTROL = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff\ud800-\udfff]+")
REFERENCE = re.compile(r"&(?:(amp|lt|gt|quot|apos)|#(\d+)|#x([0-9a-fA-F]+)|([\w.:-]*));|&")
HYPHENS = re.compile(r"--+|-\Z")
TAG = re.compile(
    r"<[^\s<>/=\"'!?&]++((?:\s*+[^\s<>/=\"']++\s*+=\s*+(?:\"[^\"]*+\"|'[^']*+'))*+)\s*+/?>"
)
ATTRIBUTE = re.compile(r"(\s*)([^\s<>/=\"']+)\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")

SPARE = [chr(code) for code in range(0xFDD0, 0xFDF0)]
"""Characters that XML allows and that mean nothing."""

MARKUP = "&<>"
HIGHEST, LONGEST_CODE = 0x10FFFF, 8


@dataclass(frozen=True, slots=True)
class RecoveredText:
    """Text in a form that a parser accepts, and what was wrong with it."""

    text: str
    """Text that a parser accepts."""
    flaws: Sequence[SyntaxFlaw] = ()
    """Places that are not well-formed."""
    inserted: Sequence[int] = ()
    """Offsets of characters that the original lacks."""
    stands_for: Mapping[int, str] | None = None
    """Replaced characters, which a parser would take for markup."""

    def cut(self, at: int, flaw: SyntaxFlaw) -> RecoveredText:
        """Return a copy with only space from the character *at* of the original on."""
        inserted = [each for count, each in enumerate(self.inserted) if each - count < at]
        at += len(inserted)
        text = self.text[:at] + " " * (len(self.text) - at)
        return RecoveredText(text, [*self.flaws, flaw], inserted, self.stands_for)


class _Edit(NamedTuple):
    """Replacement of the text at `span`; it is reported if it has a reason."""

    span: Span
    """The text that is replaced."""
    new: str
    """The text in its place."""
    reason: str = ""
    """Reason why readers need it."""
    attribute: str | None = None
    """Name of the attribute concerned, if it is about one."""
    shown: Span | None = None
    """Place to report it at, if that is another one."""


def is_sound(text: str) -> bool:
    """Tell whether the beginning of *text* is valid for strict readers."""
    if text.startswith("\ufeff"):
        return False
    return not DECLARATION.match(text) or SOUND.match(text) is not None


def recovered(text: str) -> RecoveredText:
    """Return *text* with all neutralised that may not stand where it does."""
    flaws = [
        SyntaxFlaw(Span(*match.span()), f"the character U+{ord(match[0][0]):04X}")
        for match in CONTROL.finditer(text)
    ]
    if flaws:
        text = CONTROL.sub(lambda match: " " * len(match[0]), text)
    spare = [each for each in SPARE if each not in text][: len(MARKUP)]
    if len(spare) < len(MARKUP):
        return RecoveredText(text, flaws)
    pieces, inserted, at, size = list[str](), list[int](), 0, 0
    for edit in _edits(text, dict(zip(MARKUP, spare, strict=True))):
        (start, end), new = edit.span, edit.new
        pieces += text[at:start], new
        size += start - at
        if start == end:
            inserted.append(size)
        size += len(new)
        at = end
        if edit.reason:
            flaws.append(SyntaxFlaw(edit.shown or edit.span, edit.reason, edit.attribute))
    pieces.append(text[at:])
    flaws.sort(key=lambda flaw: flaw.span)
    stands_for = {ord(new): old for old, new in zip(MARKUP, spare, strict=True)}
    return RecoveredText("".join(pieces), flaws, inserted, stands_for)


def _edits(text: str, spare: Mapping[str, str]) -> Iterator[_Edit]:
    """Yield the changes to *text*, in order, up to where its tags make no sense."""
    opening, at = _opening(text)
    yield from opening
    while (start := text.find("<", at)) >= 0:
        yield from _data(text, Span(at, start), spare)
        if text.startswith("<!--", start):
            end = text.find("-->", start + 4)
            yield from _comment(text, Span(start + 4, end))
            at = end + 3
        elif text.startswith("<?", start):
            at = text.find("?>", start) + 2
            yield from _declaration(text, Span(start, at))
        elif text.startswith("<![CDATA[", start):
            at = text.find("]]>", start) + 3
        elif text.startswith(("</", "<!"), start):
            at = text.find(">", start) + 1
        else:
            tag = TAG.match(text, start)
            if tag is None:
                return
            yield from _attributes(text, Span(*tag.span(1)), spare)
            at = tag.end()
        if at <= start:
            return


def _opening(text: str) -> tuple[list[_Edit], int]:
    """Return changes to what stands before the first whole tag, and where that begins."""
    edits, at = list[_Edit](), 0
    if (marks := MARKS.match(text)) is not None:
        at, reason = marks.end(), "a second byte order mark"
        if DECLARATION.match(text, at):
            at, reason = text.find("?>", at) + 2, f"{reason} before the XML declaration"
        edits.append(_Edit(Span(0, at), " " * at, reason, None, Span(*marks.span())))
    if (lost := LOST.match(text, at)) is not None:
        return [*edits, _lost(Span(*lost.span("cut")), lost["tag"])], lost.end()
    if (stray := STRAY.match(text, at)) is not None:
        span = Span(*stray.span(1))
        blank, shown = " " * (span.end - span.start), Span(span.start, span.start + 1)
        return [*edits, _Edit(span, blank, "text before the first tag", None, shown)], stray.end()
    return edits, at


def _lost(span: Span, tag: str | None) -> _Edit:
    """Return the change to a declaration, or the *tag* of the root, whose < is lost."""
    shown = Span(span.start, span.start + 1)
    if tag:
        return _Edit(Span(span.start, span.start), "<", f"no < before {tag}", None, shown)
    return _Edit(span, " " * (span.end - span.start), "no < before the declaration", None, shown)


def _data(text: str, span: Span, spare: Mapping[str, str]) -> Iterator[_Edit]:
    """Yield changes to text between tags."""
    edits = list(_ampersands(text, span, spare))
    at = text.find("]]>", *span)
    while at >= 0:
        place = Span(at + 2, at + 3)
        edits.append(_Edit(place, spare[">"], "]]> outside of a CDATA section"))
        at = text.find("]]>", at + 3, span.end)
    yield from sorted(edits)


def _ampersands(text: str, span: Span, spare: Mapping[str, str]) -> Iterator[_Edit]:
    for match in REFERENCE.finditer(text, *span):
        named, decimal, hexadecimal, unknown = match.groups()
        if named or _is_character(decimal, 10) or _is_character(hexadecimal, 16):
            continue
        reason = f"the undefined entity {match[0]}" if unknown else "unescaped &"
        start = match.start()
        yield _Edit(Span(start, start + 1), spare["&"], reason, None, Span(*match.span()))


def _is_character(digits: str | None, base: int) -> bool:
    if not digits or len(digits.lstrip("0")) > LONGEST_CODE:
        return False
    code = int(digits, base)
    return code <= HIGHEST and not CONTROL.match(chr(code))


def _comment(text: str, span: Span) -> Iterator[_Edit]:
    """Yield changes to the text of a comment; only the first is reported."""
    reason = "-- inside a comment"
    for match in HYPHENS.finditer(text, *span) if span.end > span.start else ():
        place = Span(*match.span())
        yield _Edit(place, "~" * (place.end - place.start), reason)
        reason = ""


@lru_cache(maxsize=1)
def _leading(text: str) -> int:
    """Return the end of the blanks and declarations that *text* begins with; searched once."""
    match = LEADING.match(text)
    return match.end() if match else 0


def _declaration(text: str, span: Span) -> Iterator[_Edit]:
    if span.end <= span.start or not DECLARATION.match(text, span.start):
        return
    blank = " " * (span.end - span.start)
    if 0 < span.start <= _leading(text):
        yield _Edit(span, blank, "an XML declaration that is not at the very beginning")
    elif span.start > 0:
        yield _Edit(span, blank, "an XML declaration after other content")
    elif not SOUND.fullmatch(text, *span):
        versioned = OTHERWISE_SOUND.fullmatch(text, *span)
        kind = "an unknown XML version" if versioned else "a malformed XML declaration"
        yield _Edit(span, blank, kind)


def _attributes(text: str, span: Span, spare: Mapping[str, str]) -> Iterator[_Edit]:
    """Yield changes to the attributes of a tag."""
    seen: set[str] = set()
    for match in ATTRIBUTE.finditer(text, *span):
        name, own = match[2], Span(*match.span(2))
        if not match[1] and own.start > span.start:
            yield _Edit(Span(own.start, own.start), " ", f"no space before {name}", None, own)
        if name in seen:
            whole = Span(own.start, match.end())
            yield _Edit(whole, " " * (whole.end - whole.start), f"a second {name}", name, own)
            continue
        seen.add(name)
        value = Span(*match.span(3 if match[3] is not None else 4))
        edits = list(_ampersands(text, value, spare))
        at = text.find("<", *value)
        while at >= 0:
            place = Span(at, at + 1)
            edits.append(_Edit(place, spare["<"], "unescaped <"))
            at = text.find("<", at + 1, value.end)
        yield from sorted(edits)
