"""Poses, axes, limits and couplings of joints as numbers in SI units."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import NamedTuple

from kinlint.facts.frame_placement import Placements
from kinlint.facts.joint_trees import Edge
from kinlint.facts.linear_algebra import Matrix, Vector
from kinlint.facts.mechanism import Mechanism
from kinlint.facts.metamodel_terms import attribute, geom, inherited, kin
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.facts.quantity import ANGLES, Quantities
from kinlint.facts.rotation import LOCKED
from kinlint.structure import Origin
from kinlint.terms import Term, iri, literal, literal_value
from kinlint.vocabulary import SRC

LEADER, FOLLOWER, MULTIPLIER, OFFSET = map(kin, ("leader", "follower", "multiplier", "offset"))
DIRECTION, RATIO = kin("positive-direction"), kin("gear-ratio")
TOGETHER, INHERITED_TOGETHER = attribute("actuatorfrcrange-2"), inherited("actuatorfrcrange-2")
LIMITED, FROM = attribute("actuatorfrclimited"), iri(f"{SRC}from")
UNGEARED: Mapping[Term, float] = {}
SEQUENCE = kin("axes-sequence")
BASIS = tuple(geom(f"vector-{axis}") for axis in "xyz")
UNITS: tuple[Vector, ...] = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
NEEDED = (LEADER, FOLLOWER, MULTIPLIER, OFFSET, DIRECTION, RATIO, *BASIS, TOGETHER)
"""Properties that these numbers are computed from, besides placements and ranges."""


class Gearing(NamedTuple):
    """Linear dependency of the position of one joint on that of another."""

    node: Term
    """Coupling itself."""
    leader: Term
    """Joint that is followed."""
    multiplier: float | None
    """Factor of the position of the leader."""
    offset: float | None
    """Position in rad or m that is added."""


class JointNumbers:
    """Numbers of a closed model in SI units, by joint."""

    def __init__(
        self,
        scan: PredicateIndex,
        quantities: Quantities,
        mechanism: Mechanism,
        placements: Placements,
    ) -> None:
        self.scan = scan
        self.quantities = quantities
        self.mechanism = mechanism
        self.placements = placements

    def origin(self, edge: Edge) -> Origin | None:
        """Return the pose of a joint on its parent, if one relation to a frame there states it."""
        if edge.parent is None or (near := self.mechanism.near(edge.joint, edge.parent)) is None:
            return None
        at = self.placements.placement(near, self.mechanism.on(edge.parent))
        if at is None:
            return None
        rpy = self._written(at.turn_from) or (roll_pitch_yaw(at.turn) if at.turn else None)
        return Origin(at.point, rpy)

    def _written(self, node: Term | None) -> Vector | None:
        """Return the angles of *node* as they are written, if they are roll, pitch and yaw."""
        alpha, beta, gamma = (self.quantities.angles[name].get(node or "") for _, name in ANGLES)
        if alpha is None or beta is None or gamma is None or node not in self._extrinsic:
            return None
        sequence = self.scan.single(SEQUENCE).get(node)
        return (alpha, beta, gamma) if sequence == literal("xyz") else None

    @cached_property
    def _extrinsic(self) -> frozenset[Term]:
        return self.scan.instances(kin("Extrinsic"))

    def axis(self, joint: Term) -> Vector | None:
        """Return the unit vector in which, or about which, a joint moves, in its own frame."""
        if (written := self.placements.axes.get(joint)) is not None:
            return written
        direction = self.scan.single(DIRECTION).get(joint)
        for frame in self.mechanism.attachments(joint):
            for basis, unit in zip(BASIS, UNITS, strict=True):
                if direction is not None and self.scan.single(basis).get(frame) == direction:
                    return unit
        return None

    @cached_property
    def ranges(self) -> Mapping[Term, Term]:
        """The first node that limits the position of each joint."""
        known = self.scan.instances(kin("JointPositionLimit"))
        found: dict[Term, Term] = {}
        for node, joint in self.scan.single(kin("of-joint")).items():
            if node in known:
                found.setdefault(joint, node)
        return found

    @cached_property
    def limits(self) -> Mapping[Term, tuple[float | None, float | None]]:
        """The least and the greatest position of each joint, in rad or m."""
        lower, upper = (self.scan.numbers(kin(name)) for name in ("lower", "upper"))
        return {
            joint: (self._si(node, lower), self._si(node, upper))
            for joint, node in self.ranges.items()
        }

    @cached_property
    def efforts(self) -> Mapping[Term, float]:
        """The greatest force in N, or torque in N m, of the one actuator of each joint.

        That is behind the gear, so at the joint. A joint of MJCF may limit what actuators exert
        together.
        """
        found = dict(self._bounds("ActuatorForceLimit", self.scan.numbers(RATIO)))
        limited, elements = self.scan.single(LIMITED), self.scan.single(FROM)
        for table in map(self.scan.numbers, (TOGETHER, INHERITED_TOGETHER)):
            for joint in self.mechanism.joints if table else ():
                element = elements.get(joint, "")
                if element in table and literal_value(limited.get(element, '""')) != "false":
                    found[joint] = min(found.get(joint, math.inf), table[element])
        return found

    @cached_property
    def speeds(self) -> Mapping[Term, float]:
        """The greatest speed in m/s or rad/s of the one actuator of each joint."""
        return self._bounds("ActuatorVelocityLimit")

    def _bounds(self, kind: str, ratios: Mapping[Term, float] = UNGEARED) -> Mapping[Term, float]:
        known, upper = self.scan.instances(kin(kind)), self.scan.numbers(kin("upper"))
        actuated = self.scan.single(kin("actuates"))
        found: dict[Term, list[float]] = {}
        for node, actuator in self.scan.single(kin("of-actuator")).items():
            bound = self._si(node, upper) if node in known else None
            if bound is not None and actuator in actuated:
                geared = bound * abs(ratios.get(actuator, 1.0))
                found.setdefault(actuated[actuator], []).append(geared)
        return {joint: bounds[0] for joint, bounds in found.items() if len(bounds) == 1}

    @cached_property
    def gearings(self) -> Mapping[Term, Sequence[Gearing]]:
        """Mimics, gears and other couplings, by the joint that follows."""
        multipliers, offsets = self.scan.numbers(MULTIPLIER), self.scan.numbers(OFFSET)
        found: dict[Term, list[Gearing]] = {}
        for node, joints in sorted(self.scan.table(FOLLOWER).items()):
            offset, multiplier = self._si(node, offsets), multipliers.get(node)
            for leader in self.scan.table(LEADER).values(node):
                for joint in joints:
                    found.setdefault(joint, []).append(Gearing(node, leader, multiplier, offset))
        return found

    def _si(self, node: Term, numbers: Mapping[Term, float]) -> float | None:
        """Return the number of *node* among *numbers* in SI units.

        None where the unit is not known.
        """
        unit, number = self.quantities.units.only(node), numbers.get(node)
        return unit.si(number) if unit is not None and number is not None else None


def roll_pitch_yaw(turn: Matrix) -> Vector:
    """Return the angles in rad about the fixed axes x, y and z, in this order, that make *turn*.

    These are the rpy of URDF and SDF (REP 103). In gimbal lock, where only the sum or difference of
    roll and yaw is known, roll is zero.
    """
    (a, b, _), (d, e, _), (g, h, i) = turn
    across = math.hypot(a, d)
    pitch = math.atan2(-g, across)
    if across < LOCKED:
        return 0.0, pitch, math.atan2(-b, e)
    return math.atan2(h, i), pitch, math.atan2(d, a)
