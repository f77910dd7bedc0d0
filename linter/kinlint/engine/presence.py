"""Tells which constraints nothing can violate, because what they match is not there."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Protocol

from kinlint.engine.compiler.names import SUBCLASS
from kinlint.engine.constraint import PLAIN, Constraint
from kinlint.terms import RDF_TYPE, Term, Triple, is_iri


class Lookup(Protocol):
    """What finds triples by predicate and object, such as `kinlint.engine.store.Store`."""

    def subjects(self, predicate: Term, value: Term | None = None) -> Iterator[Term]:
        """What has *predicate*, with *value* if one is given."""
        ...


class Presence:
    """What a store holds, asked once for each pair of predicate and object."""

    def __init__(self, store: Lookup) -> None:
        self.store = store
        self._known: dict[tuple[Term, Term | None], bool] = {}

    def may_violate(self, constraint: Constraint) -> bool:
        """Whether something may be a target of *constraint*, and each premise matches something.

        Each is looked up by itself, whatever the others match.
        """
        chosen = not constraint.targets or any(map(self._chosen, constraint.targets))
        return chosen and all(map(self._matched, constraint.premises))

    def _chosen(self, way: Triple) -> bool:
        _, predicate, value = way
        if predicate == RDF_TYPE and is_iri(value):
            return any(self._has(RDF_TYPE, kind) for kind in self._narrower(value))
        return self._has(predicate, None)

    def _matched(self, premise: Triple) -> bool:
        _, predicate, value = premise
        if predicate == f"{SUBCLASS}*" and is_iri(value):
            return any(self._has(RDF_TYPE, kind) for kind in self._narrower(value))
        if not PLAIN.fullmatch(predicate):
            return True
        return self._has(predicate, value if is_iri(value) else None)

    def _narrower(self, kind: Term) -> Iterator[Term]:
        """*kind* and all its subclasses."""
        seen, waiting = {kind}, [kind]
        while waiting:
            yield (each := waiting.pop())
            found = set(self.store.subjects(SUBCLASS, each)) - seen
            seen |= found
            waiting += found

    def _has(self, predicate: Term, value: Term | None) -> bool:
        key = predicate, value
        if key not in self._known:
            self._known[key] = next(self.store.subjects(*key), None) is not None
        return self._known[key]
