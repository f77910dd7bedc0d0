"""Left and right in names, and the mirrored name on the other side."""

from __future__ import annotations

import re
from functools import lru_cache
from urllib.parse import quote, unquote

WORD = re.compile(r"[A-Z]?[a-z]+|[A-Z]+(?![a-z])|[^A-Za-z]+")
"""Word of a name: two in leftArm, LeftArm and LArm, three in left_arm with its underscore."""

_ORDINAL = re.compile(r";[0-9]+")
PAIRS = (
    ("left", "right"),
    ("l", "r"),
    ("fl", "fr"),
    ("rl", "rr"),
    ("bl", "br"),
    ("hl", "hr"),
    ("lf", "rf"),
    ("lh", "rh"),
)
OTHER = {one: other for pair in PAIRS for one, other in (pair, pair[::-1])}
LEFT = frozenset(left for left, _ in PAIRS)
SIDES = frozenset((*OTHER, "front", "middle", "mid", "rear", "back", "hind"))
MANY = 4096
"""Most names that are remembered: an edited robot is looked at again and again."""


@lru_cache(maxsize=MANY)
def twin(name: str) -> str | None:
    """Return the name on the right of a name on the left; None if it names no side, or several."""
    words = (word.lower() for word in WORD.findall(unquote(name)))
    sides = [word for word in words if word in OTHER]
    return counterpart(name) if len(sides) == 1 and sides[0] in LEFT else None


@lru_cache(maxsize=MANY)
def counterpart(name: str) -> str | None:
    """Return the name on the other side; None if *name* names no side, or several."""
    words = WORD.findall(unquote(name))
    sides = [index for index, word in enumerate(words) if word.lower() in OTHER]
    if len(sides) != 1:
        return None
    at = sides[0]
    words[at] = _alike(words[at], OTHER[words[at].lower()])
    return quote("".join(words), safe="") if "%" in name else "".join(words)


def is_left(name: str) -> bool | None:
    """Tell whether *name* is of the left side; None if it names no side, or several."""
    return None if counterpart(name) is None else twin(name) is not None


def _alike(model: str, word: str) -> str:
    """Return *word* in capitals as *model* has them."""
    if model.isupper():
        return word.upper()
    return word.capitalize() if model[0].isupper() else word


@lru_cache(maxsize=MANY)
def without_side(name: str) -> str:
    """Return *name* without its words for sides, the same for both of two twins."""
    words = WORD.findall(unquote(name))
    return "".join(each for each in words if each.lower() not in SIDES)


def sideless(address: str) -> str:
    """Return *address* without sides, and without the numbers of elements without a name."""
    return _ORDINAL.sub("", without_side(address))
