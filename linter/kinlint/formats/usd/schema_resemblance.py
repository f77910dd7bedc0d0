"""Schemas and properties whose names differ by a slip from one that is not known."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from kinlint.formats.usd.prim_schemas import prim_schemas
from kinlint.suggestion import nearest

LONGEST_WORD = 60
"""Most characters of a name that is compared."""


@cache
def resembling_schema(name: str, *, applied: bool) -> str | None:
    """Return the schema that is spelt like *name*, or has the same words in another order."""
    if len(name) > LONGEST_WORD:
        return None
    names = [
        each.name
        for each in prim_schemas().values()
        if each.applied is applied and not each.abstract
    ]
    words = sorted(_words(name))
    same = next((each for each in names if sorted(_words(each)) == words), None)
    return same or nearest(name, names)


def _words(name: str) -> Iterator[str]:
    """Yield the words of a name in capitals and small letters, in small letters."""
    word = ""
    for letter in name:
        if letter.isupper() and not word.isupper():
            if word:
                yield word.lower()
            word = ""
        word += letter
    if word:
        yield word.lower()


@cache
def resembling_property(name: str, known: frozenset[str]) -> str | None:
    """Return the property in *known* that differs by a slip, in the namespace or behind it."""
    space, _, last = name.rpartition(":")
    if not space and f"physics:{name}" in known:
        return f"physics:{name}"
    near = {
        each.rpartition(":")[2]: each for each in sorted(known) if each.rpartition(":")[0] == space
    }
    if like := nearest(last, near):
        return near[like]
    spaces = {
        each.rpartition(":")[0]: each for each in sorted(known) if each.rpartition(":")[2] == last
    }
    like = nearest(space, spaces) if space else None
    return spaces[like] if like else None
