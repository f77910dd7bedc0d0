"""Checks constraints, and again those that look at what changed, where it concerns them."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from kinlint.engine.constraint import FOCUS, Constraint
from kinlint.engine.evaluate import result, rows
from kinlint.engine.pruning import Presence
from kinlint.engine.result import Result
from kinlint.engine.store import Store, rank, token
from kinlint.incremental.change import Changes
from kinlint.phases import part
from kinlint.terms import RDF_TYPE, Term, is_blank, is_iri

if TYPE_CHECKING:
    from kinlint.engine.compiler.query_dependencies import Dependencies
    from kinlint.incremental.affected_nodes import AffectedNodes

Row = Mapping[str, Term]
GIVEN = f"VALUES ?this {{ {FOCUS} }}"
"""The clause by which the query about one target node is given it."""
LITTLE, FIRST = 3e-4, 1e-3
"""Seconds: a query that takes less is asked about all nodes again, as the nodes that a change
concerns are not found sooner; more at first, when the paths to them are still to be found."""


class TrackedChecking:
    """Statements of all stages to violations of constraints."""

    def __init__(self, store: Store, constraints: Sequence[Constraint]) -> None:
        self.store = store
        self.constraints = constraints
        self._presence = Presence(store)
        self._rows: dict[int, list[Row]] = {}
        self._results: dict[int, list[Result]] = {}
        self._seconds: dict[int, float] = {}
        self._little = FIRST

    @cached_property
    def deferred(self) -> bool:
        """Tell whether only the reference engine may judge some of the constraints."""
        return any(each.deferred is not None for each in self.constraints)

    @cached_property
    def _dependencies(self) -> Sequence[Dependencies]:
        from kinlint.engine.compiler.query_dependencies import Dependencies  # noqa: PLC0415  most runs run once

        return [Dependencies.from_constraint(each) for each in self.constraints]

    def widen(self, constraints: Sequence[Constraint]) -> None:
        """Check *constraints* from now on: those so far, in the same order, and perhaps more."""
        if constraints is self.constraints:
            return
        places = {id(each): number for number, each in enumerate(constraints)}
        now = [places[id(each)] for each in self.constraints]
        self._rows = {now[number]: each for number, each in self._rows.items()}
        self._results = {now[number]: each for number, each in self._results.items()}
        self._seconds = {now[number]: each for number, each in self._seconds.items()}
        self.constraints = constraints
        for name in ("deferred", "_dependencies"):
            self.__dict__.pop(name, None)

    def run(self, changes: Changes, ask: Callable[[], None]) -> None:
        """Check what looks at what *changes* are about; at first, everything."""
        if not self._rows:
            for number, constraint in enumerate(self.constraints):
                if constraint.deferred is None:
                    ask()
                    possible = self._presence.may_violate(constraint)
                    self._note(number, self._all(number) if possible else [])
            return
        from kinlint.incremental.affected_nodes import AffectedNodes  # noqa: PLC0415  most runs run once

        presence, affected = self._presence, AffectedNodes(changes)
        changed = {(quad.predicate, quad.object) for quad in (*changes.removed, *changes.added)}
        presence.forget((token(predicate), token(value)) for predicate, value in changed)
        for number, constraint in enumerate(self.constraints):
            looks = self._dependencies[number].looks_at(changes.properties, changes.classes)
            if number in self._rows and not looks:
                continue
            ask()
            if not presence.may_violate(constraint):
                self._note(number, [])
                continue
            nodes = self._concerned(number, affected)
            if nodes is None or nodes:
                known = None if nodes is None else self._checked(number, nodes)
                self._note(number, self._all(number) if known is None else known)
        self._little = LITTLE

    def _all(self, number: int) -> list[Row]:
        """Return all violations of a constraint; note how long that took."""
        started, constraint = time.perf_counter(), self.constraints[number]
        with part("rules", constraint.owner):
            found = list[Row](rows(self.store, constraint))
        self._seconds[number] = time.perf_counter() - started
        return found

    def _note(self, number: int, found: list[Row]) -> None:
        if number not in self._rows or self._rows[number] != found:
            constraint = self.constraints[number]
            self._results[number] = [result(constraint, row) for row in found]
        self._rows[number] = found

    def _concerned(self, number: int, affected: AffectedNodes) -> frozenset[Term] | None:
        """Return the target nodes that may violate it anew or no more; None for all."""
        if number not in self._rows or self._seconds.get(number, 0.0) < self._little:
            return None
        from kinlint.incremental.affected_nodes import TooMany  # noqa: PLC0415  most runs run once
        from kinlint.incremental.dependency_paths import pattern_paths  # noqa: PLC0415

        paths = pattern_paths(self.constraints[number].select)
        if paths is None:
            return None
        try:
            nodes = affected.nodes(paths)
        except TooMany:
            return None
        targets = self.constraints[number].targets
        known = {row["root"] for row in self._rows[number]}
        return frozenset(
            str(node)
            for node in nodes
            if not targets or str(node) in known or affected.is_target(node, targets)
        )

    def _checked(self, number: int, nodes: frozenset[Term]) -> list[Row] | None:
        """Return the violations, those of *nodes* anew; None if one cannot be asked for."""
        ways = [
            f"VALUES ?this {{ {' '.join(sorted(each for each in nodes if not is_blank(each)))} }}"
        ]
        for node in filter(is_blank, nodes):
            said = [pair for pair in self.store.predicate_objects(node) if not is_blank(pair[1])]
            if not said:
                return None
            # No query can name a blank node; what else the same is said of is left out below.
            predicate, value = min(said, key=_commonness)
            ways.append(f"?this {predicate} {value}")
        given = ways[0]
        if len(ways) > 1:
            either = " UNION ".join(f"{{ {way} }}" for way in ways)
            given = f"SELECT DISTINCT ?this WHERE {{ {either} }}"
        text = self.constraints[number].single.replace(GIVEN, given)
        try:
            found = [row for row in self.store.rows(text) if row["root"] in nodes]
        except SyntaxError:  # A file may use IRIs that a store takes, but no query.
            return None
        kept = (row for row in self._rows[number] if row["root"] not in nodes)
        return sorted((*kept, *found), key=rank, reverse=True)

    @property
    def results(self) -> Iterator[Result]:
        """The violations, in the order of the constraints."""
        for _, found in sorted(self._results.items()):
            yield from found


def _commonness(pair: tuple[Term, Term]) -> tuple[bool, bool, int]:
    """Sorts what is said of a node by how many others it is probably said of, too."""
    predicate, value = pair
    return predicate == RDF_TYPE, is_iri(value), -len(value)
