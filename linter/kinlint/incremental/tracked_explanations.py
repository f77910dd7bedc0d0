"""Remembers what results rest on, as long as nothing changes that was looked at to find out."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import pyoxigraph as ox

from kinlint.engine.axioms import Axiom
from kinlint.engine.compiler.query_dependencies import dependencies
from kinlint.engine.constraint import Constraint
from kinlint.engine.explanation import Step, because
from kinlint.engine.result import Result
from kinlint.engine.store import Function, Store
from kinlint.incremental.change import Changes
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import RDF_TYPE, Term, Triple
from kinlint.vocabulary import LIFTED_GRAPH


@dataclass
class Reads:
    """The nodes and queries that a store was asked about."""

    nodes: set[Term] = field(default_factory=set)
    """Nodes whose triples were read."""
    queries: set[str] = field(default_factory=set)
    """Queries that were answered."""

    def meet(self, changes: Changes, nodes: set[Term]) -> bool:
        """Tell whether *changes*, which are about *nodes*, may answer otherwise."""
        return not self.nodes.isdisjoint(nodes) or any(
            dependencies(each).looks_at(changes.properties, changes.classes)
            for each in self.queries
        )


class TrackedStore(Store):
    """A store that notes what it is asked, while somebody wants to know."""

    looks: Reads | None = None
    """Nodes and queries that were asked about, while that is noted."""
    kept: frozenset[Term] | None = None
    """Properties and classes that lifted statements are noted for; None for any."""

    def rows(
        self,
        text: str,
        substitutions: Mapping[str, Term] | None = None,
        functions: Mapping[ox.NamedNode, Function] | None = None,
    ) -> Iterator[dict[str, Term]]:
        """The solutions of a SELECT."""
        if self.looks is not None:
            self.looks.queries.add(text)
        return super().rows(text, substitutions, functions)

    def values(self, subject: Term, predicate: Term) -> Iterator[Term]:
        """The values of *predicate*."""
        self._note(subject)
        return super().values(subject, predicate)

    def _said(self, subject: Term, name: Term) -> list[tuple[Term, Term]]:
        self._note(subject)
        said, kept = super()._said(subject, name), self.kept
        if self.looks is None or kept is None or name != LIFTED_GRAPH:
            return said
        return [
            (predicate, value)
            for predicate, value in said
            if predicate in kept or (predicate == RDF_TYPE and value in kept)
        ]

    def _graph(self, triple: Triple) -> Term | None:
        self._note(triple[0])
        return super()._graph(triple)

    def _note(self, subject: Term) -> None:
        if self.looks is not None:
            self.looks.nodes.add(subject)


class Explanations:
    """The derivations of the results of a model."""

    def __init__(self, store: TrackedStore, axioms: Sequence[Axiom]) -> None:
        self._store = store
        self._axioms = axioms
        self._known: dict[int, tuple[Result, tuple[Step, ...], Reads]] = {}

    def keep_to(self, terms: frozenset[Term]) -> None:
        """Take only those lifted statements into account that have one of *terms*."""
        self._store.kept = terms

    def forget(self, changes: Changes, results: Sequence[Result]) -> None:
        """Forget what *changes* may have changed, and what is not among *results*."""
        if not self._known:
            return
        nodes = {str(quad.subject) for quad in (*changes.removed, *changes.added)}
        there = set(map(id, results))
        self._known = {
            key: known
            for key, known in self._known.items()
            if key in there and not known[2].meet(changes, nodes)
        }

    def because(self, constraint: Constraint, result: Result) -> tuple[Step, ...]:
        """Return what *result* rests on, as `kinlint.engine.explanation.because` does."""
        known = self._known.get(id(result))
        if known is None:
            looks = self._store.looks = Reads()
            try:
                steps = because(self._store, self._axioms, constraint, result)
            finally:
                self._store.looks = None
            known = self._known[id(result)] = (result, steps, looks)
        return known[1]
