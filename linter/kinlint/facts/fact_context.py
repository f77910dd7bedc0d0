"""The parts that facts are computed by, each made when it is first asked for."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Generic, TypeVar

from kinlint.facts.assembly import Assemblies
from kinlint.facts.basis import Bases
from kinlint.facts.body_shapes import BodyShapes
from kinlint.facts.coordinate_agreement import CoordinateAgreements
from kinlint.facts.description_pairs import are_several
from kinlint.facts.drawn_symmetry import DrawnSymmetry
from kinlint.facts.frame_placement import Placements
from kinlint.facts.identifier_slips import IdentifierSlips
from kinlint.facts.inertia import Inertias
from kinlint.facts.inertia_repair import InertiaRepairs
from kinlint.facts.joint_numbers import JointNumbers
from kinlint.facts.link_trees import LinkTrees
from kinlint.facts.mechanism import Mechanism
from kinlint.facts.mirror_symmetry import MirrorTwins
from kinlint.facts.orientation_graph import OrientationGraph
from kinlint.facts.planning_groups import PlanningGroups
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.quantity import Quantities
from kinlint.facts.rotation import Rotations
from kinlint.facts.spatial_relations import SpatialRelations
from kinlint.facts.units import Units
from kinlint.terms import Triple

if TYPE_CHECKING:
    from kinlint.facts.comparison.extraction import RobotParts
    from kinlint.facts.drift import DescriptionDrifts
    from kinlint.facts.tree_motions import JointMotions

T = TypeVar("T")


class Part(Generic[T]):
    """A part of a context, made by *make* from the context and an index, and then kept.

    The index is the part's own (`PredicateIndex.part`), so that what it reads is known; *below*
    are the names of the parts that it is made of. Deleting the attribute has it made again.
    """

    def __init__(
        self, make: Callable[[FactContext, PredicateIndex], T], below: tuple[str, ...] = ()
    ) -> None:
        self.make = make
        self.below = below

    def __set_name__(self, owner: type[FactContext], name: str) -> None:
        self.name = name

    def __get__(self, context: FactContext, owner: type[FactContext]) -> T:
        made = self.make(context, context.scan.part(self.name, *self.below))
        context.__dict__[self.name] = made
        return made


class FactContext:
    """The parts that facts of one model are computed by; they share what they have found."""

    def __init__(self, scan: PredicateIndex) -> None:
        self.scan = scan

    units = Part(lambda _, scan: Units(scan))
    """The units that nodes name."""
    vectors = Part(lambda own, scan: Quantities(scan, own.units), ("units",))
    """Vectors in SI units."""
    angles = Part(lambda own, scan: Quantities(scan, own.units), ("units",))
    """Angles in rad."""
    masses = Part(lambda own, scan: Quantities(scan, own.units), ("units",))
    """Masses in kg."""
    values = Part(lambda own, scan: Quantities(scan, own.units), ("units",))
    """Other numbers in SI units."""
    rotations = Part(lambda own, scan: Rotations(scan, own.angles), ("angles",))
    """Rotations, and how far what is stated is from being one."""
    bases = Part(lambda own, scan: Bases(scan, own.vectors), ("vectors",))
    """Frames that are drawn by vectors."""
    inertias = Part(lambda own, scan: Inertias(scan, own.units, own.masses), ("units", "masses"))
    """Masses and moments of inertia."""
    relations = Part(
        lambda own, scan: SpatialRelations(scan, own.vectors, own.rotations),
        ("vectors", "rotations"),
    )
    """Spatial relations with numbers."""
    orientations = Part(lambda own, _: OrientationGraph(own.relations.turns), ("relations",))
    """Chains of orientations."""
    agreements = Part(
        lambda own, _: CoordinateAgreements(own.relations, own.orientations, own.inertias),
        ("relations", "orientations", "inertias"),
    )
    """Several coordinates of one relation, compared."""
    mechanism = Part(lambda _, scan: Mechanism(scan))
    """Bodies and joints."""
    trees = Part(lambda own, scan: LinkTrees(scan, own.mechanism), ("mechanism",))
    """The links and joints of files that tell parent from child."""
    assemblies = Part(
        lambda own, scan: Assemblies(scan, own.inertias, own.trees), ("inertias", "trees")
    )
    """Bodies that are fixed to each other."""
    placements = Part(lambda own, scan: Placements(scan, own.relations), ("relations",))
    """Poses of frames on their bodies."""
    joints = Part(
        lambda own, scan: JointNumbers(scan, own.angles, own.mechanism, own.placements),
        ("angles", "mechanism", "placements"),
    )
    """Poses, axes, limits and couplings of joints."""
    motions = Part(
        lambda own, _: own.joint_motions(),
        ("mechanism", "relations", "placements"),
    )
    """The motion that each joint of a tree allows."""
    geometries = Part(
        lambda own, scan: BodyShapes(scan, own.units, own.placements), ("units", "placements")
    )
    """The shapes of bodies."""
    inertia_repairs = Part(
        lambda own, scan: InertiaRepairs(
            scan, own.inertias, own.assemblies, own.geometries, own.placements
        ),
        ("inertias", "assemblies", "geometries", "placements"),
    )
    """Numbers that wrong inertias may have been meant to have."""
    twins = Part(lambda own, scan: MirrorTwins(scan, own.assemblies), ("assemblies",))
    """Parts that mirror each other."""
    symmetry = Part(
        lambda own, _: DrawnSymmetry(own.trees, own.placements, own.joints),
        ("trees", "placements", "joints"),
    )
    """Left and right as they are drawn."""
    drifts = Part(
        lambda own, scan: own.description_drifts(scan),
        ("assemblies", "placements", "joints", "geometries", "inertias", "relations", "mechanism"),
    )
    """Files that describe one robot differently."""
    planning = Part(lambda own, scan: PlanningGroups(scan, own.trees), ("trees",))
    """The groups of SRDF files."""
    identifiers = Part(lambda _, scan: IdentifierSlips(scan))
    """Names that files give to what they describe."""

    def joint_motions(self) -> JointMotions:
        """Return the motions of joints."""
        from kinlint.facts.tree_motions import JointMotions  # noqa: PLC0415  of programs alone

        return JointMotions(self.mechanism, self.relations, self.placements)

    def robot_parts(self, scan: PredicateIndex) -> RobotParts:
        """Return the facts that robots are read from as a whole, besides what *scan* tells."""
        from kinlint.facts.comparison.extraction import RobotParts  # noqa: PLC0415  of pairs alone

        return RobotParts(
            scan,
            self.mechanism,
            self.relations,
            self.placements,
            self.joints,
            self.inertias,
            self.assemblies,
            self.geometries,
        )

    def description_drifts(self, scan: PredicateIndex) -> DescriptionDrifts:
        """Return the comparison of files that describe one robot, by *scan* and other facts."""
        from kinlint.facts.drift import DescriptionDrifts  # noqa: PLC0415  few runs have two formats

        return DescriptionDrifts(self.robot_parts(scan))

    def drift_facts(self) -> Iterator[Triple]:
        """Yield how descriptions of one robot differ, if there can be several."""
        if are_several(self.scan.part("drifts").documents):
            yield from self.drifts.facts()
