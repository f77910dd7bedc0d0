"""All that is computed from a model."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import TypeAlias

from kinlint.engine.store import Store
from kinlint.facts.agreement import Agreements
from kinlint.facts.amendment import Amendments
from kinlint.facts.assembly import Assemblies
from kinlint.facts.attitude import Attitudes
from kinlint.facts.basis import Bases
from kinlint.facts.circle import circles as dependencies
from kinlint.facts.component import components
from kinlint.facts.contradiction import contradictions
from kinlint.facts.cycle import cycles
from kinlint.facts.drift import Drifts
from kinlint.facts.entailed import entailed_types
from kinlint.facts.geometry import Geometries
from kinlint.facts.identifier import Identifiers
from kinlint.facts.idleness import Idleness
from kinlint.facts.inertia import Inertias
from kinlint.facts.likeness import Twins, repeated
from kinlint.facts.order import circles, reordered, steps
from kinlint.facts.planning import Planning
from kinlint.facts.proportion import astray, proportions
from kinlint.facts.quantity import Quantities
from kinlint.facts.recomputation import Recomputations
from kinlint.facts.reference import References
from kinlint.facts.relation import Relations
from kinlint.facts.resemblance import resemblances
from kinlint.facts.rotation import Rotations
from kinlint.facts.scan import Scan
from kinlint.facts.statement import fact
from kinlint.facts.supply import Supply
from kinlint.facts.transfer import transfers
from kinlint.facts.tree import Trees
from kinlint.facts.units import Units
from kinlint.terms import Term, Triple

Kind: TypeAlias = tuple[tuple[str, ...], Callable[[], Iterator[Triple]]]
"""The properties that facts of one kind have, and what finds them."""

QUANTITIES = ("x", "y", "z", "alpha", "beta", "gamma", "mass", "value", "lower", "upper", "offset")
RESIDUALS = ("determinant", "orthonormality", "orthogonality", "norm", "spread")
MOMENTS = (
    *("least-moment", "middle-moment", "greatest-moment", "mass", "body-mass"),
    *("least-central-moment", "middle-central-moment", "greatest-central-moment"),
    "centre-distance",
)
TREES = ("root", "root-beside", "claimed-by", "circle", "unresolved", "near-name", "links")
WELDS = ("welded-mass", "rests-on", "moved-by")
PROPORTIONS = ("gyration", "extent", "least-density", "greatest-density")
PLANNING = ("comprises", "moves", "between", "joints")
RELATED = ("Agreement", "of", "first", "second", "closed-by", "traced-to", "compared")
WATER = ("water-mass", "water-ixx", "water-iyy", "water-izz")
STEPS = ("step", "index", "operator", "in-cycle")


def facts(store: Store, wanted: frozenset[Term] | None = None) -> Iterator[Triple]:
    """The facts that follow from what *store* holds, which is closed under its axioms.

    Only of those kinds that have a property among the *wanted*; None is all. Linear in the model.
    What is no number, or ambiguous, gives no fact and never an error.
    """
    if not store.documents:
        return
    for names, found in _kinds(Scan(store)):
        if wanted is None or any(fact(name) in wanted for name in names):
            yield from found()


def hints(store: Store, wanted: Iterable[Term]) -> Iterator[Triple]:
    """What repairs need to know of *store*, and no rule: of that, what is *wanted*."""
    scan = Scan(store)
    identifiers = Identifiers(scan)
    kinds: tuple[tuple[str, Callable[[], Iterator[Triple]]], ...] = (
        ("slip-for", identifiers.resemblances),
        ("free-name", identifiers.free_names),
        ("reordered", partial(reordered, scan)),
        ("recomputed", partial(_recomputed, scan)),
    )
    asked = frozenset(wanted)
    for name, found in kinds:
        if fact(name) in asked:
            yield from found()


def _recomputed(scan: Scan) -> Iterator[Triple]:
    """What coordinates that contradict others could say instead."""
    units = Units(scan)
    quantities = Quantities(scan, units)
    relations = Relations(scan, quantities, Rotations(scan, quantities))
    inertias = Inertias(scan, units, quantities)
    agreements = Agreements(relations, Attitudes(relations.turns), inertias)
    yield from Recomputations(agreements).facts()


def _kinds(scan: Scan) -> Iterator[Kind]:
    """The kinds of facts: the properties of each, and what computes it once it is asked for."""
    units = Units(scan)
    quantities = Quantities(scan, units)
    rotations = Rotations(scan, quantities)
    inertias = Inertias(scan, units, quantities)
    yield QUANTITIES, quantities.facts
    yield RESIDUALS, rotations.facts
    yield RESIDUALS, Bases(scan, quantities).facts
    yield MOMENTS, inertias.facts
    yield from _bodies(scan, units, inertias)
    yield RELATED, partial(_related, scan, quantities, rotations, inertias)
    yield ("component", "undecided"), partial(components, scan)
    yield STEPS, partial(steps, scan)
    yield STEPS, partial(circles, scan)
    yield ("supplied-by",), partial(_supplied, scan)
    yield ("entailed-type",), partial(entailed_types, scan)
    yield ("excluded-type", "contradicted"), partial(contradictions, scan)
    yield ("resembles",), partial(resemblances, scan)


def _bodies(scan: Scan, units: Units, inertias: Inertias) -> Iterator[Kind]:
    """What is known of links, joints and what drives them."""
    trees = Trees(scan)
    assemblies = Assemblies(scan, inertias, trees)
    geometries = Geometries(scan, units)
    yield TREES, trees.facts
    yield WELDS, assemblies.facts
    yield PROPORTIONS, partial(proportions, inertias, assemblies, geometries)
    yield ("astray",), partial(astray, assemblies, geometries, scan)
    yield ("transfer",), partial(transfers, inertias, assemblies, scan)
    amendments = Amendments(scan, inertias, assemblies, geometries)
    yield ("decimal-slip",), amendments.decimal_slips
    yield ("sign-slip",), amendments.sign_slips
    yield ("solid",), amendments.solids
    yield ("shift",), amendments.shifts
    yield WATER, amendments.filled
    yield ("shared-with", "shapes"), partial(repeated, inertias, assemblies, geometries)
    yield ("idle", "working"), Idleness(scan).facts
    twins = Twins(scan, assemblies)
    yield ("twin",), twins.facts
    yield ("unlike-siblings",), twins.odd_ones
    yield ("drift", "quantity"), Drifts(scan, assemblies).facts
    yield PLANNING, Planning(scan, trees).facts
    yield ("leads-back-to",), partial(dependencies, scan)
    yield ("resembles",), partial(_resembling, scan)


def _supplied(scan: Scan) -> Iterator[Triple]:
    """Where the data of operators come from."""
    return Supply(scan).facts()


def _resembling(scan: Scan) -> Iterator[Triple]:
    """What the names that elements refer to resemble."""
    return References(scan).facts()


def _related(
    scan: Scan, quantities: Quantities, rotations: Rotations, inertias: Inertias
) -> Iterator[Triple]:
    """How coordinates of one relation agree, and whether cycles of relations close."""
    relations = Relations(scan, quantities, rotations)
    attitudes = Attitudes(relations.turns)
    yield from Agreements(relations, attitudes, inertias).facts()
    yield from cycles(relations, attitudes)
