"""A file that may have any number of some part."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple


class Growing(NamedTuple):
    """A file that grows in one respect."""

    title: str
    """Format and what there is more and more of."""
    name: str
    """The name of the file, from which its format follows."""
    text: Callable[[int], str]
    """The text that has so many of them."""
    count: int
    """The number that is linted first, and then four times as many."""


def numbered(line: str, count: int) -> str:
    """Return *count* copies of *line*, each with its number in place of every `@`."""
    return "".join(f"{line.replace('@', str(number))}\n" for number in range(count))
