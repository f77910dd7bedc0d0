"""The kinds of facts: their names, what each follows from, and what computes it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

from kinlint.facts import needs
from kinlint.facts.circle import circles as dependencies
from kinlint.facts.component import components
from kinlint.facts.contradiction import contradictions
from kinlint.facts.cycle import cycles
from kinlint.facts.entailed import entailed_types
from kinlint.facts.idleness import Idleness
from kinlint.facts.likeness import repeated
from kinlint.facts.names import chain, geom, kin, qudt
from kinlint.facts.order import circles, reordered, steps
from kinlint.facts.proportion import astray, proportions
from kinlint.facts.quantity import stated
from kinlint.facts.recomputation import Recomputations
from kinlint.facts.reference import References
from kinlint.facts.resemblance import resemblances
from kinlint.facts.scan import Scan
from kinlint.facts.supply import Supply
from kinlint.facts.transfer import transfers
from kinlint.facts.workings import Workings
from kinlint.terms import Term, Triple


class Kind(NamedTuple):
    """Facts of one kind."""

    module: str
    """The module of this package that computes them."""
    needs: Mapping[str, tuple[Term, ...]]
    """The properties and classes by which they are asked for, each with those it follows from.

    What is said of elements of files is there unasked, and so is what holds of any node.
    """
    found: Callable[[Workings], Iterator[Triple]]
    """What computes them."""
    parts: tuple[str, ...]
    """The parts of scans that this takes; what a part of `Workings` is made of comes with it."""
    details: tuple[str, ...] = ()
    """Further properties of their nodes."""


QUANTITIES = {
    **dict.fromkeys(("x", "y", "z"), needs.VECTORS),
    **dict.fromkeys(("alpha", "beta", "gamma"), needs.ANGLES),
    "mass": (*needs.MASSES, *needs.TENSORS),
    "value": (qudt("value"), *needs.UNITS),
    **{name: (kin(name), *needs.UNITS) for name in ("lower", "upper", "offset")},
}
RESIDUALS = {
    **dict.fromkeys(("determinant", "orthonormality"), needs.COSINES),
    "orthogonality": needs.BASES,
    "norm": needs.QUATERNION,
    "spread": (*needs.TURNS, *needs.VECTORS),
}
MOMENTS = {
    **dict.fromkeys(
        ("least-moment", "middle-moment", "greatest-moment"), (*needs.TENSORS, *needs.UNITS)
    ),
    "mass": (*needs.MASSES, *needs.TENSORS),
    "body-mass": needs.INERTIAS,
    **dict.fromkeys(
        (
            *("least-central-moment", "middle-central-moment", "greatest-central-moment"),
            "centre-distance",
        ),
        (*needs.INERTIAS, needs.FIRST_MOMENT),
    ),
}
TREES = dict.fromkeys(
    ("root", "root-beside", "claimed-by", "circle", "unresolved", "near-name", "links"),
    needs.TREES,
)
WELDS = dict.fromkeys(
    ("welded-mass", "rests-on", "moved-by"),
    (*needs.INERTIAS, *needs.WELDS, *needs.TREES, kin("MassProperty")),
)
PROPORTIONS = {
    "gyration": needs.INERTIAS,
    **dict.fromkeys(("extent", "least-density", "greatest-density"), needs.SIZES),
}
PLANNING = dict.fromkeys(("comprises", "moves", "between", "joints"), needs.TREES)
RELATED = {
    **dict.fromkeys(("Agreement", "closed-by"), needs.RELATIONS),
    **dict.fromkeys(("of", "first", "second", "traced-to", "compared"), ()),
}
WATER = dict.fromkeys(
    ("water-mass", "water-ixx", "water-iyy", "water-izz"),
    (*needs.SHAPES, *needs.PLACED, kin("MassProperty")),
)
STEPS = {
    **dict.fromkeys(("step", "in-cycle"), needs.DATA),
    **dict.fromkeys(("index", "operator"), ()),
}
NODES = ("member", "derived-from", "size")
ERRORS = ("distance", "angle", "magnitude", "length", "Cycle")
CHANGES = ("entry", "amended")


def _related(workings: Workings) -> Iterator[Triple]:
    """How coordinates of one relation agree, and whether cycles of relations close."""
    yield from workings.agreements.facts()
    yield from cycles(workings.relations, workings.attitudes)


def _alone(
    module: str,
    found: Callable[[Scan], Iterator[Triple]],
    named: Mapping[str, tuple[Term, ...]],
    details: tuple[str, ...] = (),
) -> Kind:
    """Facts that are found by nothing but what a scan reads."""
    part = next(iter(named))
    return Kind(module, named, lambda own: found(own.scan.part(part)), (part,), details)


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
        {"astray": (*needs.SIZES, geom("RigidBody"))},
        lambda own: astray(own.assemblies, own.geometries, own.scan.part("astray")),
        ("assemblies", "geometries", "astray"),
    ),
    Kind(
        "transfer",
        {"transfer": (*needs.INERTIAS, *needs.PLACED)},
        lambda own: transfers(own.inertias, own.assemblies, own.scan.part("transfer")),
        ("assemblies", "transfer"),
    ),
    Kind(
        "amendment",
        {"decimal-slip": (*needs.TENSORS, *needs.UNITS)},
        lambda own: own.amendments.decimal_slips(),
        ("amendments",),
        CHANGES,
    ),
    Kind(
        "amendment",
        {"sign-slip": (*needs.TENSORS, *needs.UNITS)},
        lambda own: own.amendments.sign_slips(),
        ("amendments",),
        CHANGES,
    ),
    Kind(
        "amendment",
        {"solid": needs.SIZES},
        lambda own: own.amendments.solids(),
        ("amendments",),
        CHANGES,
    ),
    Kind(
        "amendment",
        {"shift": (*needs.INERTIAS, *needs.PLACED)},
        lambda own: own.amendments.shifts(),
        ("amendments",),
        CHANGES,
    ),
    Kind("amendment", WATER, lambda own: own.amendments.filled(), ("amendments",)),
    Kind(
        "likeness",
        dict.fromkeys(("shared-with", "shapes"), needs.SIZES),
        lambda own: repeated(own.inertias, own.assemblies, own.geometries),
        ("assemblies", "geometries"),
    ),
    _alone(
        "idleness",
        lambda scan: Idleness(scan).facts(),
        dict.fromkeys(("idle", "working"), needs.DRIVES),
    ),
    Kind("likeness", {"twin": needs.SIDES}, lambda own: own.twins.facts(), ("twins",)),
    Kind(
        "likeness", {"unlike-siblings": needs.SIDES}, lambda own: own.twins.odd_ones(), ("twins",)
    ),
    Kind(
        "drift",
        {"drift": needs.DESCRIPTIONS, "quantity": ()},
        lambda own: own.drifts.facts(),
        ("drifts",),
        ("here", "there", "from"),
    ),
    Kind("planning", PLANNING, lambda own: own.planning.facts(), ("planning",)),
    _alone("circle", dependencies, {"leads-back-to": (kin("leader"), kin("follower"))}),
    Kind(
        "reference",
        {"resembles": ()},
        lambda own: References(own.scan.part("referred-to")).facts(),
        ("referred-to",),
    ),
    Kind("agreement", RELATED, _related, ("agreements",), (*ERRORS, *NODES)),
    _alone(
        "component",
        components,
        dict.fromkeys(("component", "undecided"), (chain("joints"), *needs.WELDS)),
        NODES,
    ),
    Kind("order", STEPS, lambda own: steps(own.scan.part("steps")), ("steps",), NODES),
    Kind(
        "order", STEPS, lambda own: circles(own.scan.part("data-cycles")), ("data-cycles",), NODES
    ),
    _alone("supply", lambda scan: Supply(scan).facts(), {"supplied-by": needs.DATA}),
    _alone("entailed", entailed_types, {"entailed-type": ()}),
    _alone("contradiction", contradictions, {"excluded-type": (), "contradicted": ()}),
    _alone("resemblance", resemblances, {"resembles": ()}),
)
"""All kinds of facts that rules may ask for."""

HINTS = (
    Kind(
        "identifier", {"slip-for": ()}, lambda own: own.identifiers.resemblances(), ("identifiers",)
    ),
    Kind(
        "identifier", {"free-name": ()}, lambda own: own.identifiers.free_names(), ("identifiers",)
    ),
    _alone("order", reordered, {"reordered": needs.DATA}, ("cell", "due")),
    Kind(
        "recomputation",
        {"recomputed": ()},
        lambda own: Recomputations(own.agreements).facts(),
        ("agreements",),
        (*CHANGES, *ERRORS, "turned", "place"),
    ),
)
"""All kinds of facts that only repairs ask for."""
