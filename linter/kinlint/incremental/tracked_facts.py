"""Computes facts, and again where something changed that they are computed from."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from kinlint.engine.store import Store
from kinlint.facts.computation import asked, helpful
from kinlint.facts.fact_context import FactContext
from kinlint.facts.fact_kind import FactKind
from kinlint.facts.fact_kinds import KINDS
from kinlint.facts.fact_statements import fact
from kinlint.incremental.change import Changes, to_quads
from kinlint.incremental.tracked_index import TrackedIndex
from kinlint.phases import part
from kinlint.terms import Term, Triple
from kinlint.vocabulary import FACTS_GRAPH


class TrackedFacts:
    """Statements of all other stages to computed ones, kind by kind."""

    def __init__(
        self,
        store: Store,
        wanted: frozenset[Term] | None,
        hints: Iterable[Term],
        named: frozenset[Term] | None = None,
    ) -> None:
        self._store = store
        self._index = TrackedIndex(store)
        self.context = FactContext(self._index)
        """The parts that facts are computed by, whether rules ask for those facts or not."""
        self._asked = tuple(asked(wanted, named))
        self._kinds: Sequence[FactKind] = (*self._asked, *helpful(hints))
        self._stale = set(range(len(self._kinds)))
        self._found: dict[int, tuple[Triple, ...]] = {}
        self._named: dict[Triple, None] | None = None
        self._facts: dict[Triple, None] | None = None
        self._unasked: dict[str, dict[Term, list[Term]]] = {}

    def run(
        self,
        changes: Changes,
        named: Iterable[Triple],
        ask: Callable[[], None],
        *,
        hinting: bool = True,
    ) -> None:
        """Compute what *changes* touch, at first everything; *named* is stated before that.

        Unless *hinting*, hints that were computed before stay as they are until a later turn.
        """
        self._unasked.clear()
        self._named = self._stated(self._named, named, changes)
        self._forget(changes)
        for number, kind in enumerate(self._kinds if hinting else self._asked):
            if number in self._stale:
                ask()
                with part("facts", kind.label):
                    self._found[number] = tuple(kind.found(self.context))
                self._stale.discard(number)
        found = (each for _, found in sorted(self._found.items()) for each in found)
        self._facts = self._stated(self._facts, found, changes)

    def values(self, node: Term, name: str) -> Sequence[Term]:
        """Return the facts called *name* of *node*, whether rules ask for such or not; sorted."""
        if name not in self._unasked:
            found = self._unasked.setdefault(name, {})
            asked = {id(each.found) for each in self._asked}
            others = (kind for kind in KINDS if name in (*kind.needs, *kind.details))
            others = (kind for kind in others if id(kind.found) not in asked)
            for kind in others:
                for subject, predicate, value in kind.found(self.context):
                    if predicate == fact(name):
                        found.setdefault(subject, []).append(value)
        stated = self._store.values(node, fact(name))
        return sorted({*stated, *self._unasked[name].get(node, ())})

    def _forget(self, changes: Changes) -> None:
        """Forget what was computed from something that *changes* are about."""
        for name in self._index.forget(changes):
            self.context.__dict__.pop(name, None)
            for number, kind in enumerate(self._kinds):
                if name in kind.parts:
                    self._stale.add(number)

    def _stated(
        self, before: dict[Triple, None] | None, found: Iterable[Triple], changes: Changes
    ) -> dict[Triple, None]:
        """State *found* in place of *before* and return it; two spellings of a number are one."""
        after = dict.fromkeys(found)
        if before is None:
            self._store.state({**(self._named or {}), **after})
            return after
        gone, come = before.keys() - after.keys(), after.keys() - before.keys()
        kept = set(to_quads(come, FACTS_GRAPH))
        removed = set(to_quads(gone, FACTS_GRAPH)) - kept
        if removed:
            pairs = {each[:2] for each in gone}
            still = (each for each in after if each[:2] in pairs)
            removed.difference_update(to_quads(still, FACTS_GRAPH))
        changes.apply(removed, kept)
        return after
