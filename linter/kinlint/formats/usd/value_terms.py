"""RDF terms of the values of attributes and metadata, by the types that a layer gives them."""

from __future__ import annotations

from collections.abc import Sequence
from math import inf, isinf, isnan

from kinlint.formats.usd.usda_syntax import Value
from kinlint.formats.usd.value_forms import Flaw
from kinlint.formats.usd.value_types import TRUTHS, ValueType, value_type
from kinlint.terms import XSD, Term, literal
from kinlint.text import Span

MOST_NUMBERS = 64
"""Arrays with more members are bulk data, of which nothing is stated."""
LARGEST_FLOAT = 3.4028235677973366e38
"""Numbers from here on are infinite in single precision."""
LARGEST_HALF = 65520.0
"""Numbers from here on are infinite in half precision."""
_LIMITS = {"float": LARGEST_FLOAT, "half": LARGEST_HALF}


def terms(value: Value, type_name: str) -> tuple[Sequence[tuple[Term, Span]], Sequence[Flaw]]:
    """Return the terms of the scalars in *value* with their places, and what is no such number.

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
    return found, flaws


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
