"""Kinds of quantity that are measured by the same units."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.facts.fact_statements import fact
from kinlint.facts.metamodel_terms import qudt
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.units import KIND
from kinlint.terms import Triple


def shared_units(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield for each kind that a model states the kinds with which it shares a unit, itself too."""
    units = scan.instances(qudt("Unit"))
    measured = scan.table(KIND)
    stated = {kind for node, kinds in measured.items() if node not in units for kind in kinds}
    shared = {
        (kind, other)
        for unit in units
        for kind in stated.intersection(measured.values(unit))
        for other in measured.values(unit)
    }
    for kind, other in sorted(shared):
        yield kind, fact("shares-unit-with"), other
