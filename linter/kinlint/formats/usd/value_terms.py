"""RDF terms of the values of attributes and metadata, by the types that a layer gives them."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from math import inf, isinf, isnan

from kinlint.formats.usd.usda_syntax import Value
from kinlint.light_dataclasses import dataclass
from kinlint.terms import XSD, Term, literal
from kinlint.text import Span

MOST_NUMBERS = 64
"""Arrays with more members are bulk data, of which nothing is stated."""
LARGEST_FLOAT = 3.4028235677973366e38
"""Numbers from here on are infinite in single precision."""
LARGEST_HALF = 65520.0
"""Numbers from here on are infinite in half precision."""
TRUTHS = {"true": "true", "yes": "true", "false": "false", "no": "false"}
"""Words that OpenUSD reads as truth values, in upper or lower case."""

_LIMITS = {"float": LARGEST_FLOAT, "half": LARGEST_HALF}
_WIDE = frozenset(
    {"double", "float", "half", "int", "int64", "uint", "uint64", "uchar", "timecode"}
)
_SHORT = {"h": "half", "f": "float", "d": "double", "i": "int"}
_MATRICES = {"matrix2d": 4, "matrix3d": 9, "matrix4d": 16, "frame4d": 16}
_COUNTS = {
    "point3": 3, "normal3": 3, "vector3": 3, "color3": 3, "color4": 4, "texCoord2": 2,
    "texCoord3": 3, "quat": 4,
}  # fmt: skip
"""Components of the types of which the last letter tells the precision."""


@dataclass(frozen=True, slots=True)
class ValueType:
    """Type of the values of an attribute."""

    scalar: str
    """Type of the components of numbers, "bool", or "" for words."""
    count: int
    """Number of components; 1 for what is no tuple."""
    array: bool
    """True for an array of such values."""


@dataclass(frozen=True, slots=True)
class Flaw:
    """Value that is none of its type."""

    span: Span
    """Place."""
    written: str
    """Text."""
    expected: str
    """Clause that says what values of the type are."""
    reason: str
    """Clause that says why this is none."""


@cache
def value_type(name: str) -> ValueType | None:
    """Return the type called *name*; None if its values are words or it is not known."""
    base = name.removesuffix("[]")
    array = base != name
    if base == "bool" or base in _WIDE:
        return ValueType(base, 1, array)
    if base in _MATRICES:
        return ValueType("double", _MATRICES[base], array)
    stem, end = base[:-1], base[-1:]
    if end in "234" and stem in _WIDE:
        return ValueType(stem, int(end), array)
    count = _COUNTS.get(stem)
    return ValueType(_SHORT[end], count, array) if count and end in _SHORT else None


def terms(value: Value, type_name: str) -> tuple[Sequence[tuple[Term, Span]], Sequence[Flaw]]:
    """Return the terms of the scalars in *value* with their places, and what is none of its type.

    Bulk data has no terms.
    """
    if value.kind in ("bulk", "dictionary", "samples") or value.text == "None":
        return (), ()
    kind = value_type(type_name)
    found: list[tuple[Term, Span]] = []
    flaws: list[Flaw] = []
    for scalar in value.scalars():
        if len(found) == MOST_NUMBERS:
            return (), ()
        if scalar.kind in ("dictionary", "samples", "bulk"):
            return (), ()
        term, flaw = _term(scalar, kind)
        found.append((term, scalar.content))
        if flaw is not None:
            flaws.append(flaw)
    if kind is not None and not kind.array and not flaws and len(found) != kind.count:
        expected = f"{kind.count} numbers" if kind.count > 1 else _expected(kind)
        count = f"{len(found)} values" if len(found) != 1 else "one value"
        flaws.append(
            Flaw(
                value.span, " ".join(t for t in (s.text for s in value.scalars())), expected, count
            )
        )
    return found, flaws


def _expected(kind: ValueType) -> str:
    return "true or false" if kind.scalar == "bool" else "a number"


def _term(value: Value, kind: ValueType | None) -> tuple[Term, Flaw | None]:
    """Return the term of a scalar, and what is wrong with it as one of *kind*, if anything."""
    text = value.text
    if kind is not None and kind.scalar == "bool":
        truth = _truth(value)
        known = value.kind == "number" or value.text.lower() in TRUTHS
        reason = f"{text} is neither true nor false"
        return truth, None if known else Flaw(value.span, text, "true or false", reason)
    if value.kind != "number":
        reason = f"{text or 'an empty text'} is not a number"
        flaw = Flaw(value.span, text, "a number", reason) if kind is not None else None
        return literal(text), flaw
    number = float(text)
    name = kind.scalar if kind is not None else "double"
    if isnan(number):
        reason = f"{text} is not a number"
    elif "inf" in text:
        return literal("-INF" if number < 0 else "INF", f"{XSD}double"), None
    elif isinf(number) or abs(number) >= _LIMITS.get(name, inf):
        reason = f"{text} is too large for a {name}"
    else:
        return f'"{text}"^^<{XSD}double>', None
    return literal(text), Flaw(value.span, text, "a number", reason)


def _truth(value: Value) -> Term:
    """Return the term of a value of an attribute that is true or false."""
    if value.kind == "number":
        return literal("true" if float(value.text) else "false", f"{XSD}boolean")
    truth = TRUTHS.get(value.text.lower())
    return literal(truth, f"{XSD}boolean") if truth is not None else literal(value.text)
