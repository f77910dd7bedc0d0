"""Computation of all facts of a model."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinlint.engine.store import Store
from kinlint.facts.fact_context import FactContext
from kinlint.facts.fact_kind import FactKind
from kinlint.facts.fact_kinds import HINTS, KINDS
from kinlint.facts.fact_statements import fact
from kinlint.facts.inputs import CONCLUDED
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.terms import Term, Triple


def facts(store: Store, wanted: frozenset[Term] | None = None) -> Iterator[Triple]:
    """Yield the facts that follow from what *store* holds, which is closed under its axioms.

    Only of kinds with a property among the *wanted*; None is all. Takes time linear in the model. A
    value that is no number, or ambiguous, gives no fact and never an error.
    """
    if not store.documents:
        return
    context = FactContext(PredicateIndex(store))
    for kind in asked(wanted):
        yield from kind.found(context)


def asked(
    wanted: frozenset[Term] | None, named: frozenset[Term] | None = None
) -> Iterator[FactKind]:
    """Yield the kinds of facts with a property among the *wanted*; None is all.

    Of those that are asked for by name, only what is *named*, unless that is None.
    """
    for kind in KINDS:
        terms = named if wanted is None and kind.by_name else wanted
        if terms is None or any(fact(name) in terms for name in kind.needs):
            yield kind


def hints(store: Store, wanted: Iterable[Term]) -> Iterator[Triple]:
    """Yield the *wanted* facts about *store* that only repairs ask for."""
    context = FactContext(PredicateIndex(store))
    for kind in helpful(wanted):
        yield from kind.found(context)


def helpful(wanted: Iterable[Term]) -> Iterator[FactKind]:
    """Return the kinds of hints with a property among the *wanted*."""
    terms = frozenset(wanted)
    return (kind for kind in HINTS if any(fact(name) in terms for name in kind.needs))


def computed_by(name: str, *, for_repairs: bool = False) -> str | None:
    """Return the module that computes the facts called *name*; None if none does.

    Some are there *for_repairs* only.
    """
    kinds = (*KINDS, *HINTS) if for_repairs else KINDS
    return next((each.module for each in kinds if name in (*each.needs, *each.details)), None)


def computed(*, for_repairs: bool = False) -> frozenset[str]:
    """Return the names of all facts that rules may ask for, or if *for_repairs*, repairs."""
    kinds = (*KINDS, *HINTS) if for_repairs else KINDS
    return frozenset(name for each in kinds for name in (*each.needs, *each.details))


def sources(wanted: Iterable[Term]) -> frozenset[Term]:
    """Return the *wanted* terms, and those from which what is computed of them follows."""
    found = set(wanted)
    for kind in (*KINDS, *HINTS):
        for name, terms in kind.needs.items():
            if fact(name) in found:
                found.update(terms)
    for term in CONCLUDED.keys() & found:
        found.update(CONCLUDED[term])
    return frozenset(found)
