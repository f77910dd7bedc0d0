"""All that is computed from a model."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import NamedTuple

from kinlint.engine.store import Store
from kinlint.facts.circle import circles as dependencies
from kinlint.facts.component import components
from kinlint.facts.contradiction import contradictions
from kinlint.facts.cycle import cycles
from kinlint.facts.entailed import entailed_types
from kinlint.facts.idleness import Idleness
from kinlint.facts.likeness import repeated
from kinlint.facts.order import circles, reordered, steps
from kinlint.facts.proportion import astray, proportions
from kinlint.facts.quantity import stated
from kinlint.facts.recomputation import Recomputations
from kinlint.facts.reference import References
from kinlint.facts.resemblance import resemblances
from kinlint.facts.scan import Scan
from kinlint.facts.statement import fact
from kinlint.facts.supply import Supply
from kinlint.facts.transfer import transfers
from kinlint.facts.workings import Workings
from kinlint.terms import Term, Triple


class Kind(NamedTuple):
    """Facts of one kind."""

    module: str
    """The module of this package that computes them."""
    names: tuple[str, ...]
    """The properties, and classes, by which they are asked for."""
    found: Callable[[Workings], Iterator[Triple]]
    """What computes them."""
    parts: tuple[str, ...]
    """The parts of scans that this takes; what a part of `Workings` is made of comes with it."""
    details: tuple[str, ...] = ()
    """Further properties of their nodes."""


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
NODES = ("member", "derived-from", "size")
ERRORS = ("distance", "angle", "magnitude", "length", "Cycle")
CHANGES = ("entry", "amended")


def facts(store: Store, wanted: frozenset[Term] | None = None) -> Iterator[Triple]:
    """The facts that follow from what *store* holds, which is closed under its axioms.

    Only of those kinds that have a property among the *wanted*; None is all. Linear in the model.
    What is no number, or ambiguous, gives no fact and never an error.
    """
    if not store.documents:
        return
    workings = Workings(Scan(store))
    for kind in asked(wanted):
        yield from kind.found(workings)


def asked(wanted: frozenset[Term] | None) -> Iterator[Kind]:
    """The kinds of facts that have a property among the *wanted*; None is all."""
    for kind in KINDS:
        if wanted is None or any(fact(name) in wanted for name in kind.names):
            yield kind


def hints(store: Store, wanted: Iterable[Term]) -> Iterator[Triple]:
    """What repairs need to know of *store*, and no rule: of that, what is *wanted*."""
    workings = Workings(Scan(store))
    for kind in helpful(wanted):
        yield from kind.found(workings)


def helpful(wanted: Iterable[Term]) -> Iterator[Kind]:
    """The kinds of hints that have a property among the *wanted*."""
    terms = frozenset(wanted)
    return (kind for kind in HINTS if any(fact(name) in terms for name in kind.names))


def _related(workings: Workings) -> Iterator[Triple]:
    """How coordinates of one relation agree, and whether cycles of relations close."""
    yield from workings.agreements.facts()
    yield from cycles(workings.relations, workings.attitudes)


def computed_by(name: str, *, for_repairs: bool = False) -> str | None:
    """Return the module that computes the facts called *name*; None if none does.

    Some are there *for_repairs* only.
    """
    kinds = (*KINDS, *HINTS) if for_repairs else KINDS
    return next((each.module for each in kinds if name in (*each.names, *each.details)), None)


def computed(*, for_repairs: bool = False) -> frozenset[str]:
    """Return the names of all facts that rules may ask for, or if *for_repairs*, repairs."""
    kinds = (*KINDS, *HINTS) if for_repairs else KINDS
    return frozenset(name for each in kinds for name in (*each.names, *each.details))


def _alone(
    module: str,
    found: Callable[[Scan], Iterator[Triple]],
    *names: str,
    details: tuple[str, ...] = (),
) -> Kind:
    """Facts that are found by nothing but what a scan reads."""
    part = names[:1]
    return Kind(module, names, lambda workings: found(workings.scan.part(*part)), part, details)


KINDS = (
    Kind(
        "quantity",
        QUANTITIES,
        lambda own: stated(own.vectors, own.angles, own.masses, own.values),
        ("vectors", "angles", "masses", "values"),
    ),
    Kind("rotation", RESIDUALS, lambda own: own.rotations.facts(), ("rotations",)),
    Kind("basis", RESIDUALS, lambda own: own.bases.facts(), ("bases",)),
    Kind("inertia", MOMENTS, lambda own: own.inertias.facts(), ("inertias",)),
    Kind("tree", TREES, lambda own: own.trees.facts(), ("trees",)),
    Kind("assembly", WELDS, lambda own: own.assemblies.facts(), ("assemblies",)),
    Kind(
        "proportion",
        PROPORTIONS,
        lambda own: proportions(own.inertias, own.assemblies, own.geometries),
        ("assemblies", "geometries"),
    ),
    Kind(
        "proportion",
        ("astray",),
        lambda own: astray(own.assemblies, own.geometries, own.scan.part("astray")),
        ("assemblies", "geometries", "astray"),
    ),
    Kind(
        "transfer",
        ("transfer",),
        lambda own: transfers(own.inertias, own.assemblies, own.scan.part("transfer")),
        ("assemblies", "transfer"),
    ),
    Kind(
        "amendment",
        ("decimal-slip",),
        lambda own: own.amendments.decimal_slips(),
        ("amendments",),
        CHANGES,
    ),
    Kind(
        "amendment",
        ("sign-slip",),
        lambda own: own.amendments.sign_slips(),
        ("amendments",),
        CHANGES,
    ),
    Kind("amendment", ("solid",), lambda own: own.amendments.solids(), ("amendments",), CHANGES),
    Kind("amendment", ("shift",), lambda own: own.amendments.shifts(), ("amendments",), CHANGES),
    Kind("amendment", WATER, lambda own: own.amendments.filled(), ("amendments",)),
    Kind(
        "likeness",
        ("shared-with", "shapes"),
        lambda own: repeated(own.inertias, own.assemblies, own.geometries),
        ("assemblies", "geometries"),
    ),
    _alone("idleness", lambda scan: Idleness(scan).facts(), "idle", "working"),
    Kind("likeness", ("twin",), lambda own: own.twins.facts(), ("twins",)),
    Kind("likeness", ("unlike-siblings",), lambda own: own.twins.odd_ones(), ("twins",)),
    Kind(
        "drift",
        ("drift", "quantity"),
        lambda own: own.drifts.facts(),
        ("drifts",),
        ("here", "there", "from"),
    ),
    Kind("planning", PLANNING, lambda own: own.planning.facts(), ("planning",)),
    _alone("circle", dependencies, "leads-back-to"),
    Kind(
        "reference",
        ("resembles",),
        lambda own: References(own.scan.part("referred-to")).facts(),
        ("referred-to",),
    ),
    Kind("agreement", RELATED, _related, ("agreements",), (*ERRORS, *NODES)),
    _alone("component", components, "component", "undecided", details=NODES),
    Kind("order", STEPS, lambda own: steps(own.scan.part("steps")), ("steps",), NODES),
    Kind(
        "order", STEPS, lambda own: circles(own.scan.part("data-cycles")), ("data-cycles",), NODES
    ),
    _alone("supply", lambda scan: Supply(scan).facts(), "supplied-by"),
    _alone("entailed", entailed_types, "entailed-type"),
    _alone("contradiction", contradictions, "excluded-type", "contradicted"),
    _alone("resemblance", resemblances, "resembles"),
)
"""All kinds of facts that rules may ask for."""

HINTS = (
    Kind("identifier", ("slip-for",), lambda own: own.identifiers.resemblances(), ("identifiers",)),
    Kind("identifier", ("free-name",), lambda own: own.identifiers.free_names(), ("identifiers",)),
    _alone("order", reordered, "reordered", details=("cell", "due")),
    Kind(
        "recomputation",
        ("recomputed",),
        lambda own: Recomputations(own.agreements).facts(),
        ("agreements",),
        (*CHANGES, *ERRORS, "turned", "place"),
    ),
)
"""All kinds of facts that only repairs ask for."""
