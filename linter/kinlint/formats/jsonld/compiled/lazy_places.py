"""Places of statements and nodes that are found when they are asked for."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import repeat

from kinlint.document import NodeSpans
from kinlint.formats.jsonld.compiled.compiled_graph import Group
from kinlint.formats.source_layer import DESCRIBED, SourceLayer
from kinlint.terms import Term, Triple
from kinlint.text import Span


class LazyNodeSpans(Mapping[Term, NodeSpans]):
    """Places of the nodes that *groups* describe; each has that of its first description."""

    def __init__(self, groups: Sequence[Group]) -> None:
        self._groups = groups
        self._numbers: dict[Term, int] = {}
        for number, group in enumerate(groups):
            for node in group.described:
                self._numbers.setdefault(node, number)
        self._own: Mapping[Term, NodeSpans] = {}

    def add_layer(self, layer: SourceLayer) -> None:
        """Add the nodes of *layer*, whose places go before."""
        self._own = layer.nodes
        for node in layer.nodes:
            self._numbers.setdefault(node, -1)

    def __getitem__(self, node: Term) -> NodeSpans:
        own = self._own.get(node)
        return self._groups[self._numbers[node]].nodes[node] if own is None else own

    def __iter__(self) -> Iterator[Term]:
        return iter(self._numbers)

    def __contains__(self, node: object) -> bool:
        return node in self._numbers

    def __len__(self) -> int:
        return len(self._numbers)


class LazyTripleSpans(Mapping[Triple, Span]):
    """Places of what *groups* state; each has that of the first."""

    def __init__(self, groups: Sequence[Group]) -> None:
        self._groups = groups
        self._numbers: dict[Triple, int] = {}
        size = 0
        for number, group in enumerate(groups):
            self._numbers.update(zip(group.triples, repeat(number)))
            size += len(group.triples)
        if size > len(self._numbers):
            for number in range(len(groups) - 1, -1, -1):
                self._numbers.update(zip(groups[number].triples, repeat(number)))
        self._own: dict[Triple, Span] = {}
        self._nodes: Mapping[Term, NodeSpans] = {}

    def add_layer(
        self,
        file: Iterable[Triple],
        described: Iterable[Term],
        layer: SourceLayer,
        nodes: Mapping[Term, NodeSpans],
    ) -> None:
        """Add the statements of *layer*: on the *file*, which nodes are *described*, the others."""
        self._own, self._nodes = layer.triples, nodes
        for triple in file:
            self._numbers.setdefault(triple, -1)
        for node in described:
            self._numbers.setdefault((node, DESCRIBED, layer.document), -1)
        for triple in layer.triples:
            self._numbers.setdefault(triple, -1)

    def __getitem__(self, triple: Triple) -> Span:
        number = self._numbers[triple]
        if number >= 0:
            return self._groups[number].spans[triple]
        return self._own[triple] if triple in self._own else self._nodes[triple[0]].best

    def __iter__(self) -> Iterator[Triple]:
        return iter(self._numbers)

    def __contains__(self, triple: object) -> bool:
        return triple in self._numbers

    def __len__(self) -> int:
        return len(self._numbers)
