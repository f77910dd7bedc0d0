"""Computes facts again where something changed that they are computed from."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from kinlint.engine.store import Store
from kinlint.facts.compute import Kind, asked, helpful
from kinlint.facts.workings import Workings
from kinlint.incremental.change import Changes, quads
from kinlint.incremental.kept_scan import KeptScan
from kinlint.terms import Term, Triple
from kinlint.vocabulary import FACTS_GRAPH


class Computation:
    """The facts of a model, kind by kind, and what they were computed from."""

    def __init__(self, store: Store, wanted: frozenset[Term] | None, hints: Iterable[Term]) -> None:
        self._scan = KeptScan(store)
        self._workings = Workings(self._scan)
        self._kinds: Sequence[Kind] = (*asked(wanted), *helpful(hints))
        self._found: dict[int, tuple[Triple, ...]] = {}
        self._facts: dict[Triple, None] = {}

    def compute(self, changes: Changes, named: Sequence[Triple], ask: Callable[[], None]) -> None:
        """Compute again what *changes* touch, and add to them; *named* is stated besides."""
        for name in self._scan.forget(changes):
            self._workings.__dict__.pop(name, None)
            for number, kind in enumerate(self._kinds):
                if name in kind.parts:
                    self._found.pop(number, None)
        for number, kind in enumerate(self._kinds):
            if number not in self._found:
                ask()
                self._found[number] = tuple(kind.found(self._workings))
        found = (each for number in range(len(self._kinds)) for each in self._found[number])
        before, self._facts = self._facts, dict.fromkeys((*found, *named))
        self._state(before, changes)

    def _state(self, before: dict[Triple, None], changes: Changes) -> None:
        """State the facts where those *before* were; two spellings of a number are one fact."""
        gone, come = before.keys() - self._facts.keys(), self._facts.keys() - before.keys()
        kept = set(quads(come, FACTS_GRAPH))
        removed = set(quads(gone, FACTS_GRAPH)) - kept
        if removed:
            pairs = {each[:2] for each in gone}
            still = (each for each in self._facts if each[:2] in pairs)
            removed.difference_update(quads(still, FACTS_GRAPH))
        changes.make(removed, kept)
