"""The nearest of the known names, for "did you mean" in messages."""

from __future__ import annotations

import re
from collections.abc import Iterable


def nearest(word: str, choices: Iterable[str]) -> str | None:
    """Return the choice most like *word*, or None if none is like it.

    Upper and lower case differ by nothing. A third of the letters may be inserted, deleted,
    replaced or swapped with their neighbour; failing that, *word* may be the beginning of a
    choice, or a part of it between hyphens, and then the shortest is meant. Ties go to the longer
    common beginning, then to the alphabet.
    """
    wanted = word.casefold()
    most = max(1, len(wanted) // 3)
    ranked = sorted(
        (distance(wanted, choice.casefold(), most), -_shared(wanted, choice.casefold()), choice)
        for choice in set(choices)
    )
    if not wanted or not ranked:
        return None
    slips, _, choice = ranked[0]
    if slips <= most and slips < len(choice):
        return choice
    part = wanted.lstrip("-")
    if len(part) <= 1:
        return None
    names = [choice for _, _, choice in ranked]
    longer = [name for name in names if name.casefold().startswith(wanted)] or [
        name for name in names if part in re.split("[-_]", name.casefold())
    ]
    return min(longer, key=lambda name: (len(name), name), default=None)


def did_you_mean(word: str, choices: Iterable[str]) -> str:
    """`, did you mean 'x'?` to put behind a message, or nothing."""
    found = nearest(word, choices)
    return f", did you mean '{found}'?" if found else ""


def _shared(one: str, other: str) -> int:
    length = 0
    for a, b in zip(one, other, strict=False):
        if a != b:
            break
        length += 1
    return length


def slips(one: str, other: str, most: int = 2) -> int | None:
    """Return the number of edits between two words that may be one, at most *most*; else None.

    Words that differ in their digits are different names.
    """
    if abs(len(one) - len(other)) > most or _digits(one) != _digits(other):
        return None
    found = distance(one, other, most)
    return found if found <= most else None


def _digits(text: str) -> str:
    return "".join(each for each in text if each.isdigit())


def distance(one: str, other: str, most: int | None = None) -> int:
    """Return the edit distance: insertions, deletions, replacements and swaps of neighbours.

    Known as optimal string alignment (Damerau 1964, restricted). All above *most* is *most* + 1.
    """
    from rapidfuzz.distance import OSA  # noqa: PLC0415  few runs suggest anything

    return OSA.distance(one, other, score_cutoff=most)
