"""Values as words: how they compare, and how new ones are written."""

from __future__ import annotations

import re
from math import isfinite

from kinlint.edits import NotExpressible
from kinlint.formats.xml.recovery import CONTROL, HIGHEST
from kinlint.formats.xml.value_reading import HEXADECIMAL, INFINITE, NUMBER
from kinlint.terms import NUMERIC, XSD, Term, is_literal, literal_datatype, literal_value
from kinlint.text import SourceText

CANONICAL = re.compile(r"-?\d\.\d+E-?\d+", re.ASCII)
INEXACT = frozenset({f"{XSD}double", f"{XSD}float"})
TRUTHS = {"true": 1.0, "false": 0.0}
REFERENCE = re.compile(r"&(?:(amp|lt|gt|quot|apos)|#(\d{1,7})|#x([0-9a-fA-F]{1,6}));")
BREAKS = {"\t": "&#9;", "\n": "&#10;", "\r": "&#13;"}
NAMED = {"amp": "&", "lt": "<", "gt": ">", "quot": '"', "apos": "'"}
QUOTES = {'"': "&quot;", "'": "&apos;"}


def tokens(text: str) -> tuple[float | str, ...]:
    """Return the words of *text*; numbers and truths are equal if their values are."""
    return tuple(map(_token, text.split()))


def _token(word: str) -> float | str:
    if NUMBER.fullmatch(word):
        value = float(word)
        return value if isfinite(value) else word
    if HEXADECIMAL.fullmatch(word):
        return float(int(word, 16))
    lower = word.lower()
    return TRUTHS[lower] if lower in TRUTHS else INFINITE.get(lower, word)


def unescaped(raw: str) -> str:
    """Return *raw* of an XML text with references to characters resolved."""
    return REFERENCE.sub(_character, raw) if "&" in raw else raw


def _character(match: re.Match[str]) -> str:
    named, decimal, hexadecimal = match.groups()
    if named:
        return NAMED[named]
    code = int(decimal) if decimal else int(hexadecimal, 16)
    return chr(code) if code <= HIGHEST else match[0]


def is_number(term: Term) -> bool:
    """Tell whether *term* is a literal of a numeric type."""
    return term[-1:] == ">" and is_literal(term) and literal_datatype(term) in NUMERIC


def lexical_form(term: Term, kept: frozenset[str] = frozenset()) -> str:
    """Return a value as text; one spelled as in *kept* keeps its spelling.

    Numbers have as many digits as carry the value. Raises NotExpressible for what is no literal.
    """
    if not is_literal(term):
        raise NotExpressible("an attribute or a text cannot be a node")
    value, datatype = literal_value(term), literal_datatype(term)
    if value in kept or datatype not in NUMERIC:
        return value
    if datatype in INEXACT and not CANONICAL.fullmatch(value):
        return value if NUMBER.fullmatch(value) else value.lower()
    return value if datatype == f"{XSD}integer" else shortest(float(value))


def shortest(value: float) -> str:
    """Return the fewest digits that mean *value*, a whole number without a point."""
    return repr(value + 0.0).removesuffix(".0") if value else "0"


def escaped_attribute(value: str, quote: str, source: SourceText) -> str:
    """Return *value* escaped for an attribute between *quote* marks."""
    text = value.replace("&", "&amp;").replace("<", "&lt;").replace(quote, QUOTES[quote])
    for each, reference in BREAKS.items():
        text = text.replace(each, reference)
    return encodable(text, source)


def escaped_text(value: str, source: SourceText) -> str:
    """Return *value* escaped for the text between tags."""
    text = value.replace("&", "&amp;").replace("<", "&lt;").replace("]]>", "]]&gt;")
    return encodable(text.replace("\r", "&#13;"), source)


def cdata_content(value: str, source: SourceText) -> str:
    """Return *value* as content of a CDATA section; raises NotExpressible for what would end it."""
    text = encodable(value, source)
    if "]]>" in value or text != value:
        raise NotExpressible("a CDATA section cannot hold it")
    return text


def encodable(text: str, source: SourceText) -> str:
    """Return *text* with references for the characters that the encoding of *source* lacks."""
    if CONTROL.search(text):
        raise NotExpressible("XML has no such character")
    if text.isascii():
        return text
    return text.encode(source.encoding, "xmlcharrefreplace").decode(source.encoding)
