"""Alignment of two texts: the changed range, new elements, and those that were there before."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

from kinlint.formats.json_text.json_parser import ArrayElement, element
from kinlint.formats.json_text.json_values import Object
from kinlint.formats.jsonld.incremental.part import Arrangement
from kinlint.formats.jsonld.incremental.part_expander import Indivisible
from kinlint.light_dataclasses import dataclass, field
from kinlint.text import SourceText, Span


class Difference(NamedTuple):
    """Range in which two texts differ."""

    start: int
    """Start in both texts."""
    old_end: int
    """End in the old text."""
    new_end: int
    """End in the new text."""

    @property
    def shift(self) -> int:
        """Return the offset by which the text after it has moved."""
        return self.new_end - self.old_end


def difference(old: str, new: str) -> Difference:
    """Return the one range in which *old* and *new* differ."""
    most = min(len(old), len(new))
    start = _same(most, lambda low, high: old[low:high] == new[low:high])
    end, own = len(old), len(new)
    tail = _same(
        most - start,
        lambda low, high: old[end - high : end - low] == new[own - high : own - low],
    )
    return Difference(start, end - tail, own - tail)


def _same(most: int, equal: Callable[[int, int], bool]) -> int:
    """Return the length of the longest equal prefix, at most *most*, by binary search."""
    low = 0
    while low < most:
        middle = (low + most + 1) // 2
        if equal(low, middle):
            low = middle
        else:
            most = middle - 1
    return low


WITHIN = 2
"""The object and the array in which the elements of the outermost graph stand."""
NEAR = 8
"""Number of neighbours, before and behind, with which an element is compared."""


@dataclass
class Aligned:
    """Elements round a change."""

    first: int
    """Number of earlier elements before them."""
    rest: int = 0
    """Number of the first earlier element behind them."""
    elements: list[ArrayElement | int] = field(default_factory=list)
    """Elements that were parsed now, and the numbers of earlier ones."""
    starts: list[int] = field(default_factory=list)
    """Offsets of the elements."""

    def add(self, element: ArrayElement | int, start: int) -> None:
        """Add the next element, with its offset."""
        self.elements.append(element)
        self.starts.append(start)


def align(
    old: Arrangement, before: str, source: SourceText, change: Difference, graph: Span
) -> Aligned:
    """Return the elements of *source* round *change*; before, they were *old*, in *graph*.

    *before* is the earlier text. Raises Indivisible if the change reaches beyond the graph or has
    elements that are no objects, SourceError if it is no JSON.
    """
    # What only touches the change is read again as well: it may go on now.
    count, found = len(old.parts), Aligned(old.first_to(change.start))
    at = old.end_of(found.first - 1) if found.first else graph.start + 1
    unused = place = found.first
    while True:
        behind = bool(found.first or found.elements)
        if behind and at >= change.new_end:
            # Both texts are the same from here on, and so is what follows, if an element ended
            # here before.
            number = old.first_to(at - change.shift)
            if number < count and old.end_of(number) == at - change.shift:
                found.rest = number + 1
                return found
        near = range(max(unused, place - NEAR, 1), min(place + NEAR, count)) if behind else ()
        for number in near:
            stood = before[old.end_of(number - 1) : old.end_of(number)]
            if source.text.startswith(stood, at):
                at += len(stood)
                whole = old.parts[number].whole
                found.add(number, at - (whole.end - whole.start))
                unused = place = number + 1
                break
        else:
            each = element(source, at, first=not behind, depth=WITHIN)
            if each.closing:
                if each.span.start < change.new_end or each.span.end - change.shift != graph.end:
                    raise Indivisible
                found.rest = count
                return found
            if not isinstance(each.value, Object):
                raise Indivisible
            found.add(each, each.span.start)
            at, place = each.span.end, place + 1
