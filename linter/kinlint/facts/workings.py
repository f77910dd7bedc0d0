"""What computes facts from a model, each part made when it is first asked for."""

from __future__ import annotations

from functools import cached_property

from kinlint.facts.agreement import Agreements
from kinlint.facts.amendment import Amendments
from kinlint.facts.assembly import Assemblies
from kinlint.facts.attitude import Attitudes
from kinlint.facts.basis import Bases
from kinlint.facts.drift import Drifts
from kinlint.facts.geometry import Geometries
from kinlint.facts.identifier import Identifiers
from kinlint.facts.inertia import Inertias
from kinlint.facts.likeness import Twins
from kinlint.facts.mechanism import Mechanism
from kinlint.facts.planning import Planning
from kinlint.facts.quantity import Quantities
from kinlint.facts.relation import Relations
from kinlint.facts.rotation import Rotations
from kinlint.facts.scan import Scan
from kinlint.facts.tree import Trees
from kinlint.facts.units import Units


class Workings:
    """The parts that facts are computed by; they share what they have found out.

    Each is called after what it knows and reads the model by a scan that is its own
    (`Scan.part`), so that somebody may know what it has looked at.
    """

    def __init__(self, scan: Scan) -> None:
        self.scan = scan

    @cached_property
    def units(self) -> Units:
        """The units that nodes name."""
        return Units(self.scan.part("units"))

    @cached_property
    def vectors(self) -> Quantities:
        """Vectors in SI units."""
        return Quantities(self.scan.part("vectors", "units"), self.units)

    @cached_property
    def angles(self) -> Quantities:
        """Angles in rad."""
        return Quantities(self.scan.part("angles", "units"), self.units)

    @cached_property
    def masses(self) -> Quantities:
        """Masses in kg."""
        return Quantities(self.scan.part("masses", "units"), self.units)

    @cached_property
    def values(self) -> Quantities:
        """Other numbers in SI units."""
        return Quantities(self.scan.part("values", "units"), self.units)

    @cached_property
    def rotations(self) -> Rotations:
        """Rotations, and how far they are none."""
        return Rotations(self.scan.part("rotations", "angles"), self.angles)

    @cached_property
    def bases(self) -> Bases:
        """Frames that are drawn by vectors."""
        return Bases(self.scan.part("bases", "vectors"), self.vectors)

    @cached_property
    def inertias(self) -> Inertias:
        """Masses and moments."""
        below = "units", "masses"
        return Inertias(self.scan.part("inertias", *below), self.units, self.masses)

    @cached_property
    def relations(self) -> Relations:
        """Spatial relations with numbers."""
        below = "vectors", "rotations"
        return Relations(self.scan.part("relations", *below), self.vectors, self.rotations)

    @cached_property
    def attitudes(self) -> Attitudes:
        """Chains of orientations."""
        self.scan.part("attitudes", "relations")
        return Attitudes(self.relations.turns)

    @cached_property
    def agreements(self) -> Agreements:
        """Coordinates that say the same, or should."""
        self.scan.part("agreements", "relations", "attitudes", "inertias")
        return Agreements(self.relations, self.attitudes, self.inertias)

    @cached_property
    def mechanism(self) -> Mechanism:
        """Bodies and joints."""
        return Mechanism(self.scan.part("mechanism"))

    @cached_property
    def trees(self) -> Trees:
        """The links and joints of files that tell parent from child."""
        return Trees(self.scan.part("trees", "mechanism"), self.mechanism)

    @cached_property
    def assemblies(self) -> Assemblies:
        """Bodies that are fixed to each other."""
        below = "inertias", "trees"
        return Assemblies(self.scan.part("assemblies", *below), self.inertias, self.trees)

    @cached_property
    def geometries(self) -> Geometries:
        """The shapes of bodies."""
        return Geometries(self.scan.part("geometries", "units"), self.units)

    @cached_property
    def amendments(self) -> Amendments:
        """What wrong inertias may have been meant to be."""
        below = "inertias", "assemblies", "geometries"
        scan = self.scan.part("amendments", *below)
        return Amendments(scan, self.inertias, self.assemblies, self.geometries)

    @cached_property
    def twins(self) -> Twins:
        """Parts that mirror each other."""
        return Twins(self.scan.part("twins", "assemblies"), self.assemblies)

    @cached_property
    def drifts(self) -> Drifts:
        """Files that describe one robot differently."""
        return Drifts(self.scan.part("drifts", "assemblies"), self.assemblies)

    @cached_property
    def planning(self) -> Planning:
        """The groups of SRDF files."""
        return Planning(self.scan.part("planning", "trees"), self.trees)

    @cached_property
    def identifiers(self) -> Identifiers:
        """What the files call things."""
        return Identifiers(self.scan.part("identifiers"))
