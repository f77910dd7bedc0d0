"""The terms that the constraints of a run look at, and the axioms that can make those."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from kinlint.engine.axioms import Axiom
from kinlint.engine.constraint import Constraint
from kinlint.terms import RDF_TYPE, Term, Triple

ANY_CLASS: Term = "a"
"""Among terms: whatever class a node is said to be of, as far as it is there."""


def terms(constraints: Iterable[Constraint]) -> frozenset[Term] | None:
    """Return the properties and classes that *constraints* need; None if one needs any."""
    found: set[Term] = set()
    for each in constraints:
        if each.needs is None:
            return None
        found.update(each.needs)
    return frozenset(found)


def relevant(axioms: Sequence[Axiom], wanted: frozenset[Term]) -> tuple[Axiom, ...]:
    """Return those of *axioms* from which a statement with one of the *wanted* terms may follow."""
    needed = behind(axioms, wanted)
    return tuple(axiom for axiom in axioms if _head(axiom) in needed)


def behind(axioms: Sequence[Axiom], wanted: Iterable[Term]) -> frozenset[Term]:
    """Return the *wanted* terms, and those from which they follow by *axioms*."""
    bodies: dict[Term, set[Term]] = {}
    for axiom in axioms:
        body = bodies.setdefault(_head(axiom), set())
        body.update(term for pattern in axiom.body for term in _key(pattern))
    needed, waiting = set(wanted), list(wanted)
    while waiting:
        more = bodies.get(waiting.pop(), set()) - needed
        needed |= more
        waiting += more
    return frozenset(needed)


def made(axioms: Iterable[Axiom]) -> frozenset[Term]:
    """Return the properties and classes of what *axioms* conclude."""
    return frozenset(map(_head, axioms))


def _head(axiom: Axiom) -> Term:
    _, predicate, value = axiom.head
    return value if predicate == RDF_TYPE else predicate


def _key(pattern: Triple) -> tuple[Term, ...]:
    _, predicate, value = pattern
    return (value,) if predicate == RDF_TYPE else (predicate,)
