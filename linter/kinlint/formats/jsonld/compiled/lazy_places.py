"""Places of statements and nodes that are found when they are asked for."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import chain, repeat

from kinlint.document import NodeSpans
from kinlint.formats.jsonld.compiled.element_compiler import Group
from kinlint.formats.source_layer import DESCRIBED, SourceLayer
from kinlint.terms import RDF_TYPE, Term, Triple, is_iri
from kinlint.text import Span

ASIDE = -1
"""Stands for the number of a group where the source layer states a thing."""


class LazyNodeSpans(Mapping[Term, NodeSpans]):
    """Places of the nodes that *groups* describe; each has that of its first description."""

    def __init__(self, groups: Sequence[Group]) -> None:
        self._groups = groups
        self._numbers = dict.fromkeys(
            chain.from_iterable(group.described for group in groups), ASIDE
        )
        self._unnumbered = True
        self._own: Mapping[Term, NodeSpans] = {}

    def add_layer(self, layer: SourceLayer) -> None:
        """Add the nodes of *layer*, whose places go before."""
        self._own = layer.nodes
        for node in layer.nodes:
            self._numbers.setdefault(node, ASIDE)

    def __getitem__(self, node: Term) -> NodeSpans:
        own = self._own.get(node)
        if own is not None:
            return own
        if self._unnumbered:
            for number in range(len(self._groups) - 1, -1, -1):
                self._numbers.update(zip(self._groups[number].described, repeat(number)))
            self._unnumbered = False
        return self._groups[self._numbers[node]].nodes[node]

    def __iter__(self) -> Iterator[Term]:
        return iter(self._numbers)

    def __contains__(self, node: object) -> bool:
        return node in self._numbers

    def __len__(self) -> int:
        return len(self._numbers)


class LazyTripleSpans(Mapping[Triple, Span]):
    """Places of what *groups* and *layer* state; each has that of the first.

    *described* says which nodes are described, whose places *nodes* has.
    """

    def __init__(
        self,
        stated: Sequence[Triple],
        groups: Sequence[Group],
        layer: SourceLayer,
        nodes: Mapping[Term, NodeSpans],
    ) -> None:
        self._stated = stated
        self._groups = groups
        self._layer = layer
        self._nodes = nodes

    @cached_property
    def _numbers(self) -> dict[Triple, int]:
        numbers = dict.fromkeys(self._stated, ASIDE)
        for number in range(len(self._groups) - 1, -1, -1):
            numbers.update(zip(self._groups[number].triples, repeat(number)))
        return numbers

    def __getitem__(self, triple: Triple) -> Span:
        number = self._numbers[triple]
        if number != ASIDE:
            return self._groups[number].spans[triple]
        own = self._layer.triples.get(triple)
        if own is not None:
            return own
        return self._nodes[triple[0]].best

    def __iter__(self) -> Iterator[Triple]:
        return iter(self._stated)

    def __contains__(self, triple: object) -> bool:
        return triple in self._numbers

    def __len__(self) -> int:
        return len(self._stated)


def first_uses(groups: Sequence[Group]) -> dict[Term, tuple[int, Triple]]:
    """Return the properties and classes, with the first statement of each and its group."""
    found: dict[Term, tuple[int, Triple]] = {}
    for number, group in enumerate(groups):
        for triple in group.triples:
            _, prop, value = triple
            term = value if prop == RDF_TYPE else prop
            if term not in found:
                found[term] = number, triple
    return {term: use for term, use in found.items() if is_iri(term)}


def statements(
    groups: Sequence[Group], file: Iterable[Triple], described: Iterable[Term], layer: SourceLayer
) -> tuple[Triple, ...]:
    """Return what *groups* and *layer* state: on the *file*, what is *described*, all the rest."""
    ours = ((node, DESCRIBED, layer.document) for node in described)
    theirs = chain.from_iterable(group.triples for group in groups)
    return tuple(dict.fromkeys(chain(theirs, file, ours, layer.triples)))
