"""Finds out, when asked, why an inferred triple holds and what a result rests on."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kinlint.engine.axioms import Axiom, Pattern, instantiate, is_variable, match
from kinlint.engine.constraint import Constraint
from kinlint.engine.result import Result
from kinlint.engine.spelling import normal
from kinlint.engine.store import Store
from kinlint.terms import Term, Triple

DEEPEST = 24
"""Proofs of more levels are cut: nobody reads them."""


class Step(NamedTuple):
    """A triple of a proof, in the store's spelling, followed by its premises one level deeper.

    `axiom` says by which axiom it follows; it is empty for what is stated.
    """

    triple: Triple
    axiom: str = ""
    depth: int = 0


def explain(store: Store, axioms: Sequence[Axiom], triple: Triple) -> tuple[Step, ...]:
    """A proof of *triple* with the fewest levels, down to what documents or vocabulary state.

    Empty if the triple does not hold. A triple whose proof is deeper than `DEEPEST` stands alone.
    """
    goal = (triple[0], triple[1], normal(triple[2]))
    if not store.holds(goal):
        return ()
    search = _Search(store, axioms)
    for levels in range(DEEPEST + 1):
        if proof := search.proof(goal, levels):
            return proof
    return (Step(goal),)


def premises_of(
    store: Store, constraint: Constraint, result: Result
) -> tuple[tuple[Triple, bool], ...]:
    """The triples that *constraint* matched for *result*, each with whether it was inferred.

    If they do not hold together (an author may bind a variable to something computed), those
    that hold by themselves.
    """
    known = {f"?{name}": term for name, term in result.bindings.items()}
    known["?this"] = result.focus
    patterns = constraint.premises
    bindings = next(_solutions(store, patterns, known), None)
    found = [instantiate(pattern, known if bindings is None else bindings) for pattern in patterns]
    held = filter(store.holds, dict.fromkeys(found))
    return tuple((triple, store.is_inferred(triple)) for triple in held)


def because(
    store: Store, axioms: Sequence[Axiom], constraint: Constraint, result: Result
) -> tuple[Step, ...]:
    """What *result* rests on: each triple matched at depth 0, inferred ones with their proof."""
    return tuple(
        step
        for triple, inferred in premises_of(store, constraint, result)
        for step in (explain(store, axioms, triple) if inferred else (Step(triple),))
    )


class _Search:
    """A search for shallow proofs; limiting their depth keeps them free of cycles."""

    def __init__(self, store: Store, axioms: Sequence[Axiom]) -> None:
        self.store = store
        self.axioms = axioms
        self.failed: dict[Triple, int] = {}

    def proof(self, goal: Triple, levels: int) -> tuple[Step, ...]:
        """A proof of at most *levels* inferences; empty if there is none."""
        if not self.store.is_inferred(goal):
            return (Step(goal),)
        if levels <= self.failed.get(goal, 0):
            return ()
        for axiom in self.axioms:
            if (known := match(axiom.head, goal)) is None:
                continue
            for bindings in _solutions(self.store, axiom.body, known):
                premises = [instantiate(pattern, bindings) for pattern in axiom.body]
                if (proof := self._all(premises, levels - 1)) is not None:
                    return (Step(goal, axiom.label), *proof)
        self.failed[goal] = levels
        return ()

    def _all(self, goals: Sequence[Triple], levels: int) -> tuple[Step, ...] | None:
        steps: list[Step] = []
        for goal in goals:
            if not (proof := self.proof(goal, levels)):
                return None
            steps += (step._replace(depth=step.depth + 1) for step in proof)
        return tuple(steps)


def _solutions(
    store: Store, patterns: Sequence[Pattern], known: dict[Term, Term]
) -> Iterator[dict[Term, Term]]:
    """The ways to match all *patterns* that agree with *known*, which is part of each."""
    used = {term for pattern in patterns for term in pattern if is_variable(term)}
    text = f"SELECT * WHERE {{ {' '.join(' '.join(pattern) + ' .' for pattern in patterns)} }}"
    # Substituted, not written into the text: that could name neither blank nodes nor odd IRIs.
    given = {term[1:]: known[term] for term in used if term in known}
    for row in store.rows(text, given):
        yield known | {f"?{name}": term for name, term in row.items()}
