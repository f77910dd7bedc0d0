"""Finds out, when asked, why an inferred triple holds and what a result rests on."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from kinlint.engine.axioms import Axiom, Pattern, instantiate, is_variable, match
from kinlint.engine.computed_from import (
    COMPUTED,
    COMPUTED_ALONE,
    COMPUTED_TOO,
    CONTRADICTED,
    TYPE_FACTS,
    is_fact,
    sources,
    statements,
)
from kinlint.engine.constraint import PLAIN, Constraint
from kinlint.engine.literal_spelling import normal
from kinlint.engine.result import Result
from kinlint.engine.store import Store, rank
from kinlint.terms import RDF_TYPE, Term, Triple

DEEPEST = 24
"""Proofs of more levels are cut: nobody reads them."""

CHOSEN = frozenset({"?k_c", "?k_t"})
"""The variables in the patterns of a constraint's target."""


class Step(NamedTuple):
    """A triple of a proof, in the store's spelling, followed by its premises one level deeper."""

    triple: Triple
    """The triple that holds."""
    axiom: str = ""
    """The axiom by which it follows, or that it was computed; empty for what is stated."""
    depth: int = 0
    """0 for the triple that is proved, one more for each inference in between."""


def explain(store: Store, axioms: Sequence[Axiom], triple: Triple) -> tuple[Step, ...]:
    """Return a proof of *triple* with the fewest levels, down to statements of documents.

    Statements of the vocabulary end it as well. Empty if the triple does not hold. A triple whose
    proof is deeper than `DEEPEST` is returned alone.
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
    """Return the triples that *constraint* matched for *result*, each with whether it was inferred.

    The first is the one by which the target was chosen. If they do not hold together (an author may
    bind a variable to something computed), those that hold by themselves.
    """
    known = {f"?{name}": term for name, term in result.bindings.items()}
    known["?this"] = result.focus
    matched = tuple(each for each in constraint.premises if CHOSEN.isdisjoint(each))
    # A target that the constraint asks for itself adds nothing to what it rests on.
    ways = sorted(constraint.targets, key=lambda way: way[1] not in {each[1] for each in matched})
    for patterns in (*((way, *matched) for way in ways), constraint.premises):
        bindings = next(_solutions(store, patterns, known), None)
        if bindings is not None:
            break
    found = [instantiate(pattern, known if bindings is None else bindings) for pattern in patterns]
    found = [each for triple in found for each in _ways(triple)]
    held = filter(store.holds, dict.fromkeys(found))
    return tuple((triple, store.is_inferred(triple)) for triple in held)


def _ways(triple: Pattern) -> tuple[Pattern, ...]:
    """Return *triple*, or the triples one of which holds where its path has alternatives."""
    subject, path, value = triple
    return tuple((subject, each, value) for each in path.split("|") if PLAIN.fullmatch(each))


def because(
    store: Store, axioms: Sequence[Axiom], constraint: Constraint, result: Result
) -> tuple[Step, ...]:
    """Return the triples that *result* rests on, at depth 0, inferred ones with their proof.

    Computed ones are followed by what they were computed from, the first time it is the same; what
    was computed of a class stands for being of that class.
    """
    steps: list[Step] = []
    for matched, _ in premises_of(store, constraint, result):
        triple = (matched[0], RDF_TYPE, matched[2]) if matched[1] in TYPE_FACTS else matched
        if triple[1] == CONTRADICTED:
            continue
        if is_fact(triple):
            found = (Step(each, depth=1) for each in statements(store, sources(store, triple)))
            origin = [step for step in found if step not in steps]
            shown = any(step.axiom == COMPUTED for step in steps)
            axiom = COMPUTED if origin else COMPUTED_TOO if shown else COMPUTED_ALONE
            steps += (Step(triple, axiom), *origin)
            continue
        proof = explain(store, axioms, triple) if store.is_inferred(triple) else (Step(triple),)
        if _is_class_tree(proof) and triple[2] not in result.bindings.values():
            continue
        if proof and proof[0] not in steps:
            steps += proof
    return tuple(steps)


def _is_class_tree(proof: Sequence[Step]) -> bool:
    """Tell whether *proof* only leads from the stated class of a node to a wider one."""
    stated = {step.triple[:2] for step in proof}
    return len(proof) > 1 and stated == {(proof[0].triple[0], RDF_TYPE)}


class _Search:
    """A search for shallow proofs; limiting their depth keeps them free of cycles."""

    def __init__(self, store: Store, axioms: Sequence[Axiom]) -> None:
        self.store = store
        self.axioms = axioms
        self.failed: dict[Triple, int] = {}

    def proof(self, goal: Triple, levels: int) -> tuple[Step, ...]:
        """Return a proof of at most *levels* inferences; empty if there is none."""
        if not self.store.is_inferred(goal):
            return (Step(goal),)
        if levels <= self.failed.get(goal, 0):
            return ()
        for axiom in self.axioms:
            _, predicate, value = axiom.head
            if value != goal[2] and predicate == RDF_TYPE and not is_variable(value):
                continue  # Most axioms end here, before anything is bound.
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
    """Yield the sorted matches of all *patterns*, each with *known* as a part."""
    used = {term for pattern in patterns for term in pattern if is_variable(term)}
    text = f"SELECT * WHERE {{ {' '.join(' '.join(pattern) + ' .' for pattern in patterns)} }}"
    # Substituted, not written into the text: that could name neither blank nodes nor odd IRIs.
    given = {term[1:]: known[term] for term in used if term in known}
    for row in sorted(store.rows(text, given), key=rank):
        yield known | {f"?{name}": term for name, term in row.items()}
