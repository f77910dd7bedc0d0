"""Frames that meet at joints, and the rotation between them while the joints are at zero."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import NamedTuple

from kinlint.facts.joint_numbers import BASIS, UNITS
from kinlint.facts.joint_trees import Edge
from kinlint.facts.linear_algebra import (
    IDENTITY,
    Matrix,
    Vector,
    cross,
    dot,
    length,
    product,
    scale,
    transpose,
)
from kinlint.facts.mechanism import Mechanism
from kinlint.facts.metamodel_terms import chain, kin, rel
from kinlint.facts.rotation import columns
from kinlint.terms import Term

COINCIDENT, OF_JOINT = kin("coincidence-of"), kin("of-joint")
COMMON_AXIS, LINES = chain("common-axis"), rel("lines")
PARALLEL = 1e-6
"""Sine below which two unit vectors are parallel."""


class Meeting(NamedTuple):
    """Two frames that meet at a joint, with the rotation between them at zero."""

    joint: Term
    """Joint itself."""
    near: Term
    """Frame on the parent, or a point."""
    far: Term
    """Frame on the child, or a point."""
    turn: Matrix
    """Rotation from components along the axes of `far` to those along `near`."""


class JointMeetings:
    """Frames that meet at the joints of a model."""

    def __init__(self, mechanism: Mechanism, edges: Sequence[Edge]) -> None:
        self.scan = mechanism.scan
        self.mechanism = mechanism
        self.edges = edges

    @cached_property
    def all(self) -> Sequence[Meeting]:
        """Frames that meet at each joint; those that close loops come last."""
        return [meeting for edge in self.edges for meeting in self._met(edge)]

    def _met(self, edge: Edge) -> Iterator[Meeting]:
        if edge.parent is None or (near := self.mechanism.near(edge.joint, edge.parent)) is None:
            return
        for body in (edge.child, *edge.others):
            far = self.mechanism.near(edge.joint, body) if body is not None else None
            if far is not None and far != near:
                yield Meeting(edge.joint, near, far, self._turn(edge.joint, near, far))

    def _turn(self, joint: Term, near: Term, far: Term) -> Matrix:
        """Return the rotation by which the vectors that coincide do so; none if none are told."""
        pairs: list[tuple[Vector, Vector]] = []
        told = (self.scan.table(COINCIDENT).values(each) for each in self._zeros.get(joint, ()))
        for both in (self.lines(joint), *told):
            own = [self.basis[each] for each in both if each in self.basis]
            ends = [[unit for frame, unit in own if frame == end] for end in (near, far)]
            pairs += zip(*ends, strict=True) if len(ends[0]) == len(ends[1]) == 1 else ()
        return rotation_of(pairs)

    def lines(self, joint: Term) -> Sequence[Term]:
        """Return the vectors along the common axis of *joint*."""
        return self.scan.table(LINES).values(self.scan.single(COMMON_AXIS).get(joint, ""))

    @cached_property
    def _zeros(self) -> Mapping[Term, Sequence[Term]]:
        found: dict[Term, list[Term]] = {}
        for node in sorted(subject for subject, _ in self.scan.table(COINCIDENT).items()):
            for joint in self.scan.table(OF_JOINT).values(node):
                found.setdefault(joint, []).append(node)
        return found

    @cached_property
    def basis(self) -> Mapping[Term, tuple[Term, Vector]]:
        """Frame of each basis vector, with its components there."""
        return {
            vector: (frame, unit)
            for basis, unit in zip(BASIS, UNITS, strict=True)
            for frame, vector in self.scan.single(basis).items()
        }


def rotation_of(pairs: Sequence[tuple[Vector, Vector]]) -> Matrix:
    """Return a rotation that takes the second unit vector of each pair to the first.

    As far as one does, by the TRIAD method (Shuster and Oh, Three-axis attitude determination from
    vector observations, 1981); of those that one pair leaves open, one by at most half a turn.
    """
    if not pairs or all(one == other for one, other in pairs):
        return IDENTITY
    one, other = pairs[0]
    for first, second in pairs[1:]:
        if length(cross(one, first)) > PARALLEL and length(cross(other, second)) > PARALLEL:
            return product(_triad(one, first), transpose(_triad(other, second)))
    beside = cross(other, one)
    if length(beside) < PARALLEL:
        if dot(one, other) > 0.0:
            return IDENTITY
        beside = min((cross(one, unit) for unit in UNITS), key=lambda each: -length(each))
    return product(_triad(one, beside), transpose(_triad(other, beside)))


def _triad(one: Vector, other: Vector) -> Matrix:
    """Return the axes that two vectors make: the first, and the one perpendicular to both."""
    across = cross(one, other)
    across = scale(1.0 / length(across), across)
    return columns(one, across, cross(one, across))
