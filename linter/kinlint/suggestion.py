"""The nearest of the known names, for "did you mean" in messages."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

LOOKED_UP = 100
"""Most names of a model that are compared with all others: each takes time linear in those."""


def nearest(word: str, choices: Iterable[str]) -> str | None:
    """Return the choice most like *word*, or None if none is like it.

    Upper and lower case differ by nothing. A third of the letters may be inserted, deleted,
    replaced or swapped with their neighbour; failing that, *word* may be the beginning of a
    choice, or a part of it between hyphens, and then the shortest is meant. Ties go to the longer
    common beginning, then to the alphabet.
    """
    wanted = word.casefold()
    names = [(name.casefold(), name) for name in set(choices)] if wanted else []
    if not names:
        return None
    most = max(1, len(wanted) // 3)
    slips, _, choice = min(
        (
            (slips, -_shared(wanted, folded), name)
            for slips, folded, name in _near(wanted, names, most)
        ),
        default=(most + 1, 0, ""),
    )
    if slips <= most and slips < len(choice):
        return choice
    part = wanted.lstrip("-")
    if len(part) <= 1:
        return None
    longer = [name for folded, name in names if folded.startswith(wanted)] or [
        name for folded, name in names if part in folded and part in re.split("[-_]", folded)
    ]
    return min(longer, key=lambda name: (len(name), name), default=None)


def _near(
    wanted: str, names: Sequence[tuple[str, str]], most: int
) -> Iterator[tuple[int, str, str]]:
    """Yield those of *names* within *most* edits of *wanted*, each with its number of edits."""
    from rapidfuzz import process  # noqa: PLC0415  few runs suggest anything
    from rapidfuzz.distance import OSA  # noqa: PLC0415

    folded = [each for each, _ in names]
    found = process.extract(wanted, folded, scorer=OSA.distance, score_cutoff=most, limit=None)
    for _, slips, at in found:
        yield int(slips), *names[at]


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
