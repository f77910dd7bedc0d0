"""Kinds of facts: their names, the terms each follows from, and the code that computes it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from importlib import import_module

from kinlint.facts import inputs
from kinlint.facts.body_shapes import BodyShapes
from kinlint.facts.coordinate_repair import CoordinateRepairs
from kinlint.facts.dangling_references import DanglingReferences
from kinlint.facts.drawn_symmetry import DrawnSymmetry
from kinlint.facts.fact_context import FactContext
from kinlint.facts.fact_kind import FactKind
from kinlint.facts.fact_needs import (
    CHANGES,
    DRAWN,
    ELSEWHERE,
    ERRORS,
    IDLE,
    MISPLACED,
    MOMENTS,
    MOTIONS,
    NODES,
    ODD,
    PLANNING,
    PROPORTIONS,
    QUANTITIES,
    RELATED,
    RESIDUALS,
    SIBLINGS,
    SOLID,
    STEPS,
    TREES,
    UNLIKE,
    WATER,
    WELDS,
    WHEELS,
)
from kinlint.facts.length_outliers import outlying_lengths
from kinlint.facts.linkage_loops import stretched_loops
from kinlint.facts.loop_closure import cycles
from kinlint.facts.mass_distribution import com_far_from_joints, com_outside, proportions
from kinlint.facts.metamodel_terms import chain, geom, kin, qudt
from kinlint.facts.mirror_symmetry import shared_inertias, unmirrored_centres
from kinlint.facts.misplaced_inertia import misplaced_inertias
from kinlint.facts.odd_siblings import odd_siblings
from kinlint.facts.parallel_axis import parallel_axis_residuals
from kinlint.facts.quantity import stated
from kinlint.facts.query_terms import SELECT
from kinlint.facts.schedule_order import data_cycles, steps
from kinlint.facts.shape_agreement import shape_pairs
from kinlint.facts.wheels import wheels
from kinlint.facts.written_features import FEATURES
from kinlint.terms import Term, Triple, iri
from kinlint.vocabulary import GENERATION

LIBRARY = iri(f"{GENERATION}Library")


def _related(context: FactContext) -> Iterator[Triple]:
    """Yield how coordinates of one relation agree, and whether loops of relations close."""
    yield from context.agreements.facts()
    yield from cycles(context.relations, context.orientations)


def _motions(context: FactContext) -> Iterator[Triple]:
    """Yield what keeps joints from being one tree, where the vocabulary has a library of programs.

    Rules that ask for any property would have it computed in every run.
    """
    if context.scan.part("motions").instances(LIBRARY):
        yield from context.motions.facts()


def _alone(
    module: str,
    function: str,
    named: Mapping[str, tuple[Term, ...]],
    details: tuple[str, ...] = (),
) -> FactKind:
    """Return a kind of facts that a *function* of a predicate index yields.

    Its *module* is loaded when the facts are asked for, which few runs do.
    """
    part = next(iter(named))

    def found(own: FactContext) -> Iterator[Triple]:
        yield from getattr(import_module(f"kinlint.facts.{module}"), function)(own.scan.part(part))

    return FactKind(module, named, found, (part,), details)


def _inertia_repair(
    needs: Mapping[str, tuple[Term, ...]], found: Callable[[FactContext], Iterator[Triple]]
) -> FactKind:
    return FactKind("inertia_repair", needs, found, ("inertia_repairs",), CHANGES)


def _mirrored(name: str, found: Callable[[FactContext], Iterator[Triple]]) -> FactKind:
    return FactKind("mirror_symmetry", {name: inputs.SIDES}, found, ("twins",))


def _drawn(
    module: str,
    needs: Mapping[str, tuple[Term, ...]],
    found: Callable[[DrawnSymmetry, BodyShapes], Iterator[Triple]],
    details: tuple[str, ...] = (),
) -> FactKind:
    parts = ("symmetry", "geometries")
    return FactKind(module, needs, lambda own: found(own.symmetry, own.geometries), parts, details)


def _identifier_slip(name: str, found: Callable[[FactContext], Iterator[Triple]]) -> FactKind:
    return FactKind("identifier_slips", {name: ()}, found, ("identifiers",))


KINDS = (
    FactKind(
        "quantity",
        QUANTITIES,
        lambda own: stated(own.vectors, own.angles, own.masses, own.values),
        ("vectors", "angles", "masses", "values"),
    ),
    FactKind("rotation", RESIDUALS, lambda own: own.rotations.facts(), ("rotations",)),
    FactKind("basis", RESIDUALS, lambda own: own.bases.facts(), ("bases",)),
    FactKind("inertia", MOMENTS, lambda own: own.inertias.facts(), ("inertias",)),
    FactKind("link_trees", TREES, lambda own: own.trees.facts(), ("trees",)),
    FactKind("assembly", WELDS, lambda own: own.assemblies.facts(), ("assemblies",)),
    FactKind(
        "mass_distribution",
        PROPORTIONS,
        lambda own: proportions(own.inertias, own.assemblies, own.geometries),
        ("assemblies", "geometries"),
    ),
    FactKind(
        "mass_distribution",
        dict.fromkeys(("astray", "remote"), (*inputs.SIZES, kin("mesh"), geom("RigidBody"))),
        lambda own: com_outside(own.assemblies, own.geometries, own.placements),
        ("assemblies", "geometries", "placements"),
        ("remote-error",),
    ),
    FactKind(
        "mass_distribution",
        {"beyond-joints": (*inputs.MASSES, *inputs.PLACED, *inputs.SHAPES)},
        lambda own: com_far_from_joints(own.assemblies, own.geometries, own.placements),
        ("assemblies", "geometries", "placements"),
        ("widest",),
    ),
    FactKind(
        "misplaced_inertia",
        MISPLACED,
        lambda own: misplaced_inertias(
            own.inertias, own.assemblies, own.geometries, own.orientations
        ),
        ("assemblies", "geometries", "orientations"),
        SOLID,
    ),
    FactKind(
        "length_outliers",
        dict.fromkeys(
            ("outlying-length", "outlying-place", "median-length"),
            (*inputs.PLACED, *inputs.SHAPES),
        ),
        lambda own: outlying_lengths(own.placements, own.geometries),
        ("geometries", "placements"),
        ("typical-length",),
    ),
    FactKind(
        "parallel_axis",
        {"transfer": (*inputs.INERTIAS, *inputs.PLACED)},
        lambda own: parallel_axis_residuals(own.inertias, own.assemblies, own.placements),
        ("assemblies", "placements"),
    ),
    _inertia_repair(
        {"decimal-slip": (*inputs.TENSORS, *inputs.UNITS)},
        lambda own: own.inertia_repairs.decimal_slips(),
    ),
    _inertia_repair(
        {"sign-slip": (*inputs.TENSORS, *inputs.UNITS)},
        lambda own: own.inertia_repairs.sign_slips(),
    ),
    _inertia_repair({"solid": inputs.SIZES}, lambda own: own.inertia_repairs.solids()),
    _inertia_repair(
        {"shift": (*inputs.INERTIAS, *inputs.PLACED)}, lambda own: own.inertia_repairs.shifts()
    ),
    _inertia_repair(WATER, lambda own: own.inertia_repairs.filled()),
    FactKind(
        "mirror_symmetry",
        dict.fromkeys(("shared-with", "shapes"), inputs.SIZES),
        lambda own: shared_inertias(own.inertias, own.assemblies, own.geometries),
        ("assemblies", "geometries"),
    ),
    _alone("zero_limits", "zero_limits", IDLE),
    _alone("compared_units", "odd_units", UNLIKE, ("least-like", "most-like")),
    _mirrored("twin", lambda own: own.twins.facts()),
    FactKind(
        "mirror_symmetry",
        {"unlike-centre": (*inputs.INERTIAS, *inputs.RELATIONS)},
        lambda own: unmirrored_centres(own.inertias, own.assemblies, own.relations),
        ("assemblies", "relations"),
    ),
    _mirrored("unlike-siblings", lambda own: own.twins.odd_ones()),
    FactKind(
        "drawn_symmetry",
        DRAWN,
        lambda own: own.symmetry.facts(),
        ("symmetry",),
        ("step-x", "step-y", "step-z", "own-side"),
    ),
    _drawn("wheels", WHEELS, wheels),
    _drawn("odd_siblings", SIBLINGS, odd_siblings, ODD),
    FactKind(
        "shape_agreement",
        {"drawn-as": (*inputs.SHAPES, *inputs.PLACED)},
        lambda own: shape_pairs(own.geometries),
        ("geometries",),
        ("apart", "size-ratio", "sorted-ratio", "extent-ratio"),
    ),
    FactKind(
        "drift",
        {"drift": inputs.DESCRIPTIONS, "quantity": ()},
        lambda own: own.drift_facts(),
        ("drifts",),
        ("here", "there", "from", "evidence", "angle", "aspect"),
    ),
    FactKind("planning_groups", PLANNING, lambda own: own.planning.facts(), ("planning",)),
    _alone(
        "dependency_cycles",
        "dependency_cycles",
        {"leads-back-to": (kin("leader"), kin("follower"))},
    ),
    FactKind(
        "dangling_references",
        {"resembles": ()},
        lambda own: DanglingReferences(own.scan.part("referred-to")).facts(),
        ("referred-to",),
    ),
    _alone("crossed_references", "crossed_references", {"refers-across": ()}, ("proper-target",)),
    FactKind("coordinate_agreement", RELATED, _related, ("agreements",), (*ERRORS, *NODES)),
    FactKind(
        "linkage_loops",
        {"other-sides": (*inputs.RELATIONS, *inputs.WELDS, chain("Joint"))},
        lambda own: stretched_loops(own.mechanism, own.relations),
        ("mechanism", "relations"),
        ("closing-joint", "side-length"),
    ),
    _alone(
        "connected_components",
        "components",
        dict.fromkeys(("component", "undecided"), (chain("joints"), *inputs.WELDS)),
        NODES,
    ),
    FactKind("tree_motions", MOTIONS, _motions, ("motions",)),
    FactKind("schedule_order", STEPS, lambda own: steps(own.scan.part("steps")), ("steps",), NODES),
    FactKind(
        "schedule_order",
        STEPS,
        lambda own: data_cycles(own.scan.part("data-cycles")),
        ("data-cycles",),
        NODES,
    ),
    _alone("dataflow", "data_sources", {"supplied-by": inputs.DATA}),
    _alone("entailed_types", "entailed_types", {"entailed-type": ()}),
    _alone("contradiction", "contradictions", {"excluded-type": (), "contradicted": ()}),
    _alone("misspelt_quantities", "resemblances", {"resembles": ()}),
    _alone(
        "missing_contexts",
        "missing_contexts",
        {"missing-context": ()},
        ("context", "count", "word", *NODES),
    ),
    _alone("prefix_disagreement", "disagreements", {"is-elsewhere": ()}, ELSEWHERE),
    _alone(
        "undescribed_names",
        "undescribed_names",
        {"undescribed-in": ()},
        ("described", "first", "subject", "property", "beside", *NODES),
    ),
    _identifier_slip("slip-for", lambda own: own.identifiers.resemblances()),
    _alone("compared_units", "shared_units", {"shares-unit-with": (qudt("unit"),)}),
    _alone("namesakes", "namesakes", {"namesake": ()}),
    _alone("query_terms", "query_terms", {"query-term": (SELECT,)}),
    _alone("written_features", "written_features", FEATURES)._replace(by_name=True),
)
"""All kinds of facts that rules may ask for."""

HINTS = (
    _identifier_slip("free-name", lambda own: own.identifiers.free_names()),
    _alone("schedule_order", "reordered", {"reordered": inputs.DATA}, ("cell", "due")),
    FactKind(
        "coordinate_repair",
        {"recomputed": ()},
        lambda own: CoordinateRepairs(own.agreements).facts(),
        ("agreements",),
        (*CHANGES, *ERRORS, "turned", "place"),
    ),
)
"""All kinds of facts that only repairs ask for."""
