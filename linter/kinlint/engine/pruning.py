"""Tells which constraints nothing can violate, because what they match is not there."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from typing import Protocol

from kinlint.engine.compiler.shacl_terms import SUBCLASS
from kinlint.engine.constraint import PLAIN, Constraint
from kinlint.terms import RDF_TYPE, Term, Triple, is_iri
from kinlint.vocabulary import FACT

COMPUTED = f"<{FACT}"


class Lookup(Protocol):
    """A store that finds triples by predicate and object, such as `kinlint.engine.store.Store`."""

    def subjects(self, predicate: Term, value: Term | None = None) -> Iterator[Term]:
        """Yield the subjects of *predicate*, with *value* if one is given."""
        ...


class Presence:
    """The predicates and objects that a store has, each pair looked up once.

    It may yet come to hold what has properties, or is of classes, among those that are *coming*,
    and anything computed.
    """

    def __init__(self, store: Lookup, coming: Collection[Term] = ()) -> None:
        self.store = store
        self.coming = coming
        self._known: dict[tuple[Term, Term | None], bool] = {}
        self._below: dict[Term, tuple[Term, ...]] = {}

    def forget(self, changed: Iterable[tuple[Term, Term]]) -> None:
        """Ask again for what has one of the pairs *changed* of predicate and object."""
        for predicate, value in changed:
            self._known.pop((predicate, value), None)
            self._known.pop((predicate, None), None)
            if predicate == SUBCLASS:
                self._below.clear()

    def may_violate(self, constraint: Constraint) -> bool:
        """Tell whether anything may be a target of *constraint*, and each premise match something.

        Each is looked up by itself, whatever the others match.
        """
        chosen = not constraint.targets or any(map(self._chosen, constraint.targets))
        return chosen and all(map(self._matched, constraint.premises))

    def _chosen(self, way: Triple) -> bool:
        _, predicate, value = way
        if predicate == RDF_TYPE and is_iri(value):
            return any(self.matches(RDF_TYPE, kind) for kind in self._narrower(value))
        return self.matches(predicate, None)

    def _matched(self, premise: Triple) -> bool:
        _, predicate, value = premise
        if predicate == f"{SUBCLASS}*" and is_iri(value):
            return any(self.matches(RDF_TYPE, kind) for kind in self._narrower(value))
        steps = predicate.split("|")
        if not all(map(PLAIN.fullmatch, steps)):
            return True
        return any(self.matches(step, value if is_iri(value) else None) for step in steps)

    def _narrower(self, kind: Term) -> tuple[Term, ...]:
        """Return *kind* and all its subclasses."""
        if kind not in self._below:
            self._below[kind] = tuple(self._subclasses(kind))
        return self._below[kind]

    def _subclasses(self, kind: Term) -> Iterator[Term]:
        seen, waiting = {kind}, [kind]
        while waiting:
            yield (each := waiting.pop())
            found = set(self.store.subjects(SUBCLASS, each)) - seen
            seen |= found
            waiting += found

    def matches(self, predicate: Term, value: Term | None) -> bool:
        """Tell whether anything has *predicate*, with *value* if one is given."""
        if predicate.startswith("?"):
            return True
        key = predicate, value
        if key not in self._known:
            self._known[key] = self._may_come(*key) or self._is_there(*key)
        return self._known[key]

    def _is_there(self, predicate: Term, value: Term | None) -> bool:
        return next(self.store.subjects(predicate, value), None) is not None

    def _may_come(self, predicate: Term, value: Term | None) -> bool:
        term = value if predicate == RDF_TYPE and value else predicate
        return bool(self.coming) and (term in self.coming or term.startswith(COMPUTED))
