"""Numbers with as many digits as a reader needs."""

from __future__ import annotations

from math import isfinite

DIGITS = 6
"""Significant digits of a number, unless more are needed to tell it from another."""
MOST_DIGITS = 17
"""Significant digits of any double."""
SMALLEST = 1e-4
"""Smaller numbers are written with an exponent."""
GREATEST = 1e16
"""Numbers from here on are written with an exponent."""


def brief(number: str, digits: int = DIGITS) -> str:
    """Return *number* to at most so many significant *digits*.

    More are kept where it would otherwise read as a round number that it is not.
    """
    try:
        value = float(number)
    except ValueError:
        return number
    written = number.lower().partition("e")[0].lstrip("+-0.").replace(".", "").rstrip("0")
    if len(written) <= digits or not isfinite(value):
        return number
    while (short := f"{value:.{digits}g}") and _is_round(short) and digits < MOST_DIGITS:
        digits += 1
    exponent = not SMALLEST <= abs(value) < GREATEST
    return short if exponent or "e" not in short else f"{float(short):.0f}"


def _is_round(number: str) -> bool:
    """Tell whether *number* has so few digits that it looks chosen: 1, 0.5, but not 0.333333."""
    return len(number.partition("e")[0].strip("-0.").replace(".", "")) <= 1
