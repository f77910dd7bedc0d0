"""Poses, axes and limits of joints as numbers in SI units."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cached_property

from kinlint.facts.frame_placement import Placements
from kinlint.facts.inputs import RANGES, RELATIONS
from kinlint.facts.joint_trees import Edge
from kinlint.facts.linear_algebra import Matrix, Vector
from kinlint.facts.mechanism import Mechanism
from kinlint.facts.metamodel_terms import geom, kin
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.quantity import Quantities
from kinlint.facts.rotation import LOCKED, Rotations
from kinlint.facts.spatial_relations import RelativeOrientation, RelativePosition, SpatialRelations
from kinlint.facts.units import Units
from kinlint.structure import Origin
from kinlint.terms import Term, literal

DIRECTION = kin("positive-direction")
SEQUENCE = kin("axes-sequence")
BASIS = tuple(geom(f"vector-{axis}") for axis in "xyz")
UNITS: tuple[Vector, ...] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
NEEDED = (*RELATIONS, *RANGES, DIRECTION, *BASIS)
"""Properties and classes that these numbers are computed from."""


class JointNumbers:
    """Numbers of a closed model in SI units, by joint."""

    def __init__(self, scan: PredicateIndex, mechanism: Mechanism) -> None:
        self.scan = scan
        self.mechanism = mechanism
        self.units = Units(scan)
        quantities = Quantities(scan, self.units)
        self.angles = tuple(quantities.angles[name] for name in ("alpha", "beta", "gamma"))
        self.relations = SpatialRelations(scan, quantities, Rotations(scan, quantities))

    @cached_property
    def _shifts(self) -> Mapping[Term, list[RelativePosition]]:
        found: dict[Term, list[RelativePosition]] = {}
        for each in self.relations.shifts:
            found.setdefault(each.of, []).append(each)
        return found

    @cached_property
    def _turns(self) -> Mapping[Term, list[RelativeOrientation]]:
        found: dict[Term, list[RelativeOrientation]] = {}
        for each in self.relations.turns:
            found.setdefault(each.of, []).append(each)
        return found

    def origin(self, edge: Edge) -> Origin | None:
        """Return the pose of a joint on its parent, if one relation to a frame there states it."""
        near = self.mechanism.near(edge.joint, edge.parent) if edge.parent else None
        if near is None:
            return None
        carrier = self.mechanism.carrier
        xyz = next(
            (
                each.vector
                for each in self._shifts.get(self.relations.point(near), ())
                if carrier.get(self.relations.base[each.relation]) == edge.parent
                and carrier.get(each.seen_by) == edge.parent
            ),
            None,
        )
        rpy = next(
            (
                self._written(each.source) or roll_pitch_yaw(each.matrix)
                for each in self._turns.get(self.relations.axes(near), ())
                if carrier.get(each.base) == edge.parent
            ),
            None,
        )
        return Origin(xyz, rpy) if xyz is not None or rpy is not None else None

    def _written(self, node: Term) -> Vector | None:
        """Return the angles of *node* as they are written, if they are roll, pitch and yaw."""
        alpha, beta, gamma = (angles.get(node) for angles in self.angles)
        if alpha is None or beta is None or gamma is None or node not in self._extrinsic:
            return None
        sequence = self.scan.single(SEQUENCE).get(node)
        return (alpha, beta, gamma) if sequence == literal("xyz") else None

    @cached_property
    def _extrinsic(self) -> frozenset[Term]:
        return self.scan.instances(kin("Extrinsic"))

    def axis(self, joint: Term) -> Vector | None:
        """Return the unit vector in which, or about which, a joint moves, in its own frame."""
        if (written := self._placements.axes.get(joint)) is not None:
            return written
        direction = self.scan.single(DIRECTION).get(joint)
        for frame in self.mechanism.attachments(joint):
            for basis, unit in zip(BASIS, UNITS, strict=True):
                if direction is not None and self.scan.single(basis).get(frame) == direction:
                    return unit
        return None

    @cached_property
    def _placements(self) -> Placements:
        return Placements(self.scan)

    def limits(self, joint: Term) -> tuple[float | None, float | None]:
        """Return the least and the greatest position of a joint, in rad or m."""
        return self._limits.get(joint, (None, None))

    @cached_property
    def _limits(self) -> Mapping[Term, tuple[float | None, float | None]]:
        ranges = self.scan.instances(kin("JointPositionLimit"))
        lower, upper = (self.scan.numbers(kin(name)) for name in ("lower", "upper"))
        found: dict[Term, tuple[float | None, float | None]] = {}
        for node, joint in self.scan.single(kin("of-joint")).items():
            if node in ranges and joint not in found:
                found[joint] = self.si(node, lower), self.si(node, upper)
        return found

    def si(self, node: Term, numbers: Mapping[Term, float]) -> float | None:
        """Return the number of *node* among *numbers* in SI units.

        None where the unit is not known.
        """
        unit, number = self.units.only(node), numbers.get(node)
        return unit.si(number) if unit is not None and number is not None else None


def roll_pitch_yaw(turn: Matrix) -> Vector:
    """Return the angles in rad about the fixed axes x, y and z, in this order, that make *turn*.

    These are the rpy of URDF and SDF (REP-103). In gimbal lock, where only the sum or difference of
    roll and yaw is known, roll is zero.
    """
    (a, b, _), (d, e, _), (g, h, i) = turn
    across = math.hypot(a, d)
    pitch = math.atan2(-g, across)
    if across < LOCKED:
        return 0.0, pitch, math.atan2(-b, e)
    return math.atan2(h, i), pitch, math.atan2(d, a)
