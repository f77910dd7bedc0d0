"""Bodies that fixed joints weld into one, and the mass of the whole."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cached_property

from kinlint.facts.connected_components import joined_by
from kinlint.facts.coordinate_pairs import CoordinatePairs
from kinlint.facts.fact_statements import fact, numbers
from kinlint.facts.inertia import Inertias
from kinlint.facts.link_trees import LinkTrees
from kinlint.facts.metamodel_terms import kin
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.spanning_forest import DisjointSets
from kinlint.terms import Term, Triple

FIXED = kin("FixedJoint")
MOVING = frozenset({"revolute", "continuous", "prismatic", "floating", "planar"})
MASS_PROPERTY = kin("MassProperty")


class Assemblies:
    """Groups of bodies that no joint moves against each other, by union-find over fixed joints."""

    def __init__(self, scan: PredicateIndex, inertias: Inertias, trees: LinkTrees) -> None:
        self.scan = scan
        self.inertias = inertias
        self.trees = trees
        self.companions = CoordinatePairs(scan)

    @cached_property
    def _welded(self) -> DisjointSets:
        groups = DisjointSets()
        for joint in self.scan.instances(FIXED):
            bodies = joined_by(self.scan, joint)
            for body in bodies[1:]:
                groups.join(bodies[0], body)
        return groups

    def assembly(self, body: Term) -> Term:
        """Return the body that stands for all that *body* is welded to."""
        return self._welded.representative(body)

    def body(self, node: Term) -> Term | None:
        """Return the body that a node with a mass or an inertia is about.

        None if it is not stated.
        """
        return self.companions.bodies.get(self.companions.relations.get(node, node))

    def weighed(self, node: Term) -> tuple[Term, float] | None:
        """Return the body that *node* is about and its mass in kg; None unless that is positive."""
        body = self.body(node)
        mass = self.masses.get(body, 0.0) if body is not None else 0.0
        return (body, mass) if body is not None and mass > 0.0 else None

    @cached_property
    def masses(self) -> Mapping[Term, float]:
        """The mass in kg of each body, the largest where several are stated."""
        found: dict[Term, float] = {}
        for node, mass in self.inertias.quantities.masses.items():
            body = self.body(node)
            if body is not None:
                found[body] = max(mass, found.get(body, mass))
        return found

    @cached_property
    def totals(self) -> Mapping[Term, float]:
        """The mass of each assembly; what is stated as negative counts as nothing."""
        found: dict[Term, float] = {}
        for body, mass in self.masses.items():
            whole = self.assembly(body)
            found[whole] = found.get(whole, 0.0) + max(mass, 0.0)
        return found

    @cached_property
    def _still(self) -> frozenset[Term]:
        """The assemblies that hold the root of a tree: nothing in the file moves them."""
        return frozenset(map(self.assembly, self.trees.bases))

    @cached_property
    def _weighed(self) -> frozenset[Term]:
        """The assemblies of which anything is stated that resists acceleration."""
        bodies = self.scan.single(kin("of-body"))
        stated = self.scan.instances(MASS_PROPERTY)
        return frozenset(self.assembly(bodies[node]) for node in stated if node in bodies)

    def facts(self) -> Iterator[Triple]:
        """Yield what each stated mass is welded to, and the moving bodies without any inertia."""
        stating = {*self.inertias.quantities.masses, *self.inertias.tensors}
        for node in sorted(stating):
            body = self.body(node)
            if body is None:
                continue
            whole = self.assembly(body)
            others = self.totals.get(whole, 0.0) - max(self.masses.get(body, 0.0), 0.0)
            if others > 0.0:
                yield from numbers(node, [("welded-mass", others)])
            elif whole in self._still:
                yield node, fact("rests-on"), whole
        yield from self._bare()

    def _bare(self) -> Iterator[Triple]:
        """Yield the bodies that a joint moves, where nothing welded to them has an inertia."""
        excused = self._weighed | self._still
        for body, edge in self.trees.above.items():
            kind = self.trees.mechanism.kind(edge.joint)
            if kind in MOVING and self.assembly(body) not in excused:
                yield body, fact("moved-by"), edge.joint
