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
    return tuple(axiom for axiom in axioms if term_of(axiom.head) in needed)


def behind(axioms: Sequence[Axiom], wanted: Iterable[Term]) -> frozenset[Term]:
    """Return the *wanted* terms, and those from which they follow by *axioms*."""
    bodies: dict[Term, set[Term]] = {}
    for axiom in axioms:
        bodies.setdefault(term_of(axiom.head), set()).update(map(term_of, axiom.body))
    needed, waiting = set(wanted), list(wanted)
    while waiting:
        more = bodies.get(waiting.pop(), set()) - needed
        needed |= more
        waiting += more
    return frozenset(needed)


def made(axioms: Iterable[Axiom]) -> frozenset[Term]:
    """Return the properties and classes of what *axioms* conclude."""
    return frozenset(term_of(axiom.head) for axiom in axioms)


def term_of(pattern: Triple) -> Term:
    """Return the property of *pattern*, or the class where it says that something is of one."""
    _, predicate, value = pattern
    return value if predicate == RDF_TYPE else predicate
