"""Elements of the outermost graph, stated without PyLD where that is possible."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any, Protocol

from kinlint.document import NodeSpans
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.json_text.json_outline import Unplaced
from kinlint.formats.jsonld.compiled.placed_walk import PlacedWalk
from kinlint.formats.jsonld.compiled.plain_walk import PlacesNeeded, PlainWalk
from kinlint.formats.jsonld.compiled.table_compiler import TableCompiler
from kinlint.formats.jsonld.compiled.term_table import Declined, Scope
from kinlint.formats.jsonld.expander import Processor
from kinlint.formats.jsonld.losses import LossObserver
from kinlint.terms import Term, Triple
from kinlint.text import Span


class Group(Protocol):
    """Statements that were made together."""

    @property
    def triples(self) -> Sequence[Triple] | Mapping[Triple, Span]:
        """The statements, in their order."""
        ...

    @property
    def described(self) -> Sequence[Term] | Mapping[Term, NodeSpans]:
        """The nodes that are described, in their order."""
        ...

    @property
    def spans(self) -> Mapping[Triple, Span]:
        """Places of the statements."""
        ...

    @property
    def nodes(self) -> Mapping[Term, NodeSpans]:
        """Places of the nodes."""
        ...


class PlacedGroup:
    """Statements whose places are known."""

    def __init__(self, spans: Mapping[Triple, Span], nodes: Mapping[Term, NodeSpans]) -> None:
        self.triples = self.spans = spans
        self.described = self.nodes = nodes


class CompiledGroup:
    """Statements of an element that is walked again, with places, when one is asked for."""

    __slots__ = ("_before", "_blanks", "_element", "_scope", "_walk", "described", "triples")

    def __init__(self, walk: PlainWalk, element: Unplaced, scope: Scope, before: int) -> None:
        self.triples = walk.triples
        self.described = walk.nodes
        self._element = element
        self._scope = scope
        self._blanks = walk.blanks
        self._before = before
        self._walk: PlacedWalk | None = None

    @property
    def _placed(self) -> PlacedWalk:
        if self._walk is None:
            walk = PlacedWalk(self._blanks.since(self._before), LossObserver())
            walk.element(self._element.placed()[0], self._scope)
            self._walk = walk
        return self._walk

    @property
    def spans(self) -> Mapping[Triple, Span]:
        """Places of the statements."""
        return self._placed.spans

    @property
    def nodes(self) -> Mapping[Term, NodeSpans]:
        """Places of the nodes."""
        return self._placed.nodes


class ElementCompiler:
    """States the elements of one graph, each by term tables of the contexts there.

    `declined` counts the elements that PyLD has to expand, by reason.
    """

    def __init__(self, processor: Processor) -> None:
        self.declined = Counter[str]()
        self._compiler = TableCompiler(processor)
        self._processor = processor
        self._scope: Scope | None = None

    def state(
        self, element: Unplaced, outer: Any, key: str, blanks: BlankNodes, watch: LossObserver
    ) -> Group | None:
        """Return what *element* states under *key* of the object with the context *outer*.

        *watch* is told what is to be told of it. Return None if PyLD has to expand it. Its plain
        value is dropped.
        """
        before = blanks.count
        try:
            return _stated(element, self._entered(outer, key), blanks, watch)
        except Declined as reason:
            self.declined[str(reason)] += 1
            blanks.rewind(before)
            return None
        finally:
            element.value = {}

    def _entered(self, outer: Any, key: str) -> Scope:
        if self._processor.record.shadows:
            raise Declined("a term that shadows another")
        if self._scope is None:
            self._scope = self._compiler.scope(outer, key)
        return self._scope


def _stated(element: Unplaced, scope: Scope, blanks: BlankNodes, watch: LossObserver) -> Group:
    before = blanks.count
    walk = PlainWalk(blanks)
    try:
        walk.element(element.value, scope)
        return CompiledGroup(walk, element, scope, before)
    except PlacesNeeded:
        blanks.rewind(before)
    observed = LossObserver()
    placed = PlacedWalk(blanks, observed)
    placed.element(element.placed()[0], scope)
    watch.losses += observed.losses
    for outermost, inner in observed.within.items():
        watch.within.setdefault(outermost, []).extend(inner)
    return PlacedGroup(placed.spans, placed.nodes)
