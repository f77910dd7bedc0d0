"""Lists that layers make up together, by items that are prepended, deleted and so on."""

from __future__ import annotations

from collections.abc import Hashable, Iterable
from typing import TypeVar

T = TypeVar("T", bound=Hashable)


def changed(before: list[T], operation: str, items: Iterable[T]) -> list[T]:
    """Return the list *before* after one *operation* with *items*; an empty one replaces it."""
    said = dict.fromkeys(items)
    if not operation:
        return list(said)
    if operation == "prepend":
        return [*said, *(each for each in before if each not in said)]
    if operation == "append":
        return [*(each for each in before if each not in said), *said]
    if operation == "add":
        return list(dict.fromkeys([*before, *said]))
    if operation == "delete":
        return [each for each in before if each not in said]
    return before
