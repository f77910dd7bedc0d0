"""The outermost graph of a file, element by element: compiled, or expanded by PyLD."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any, Protocol

from kinlint.document import NodeSpans
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.json_text.json_outline import Unplaced
from kinlint.formats.json_text.json_values import Object
from kinlint.formats.jsonld.compiled.placed_walk import PlacedWalk
from kinlint.formats.jsonld.compiled.plain_walk import PlacesNeeded, PlainWalk
from kinlint.formats.jsonld.compiled.table_compiler import TableCompiler
from kinlint.formats.jsonld.compiled.term_table import Declined, Scope
from kinlint.formats.jsonld.expander import Processor
from kinlint.formats.jsonld.losses import LossObserver
from kinlint.formats.jsonld.triples import Triples
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


class CompiledGraph:
    """States the elements of the outermost graph in turn.

    `groups` are the statements so far. `declined` counts the elements that PyLD expands, by reason.
    """

    def __init__(
        self,
        processor: Processor,
        blanks: BlankNodes,
        triples: Triples,
        watch: LossObserver,
        repeats: list[Object],
    ) -> None:
        self.groups: list[Group] = []
        self.declined = Counter[str]()
        self._compiler = TableCompiler(processor)
        self._record = processor.record
        self._blanks = blanks
        self._triples = triples
        self._watch = watch
        self._repeats = repeats
        self._scope: Scope | None = None

    def take(self, element: Unplaced, outer: Any, key: str) -> Object | None:
        """State *element* under *key* of the object with the context *outer*.

        Return it with its places if PyLD has to expand it, and None otherwise.
        """
        before = self._blanks.count
        try:
            if self._scope is None:
                self._scope = self._compiler.scope(outer, key)
            self._state(element, self._scope, before)
        except Declined as reason:
            self.declined[str(reason)] += 1
            self._blanks.rewind(before)
            placed, repeats = element.placed()
            self._repeats += repeats
            return placed
        finally:
            element.value = {}
        return None

    def _state(self, element: Unplaced, scope: Scope, before: int) -> None:
        if self._record.shadows:
            raise Declined("a term that shadows another")
        if self._triples.spans or self._triples.nodes:
            self.finish()
        walk = PlainWalk(self._blanks)
        try:
            walk.element(element.value, scope)
            self.groups.append(CompiledGroup(walk, element, scope, before))
        except PlacesNeeded:
            self._blanks.rewind(before)
            self._state_placed(element, scope)

    def _state_placed(self, element: Unplaced, scope: Scope) -> None:
        watch = LossObserver()
        walk = PlacedWalk(self._blanks, watch)
        walk.element(element.placed()[0], scope)
        self._watch.losses += watch.losses
        for outermost, inner in watch.within.items():
            self._watch.within.setdefault(outermost, []).extend(inner)
        self.groups.append(PlacedGroup(walk.spans, walk.nodes))

    def finish(self) -> None:
        """Add what was expanded by PyLD since the last element."""
        triples = self._triples
        self.groups.append(PlacedGroup(triples.spans, triples.nodes))
        triples.spans, triples.nodes = {}, {}
