"""All that is computed from a model."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.engine.store import Store
from kinlint.facts.agreement import Agreements
from kinlint.facts.attitude import Attitudes
from kinlint.facts.basis import Bases
from kinlint.facts.component import components
from kinlint.facts.contradiction import contradictions
from kinlint.facts.cycle import cycles
from kinlint.facts.entailed import entailed_types
from kinlint.facts.inertia import Inertias
from kinlint.facts.order import circles, steps
from kinlint.facts.quantity import Quantities
from kinlint.facts.relation import Relations
from kinlint.facts.resemblance import resemblances
from kinlint.facts.rotation import Rotations
from kinlint.facts.scan import Scan
from kinlint.facts.supply import Supply
from kinlint.facts.units import Units
from kinlint.terms import Triple


def facts(store: Store) -> Iterator[Triple]:
    """The facts that follow from what *store* holds, which is closed under its axioms.

    Linear in the model. What is no number, or ambiguous, gives no fact and never an error.
    """
    if not store.documents:
        return
    scan = Scan(store)
    units = Units(scan)
    quantities = Quantities(scan, units)
    rotations = Rotations(scan, quantities)
    inertias = Inertias(scan, units, quantities)
    yield from quantities.facts()
    yield from rotations.facts()
    yield from Bases(scan, quantities).facts()
    yield from inertias.facts()
    relations = Relations(scan, quantities, rotations)
    attitudes = Attitudes(relations.turns)
    yield from Agreements(relations, attitudes, inertias).facts()
    yield from cycles(relations, attitudes)
    yield from components(scan)
    yield from steps(scan)
    yield from circles(scan)
    yield from Supply(scan).facts()
    yield from entailed_types(scan)
    yield from contradictions(scan)
    yield from resemblances(scan)
