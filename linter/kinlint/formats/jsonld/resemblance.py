"""The term of a context that a word without a meaning was perhaps meant to be.

A key is compared with properties and a type with classes, since nobody takes one for the other.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from typing import Any

from kinlint.suggestion import slips

SHORT = 4
"""Length of words in which one edit is as much as a slip can be."""
KEYWORDS = frozenset({"@graph", "@id", "@included", "@reverse", "@type", "@value", "@list", "@set"})
"""Keywords of JSON-LD, which are often written without their @."""
_CAPITAL = re.compile(r"[A-Z0-9]")

Terms = Mapping[str, Any]
"""The terms of an active context, with their definitions."""


def is_class(term: str, meaning: Any) -> bool:
    """Tell whether *term* names a class, by its definition and its capital."""
    if not meaning or meaning.get("@type") or meaning.get("@container") or is_prefix(meaning):
        return False
    whole = str(meaning.get("@id"))
    end = max(map(whole.rfind, "#/:")) + 1
    return _CAPITAL.search(whole, end) is not None and term[:1] != "@"


def is_prefix(meaning: Any) -> bool:
    """Tell whether a term stands for a namespace rather than for something in it."""
    return str(meaning.get("@id"))[-1:] in ("#", "/", "?", ":")


def nearest_property(key: str, terms: Terms, taken: Collection[str]) -> str | None:
    """Return the property or keyword that *key* was meant to be, none *taken* in its object."""
    if (keyword := f"@{key}") in KEYWORDS and keyword not in taken:
        return keyword
    names = (
        term
        for term, meaning in terms.items()
        if meaning and term not in taken and not is_prefix(meaning) and not is_class(term, meaning)
    )
    return _nearest(key, names)


def nearest_class(name: str, terms: Terms) -> str | None:
    """Return the class that the type *name* was meant to be."""
    return _nearest(name, (term for term, meaning in terms.items() if is_class(term, meaning)))


def _nearest(word: str, names: Iterator[str]) -> str | None:
    most = 1 if len(word) <= SHORT else 2
    found = sorted((edits, name) for edits, name in _ranked(word, names, most))
    tied = len(found) > 1 and found[0][0] == found[1][0]
    return found[0][1] if found and not tied else None


def _ranked(word: str, names: Iterator[str], most: int) -> Iterator[tuple[int, str]]:
    for name in names:
        edits = slips(word.casefold(), name.casefold(), most)
        if edits is not None and edits < min(len(name), len(word)):
            yield edits, name
