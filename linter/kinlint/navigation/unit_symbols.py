"""Units as people write them: their symbols, and those of what SI has for the same kind."""

from __future__ import annotations

from kinlint.engine.store import Store
from kinlint.facts.predicate_index import numeric
from kinlint.terms import Term, iri, literal_value
from kinlint.vocabulary import QUDT

SYMBOL, MULTIPLIER = iri(f"{QUDT}symbol"), iri(f"{QUDT}conversionMultiplier")
OFFSET, KIND = iri(f"{QUDT}conversionOffset"), iri(f"{QUDT}hasQuantityKind")


def symbol(store: Store, unit: Term) -> str:
    """Return the symbol of *unit* behind a number; nothing if it has none, or is 1."""
    found = next(map(literal_value, store.values(unit, SYMBOL)), "")
    return "" if found == "1" else found


def multiplier(store: Store, unit: Term) -> float | None:
    """Return the factor from *unit* to the SI unit; None if it is not known."""
    return next((numeric(each) for each in store.values(unit, MULTIPLIER)), None)


def coherent(store: Store, unit: Term) -> str:
    """Return the symbol of the SI unit of what *unit* measures; empty if there is none.

    Angles are in radians, torques in newton metres.
    """
    kinds = list(store.values(unit, KIND))
    alike = (each for kind in kinds for each in store.subjects(KIND, kind))
    for each in (unit, *sorted(alike)):
        if multiplier(store, each) == 1 and not any(store.values(each, OFFSET)):
            return symbol(store, each)
    return ""
