"""Finds the elements of a text that are new, and those that stood in the text before."""

from __future__ import annotations

from dataclasses import dataclass, field

from kinlint.formats.json_text.json_parser import Element, element
from kinlint.formats.json_text.json_values import Object
from kinlint.formats.jsonld.incremental.changed_range import Difference
from kinlint.formats.jsonld.incremental.part_expander import Indivisible
from kinlint.formats.jsonld.incremental.part_order import Arrangement
from kinlint.text import SourceText, Span

WITHIN = 2
"""The object and the array in which the elements of the outermost graph stand."""
NEAR = 8
"""Number of neighbours, before and behind, with which an element is compared."""


@dataclass
class Aligned:
    """The elements round a change: those that were parsed now, and the numbers of earlier ones.

    `starts` is where each of them stands. Before them all goes what was before `first`, and behind
    them what was at `rest` and later.
    """

    first: int
    rest: int = 0
    elements: list[Element | int] = field(default_factory=list)
    starts: list[int] = field(default_factory=list)

    def add(self, element: Element | int, start: int) -> None:
        """The next element, and where it stands."""
        self.elements.append(element)
        self.starts.append(start)


def aligned(
    old: Arrangement, before: str, source: SourceText, change: Difference, graph: Span
) -> Aligned:
    """The elements of *source* round *change*; those of the text *before* are *old*, in *graph*.

    Raises Indivisible if the change reaches beyond the graph or has elements that are no objects,
    SourceError if it is no JSON.
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
