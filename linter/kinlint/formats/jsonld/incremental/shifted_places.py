"""Places of the statements and nodes of a file, computed on demand."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import repeat
from typing import TypeVar

from kinlint.document import NodeSpans
from kinlint.formats.jsonld.incremental.part import shifted
from kinlint.formats.jsonld.incremental.part_order import Arrangement
from kinlint.formats.source_layer import SourceLayer
from kinlint.terms import Term, Triple
from kinlint.text import Span

T = TypeVar("T")

ASIDE = -1
"""Stands for the number of a part where no part says a thing, but the source layer."""


def numbered(groups: Sequence[Collection[T]]) -> dict[T, int]:
    """Map each item in *groups*, in the order of first occurrence, to the number of its group."""
    found: dict[T, int] = {}
    size = 0
    for number, group in enumerate(groups):
        found.update(zip(group, repeat(number)))
        size += len(group)
    if size > len(found):
        for number in range(len(groups) - 1, -1, -1):
            found.update(zip(groups[number], repeat(number)))
    return found


class ShiftedNodeSpans(Mapping[Term, NodeSpans]):
    """The places of the nodes of parts that are *arranged*.

    Where several parts have a node, the first counts; *layer* goes before all of them.
    """

    def __init__(self, arranged: Arrangement, layer: SourceLayer) -> None:
        self._parts = arranged.parts
        self._shifts = arranged.shifts
        self._own = layer.nodes

    @cached_property
    def _numbers(self) -> dict[Term, int]:
        numbers = numbered([part.nodes for part in self._parts])
        for node in self._own:
            numbers.setdefault(node, ASIDE)
        return numbers

    def __getitem__(self, node: Term) -> NodeSpans:
        own = self._own.get(node)
        return self.described(node) if own is None else own

    def described(self, node: Term) -> NodeSpans:
        """Return the spans of the first description of *node*; KeyError if it is no node."""
        number = self._numbers[node]
        whole, identifier = spans = self._parts[number].nodes[node]
        by = self._shifts[number]
        if not by:
            return spans
        return NodeSpans(shifted(whole, by), identifier and shifted(identifier, by))

    def __contains__(self, node: object) -> bool:
        return node in self._numbers

    def __iter__(self) -> Iterator[Term]:
        return iter(self._numbers)

    def __len__(self) -> int:
        return len(self._numbers)


class ShiftedTripleSpans(Mapping[Triple, Span]):
    """The places of all that is *stated*, each with the number of the part that says it.

    The parts are *arranged*. What none says is in *layer*, or is that *nodes* are described.
    """

    def __init__(
        self,
        stated: Mapping[Triple, int],
        arranged: Arrangement,
        layer: SourceLayer,
        nodes: ShiftedNodeSpans,
    ) -> None:
        self._stated = stated
        self._parts = arranged.parts
        self._shifts = arranged.shifts
        self._own = layer.triples
        self._nodes = nodes

    def __getitem__(self, triple: Triple) -> Span:
        number = self._stated[triple]
        if number != ASIDE:
            return shifted(self._parts[number].spans[triple], self._shifts[number])
        own = self._own.get(triple)
        return self._nodes.described(triple[0]).best if own is None else own

    def __contains__(self, triple: object) -> bool:
        return triple in self._stated

    def __iter__(self) -> Iterator[Triple]:
        return iter(self._stated)

    def __len__(self) -> int:
        return len(self._stated)
