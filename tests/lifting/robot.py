"""The mechanics of a robot as the domain vocabulary states them, whatever format it came from."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from urllib.parse import unquote

from kinlint.facts.linear_algebra import (
    Matrix,
    Vector,
    add,
    apply,
    product,
    scale,
    subtract,
    transpose,
)
from kinlint.facts.linear_algebra import dot as inner
from kinlint.terms import RDF, RDF_TYPE, Term, Triple, iri, literal_value
from kinlint.vocabulary import KIN, METAMODELS, UNIT

GEOM = f"{METAMODELS}geometry/structural-entities#"
REL = f"{METAMODELS}geometry/spatial-relations#"
COORD = f"{METAMODELS}geometry/coordinates#"
KC = f"{METAMODELS}kinematic-chain/structural-entities#"
BODY = f"{METAMODELS}newtonian-rigid-body-dynamics/structural-entities#"
INERTIA = f"{METAMODELS}newtonian-rigid-body-dynamics/coordinates#"
HAS_UNIT = iri("http://qudt.org/schema/qudt/unit")

IDENTITY: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
ZERO: Vector = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Motion:
    """Where a frame is, seen by another: turned, then moved."""

    turn: Matrix = IDENTITY
    shift: Vector = ZERO

    def then(self, other: Motion) -> Motion:
        return Motion(
            product(self.turn, other.turn), add(self.shift, apply(self.turn, other.shift))
        )

    @property
    def inverse(self) -> Motion:
        back = transpose(self.turn)
        return Motion(back, scale(-1.0, apply(back, self.shift)))


@dataclass(frozen=True)
class Joint:
    """What joins the frames `base` and `rider`; `axis` is seen by `base`."""

    node: Term
    kinds: frozenset[Term]
    base: Term
    rider: Term
    axis: Vector | None

    def motion(self, position: Sequence[float]) -> Motion:
        """From base to rider at *position*, empty for what does not move."""
        if iri(f"{KC}RevoluteJoint") in self.kinds and self.axis:
            return Motion(about(self.axis, position[0]))
        if iri(f"{KIN}PrismaticJoint") in self.kinds and self.axis:
            return Motion(IDENTITY, scale(position[0] / math.hypot(*self.axis), self.axis))
        if iri(f"{KIN}PlanarJoint") in self.kinds:
            return Motion(about((0.0, 0.0, 1.0), position[2]), (position[0], position[1], 0.0))
        if iri(f"{KIN}FloatingJoint") in self.kinds:
            return Motion(quaternion(*position[3:]), (position[0], position[1], position[2]))
        return Motion()


@dataclass(frozen=True)
class Inertia:
    """Mass, centre of mass, and tensor about that centre, the last two seen by one frame."""

    mass: float
    centre: Vector
    tensor: Matrix

    def seen(self, motion: Motion) -> Inertia:
        turned = product(product(motion.turn, self.tensor), transpose(motion.turn))
        return Inertia(self.mass, add(motion.shift, apply(motion.turn, self.centre)), turned)

    def with_(self, other: Inertia) -> Inertia:
        """Both as one rigid body."""
        mass = self.mass + other.mass
        if mass == 0.0:
            return Inertia(0.0, self.centre, summed(self.tensor, other.tensor))
        centre = scale(
            1.0 / mass, add(scale(self.mass, self.centre), scale(other.mass, other.centre))
        )
        return Inertia(mass, centre, summed(self.about(centre), other.about(centre)))

    def about(self, point: Vector) -> Matrix:
        """The tensor about *point*, by the parallel axis theorem."""
        away = subtract(point, self.centre)
        square = inner(away, away)
        rows = [
            [
                self.tensor[i][j] + self.mass * ((square if i == j else 0.0) - away[i] * away[j])
                for j in range(3)
            ]
            for i in range(3)
        ]
        return matrix(rows)


class Robot:
    """What the triples of one robot state."""

    def __init__(self, triples: Iterable[Triple]) -> None:
        self.out: dict[Term, dict[Term, list[Term]]] = defaultdict(lambda: defaultdict(list))
        self.into: dict[Term, dict[Term, list[Term]]] = defaultdict(lambda: defaultdict(list))
        for s, p, o in dict.fromkeys(triples):
            self.out[s][p].append(o)
            self.into[p][o].append(s)

    def key(self, node: Term) -> str:
        """What a body or a joint is called here."""
        return name(node)

    def instances(self, kind: str) -> list[Term]:
        return self.into[RDF_TYPE][iri(kind)]

    def values(self, node: Term, name: str) -> list[Term]:
        return self.out[node][iri(name)]

    def value(self, node: Term, name: str) -> Term:
        (found,) = self.values(node, name)
        return found

    def number(self, node: Term, name: str) -> float:
        return float(literal_value(self.value(node, name)))

    def numbers(self, node: Term, *names: str) -> tuple[float, ...]:
        return tuple(self.number(node, name) for name in names)

    def listed(self, node: Term, name: str) -> Vector:
        items, head = [], self.value(node, name)
        while head != iri(f"{RDF}nil"):
            items.append(self.number(head, f"{RDF}first"))
            head = self.value(head, f"{RDF}rest")
        return vector(items)

    def kinds(self, node: Term) -> frozenset[Term]:
        return frozenset(self.out[node][RDF_TYPE])

    def has_kind(self, node: Term, kind: str) -> bool:
        return iri(kind) in self.out[node][RDF_TYPE]

    def in_unit(self, node: Term, name: str) -> None:
        """Assert that one of the numbers of *node* is in the unit *name*."""
        assert iri(UNIT + name) in self.out[node][HAS_UNIT], node

    @cached_property
    def bodies(self) -> dict[str, Term]:
        """Each body by its name."""
        return {self.key(node): node for node in self.instances(f"{GEOM}RigidBody")}

    @cached_property
    def body_of(self) -> Mapping[Term, Term]:
        """The body of each frame."""
        return {
            part: body
            for body in self.instances(f"{GEOM}SimplicialComplex")
            for part in self.values(body, f"{GEOM}simplices")
        }

    @cached_property
    def poses(self) -> Mapping[Term, tuple[Term, Motion]]:
        """The frame with respect to which each frame has a pose with all numbers, and that pose."""
        found = {}
        for pose in self.instances(f"{REL}Pose"):
            base = self.value(pose, f"{REL}with-respect-to")
            if (motion := self._motion(pose, base)) is not None:
                found[self.value(pose, f"{REL}of")] = base, motion
        return found

    def _motion(self, pose: Term, base: Term) -> Motion | None:
        turns, shifts = [], []
        for node in self.into[iri(f"{COORD}of-pose")][pose]:
            assert self.value(node, f"{COORD}as-seen-by") == base
            if self.has_kind(node, f"{COORD}VectorXYZ"):
                self.in_unit(node, "M")
                shifts.append(self._xyz(node))
            if (turn := self._turn(node)) is not None:
                turns.append(turn)
        return Motion(turns[0], *shifts) if turns and shifts else None

    def _xyz(self, node: Term) -> Vector:
        return vector(self.numbers(node, *(COORD + axis for axis in "xyz")))

    def _turn(self, node: Term) -> Matrix | None:
        if self.has_kind(node, f"{KIN}EulerAngles"):
            assert self.has_kind(node, f"{KIN}Extrinsic")
            assert literal_value(self.value(node, f"{KIN}axes-sequence")) == "xyz"
            angles = self.numbers(node, *(KIN + a for a in ("alpha", "beta", "gamma")))
            if iri(f"{UNIT}DEG") in self.out[node][HAS_UNIT]:
                return roll_pitch_yaw(*map(math.radians, angles))
            self.in_unit(node, "RAD")
            return roll_pitch_yaw(*angles)
        if self.has_kind(node, f"{KIN}Quaternion"):
            return quaternion(*self.numbers(node, *(KIN + a for a in ("qx", "qy", "qz", "qw"))))
        if not self.has_kind(node, f"{COORD}DirectionCosineXYZ"):
            return None
        columns = [self.listed(node, f"{COORD}direction-cosine-{axis}") for axis in "xyz"]
        return transpose(matrix(columns))

    @cached_property
    def joints(self) -> dict[str, Joint]:
        """Each joint with two attachments, by its name."""
        return {
            self.key(node): joint
            for node in self.instances(f"{KC}Joint")
            if (joint := self._joint(node)) is not None
        }

    def _joint(self, node: Term) -> Joint | None:
        attached = self.values(node, f"{KC}between-attachments")
        if len(attached) != 2:
            return None
        base, rider = reversed(attached) if attached[1] in self.poses else attached
        directions = self.values(node, f"{KIN}positive-direction")
        if directions and self._sees(rider, directions[0]):
            base, rider = rider, base
        axis = self._direction(directions[0], base) if directions else None
        return Joint(node, self.kinds(node), base, rider, axis)

    def _sees(self, frame: Term, vector: Term) -> bool:
        """Whether *vector* is of the basis of *frame*, or has its numbers by it."""
        basis = (self.values(frame, f"{GEOM}vector-{axis}") for axis in "xyz")
        return [vector] in basis or self.values(vector, f"{COORD}as-seen-by") == [frame]

    def _direction(self, vector: Term, frame: Term) -> Vector | None:
        """The components of *vector* seen by *frame*, of whose basis it may be."""
        for axis, components in zip("xyz", IDENTITY, strict=True):
            if self.values(frame, f"{GEOM}vector-{axis}") == [vector]:
                return components
        if not self.values(vector, f"{COORD}x"):
            return None
        assert self.value(vector, f"{COORD}as-seen-by") == frame
        return self._xyz(vector)

    def places(self, root: Term, positions: Mapping[str, Sequence[float]]) -> dict[Term, Motion]:
        """Where each frame is, seen by frame *root*, at *positions* of the joints by name."""
        steps: dict[Term, list[tuple[Term, Motion]]] = defaultdict(list)
        for frame, (base, motion) in self.poses.items():
            steps[base].append((frame, motion))
            steps[frame].append((base, motion.inverse))
        for key, joint in self.joints.items():
            motion = joint.motion(positions.get(key, (0.0,) * 6 + (1.0,)))
            steps[joint.base].append((joint.rider, motion))
            steps[joint.rider].append((joint.base, motion.inverse))
        found, waiting = {root: Motion()}, [root]
        while waiting:
            frame = waiting.pop()
            for other, motion in steps[frame]:
                if other not in found:
                    found[other] = found[frame].then(motion)
                    waiting.append(other)
        return found

    @cached_property
    def inertias(self) -> dict[str, Inertia]:
        """The inertia of each body by name, seen by the frame that its frames are posed by."""
        return dict(self._inertias())

    def _inertias(self) -> Iterator[tuple[str, Inertia]]:
        centres = self._centres
        for node in self.instances(f"{BODY}RigidBodyInertia"):
            of = self.into[iri(f"{INERTIA}of-inertia")][node]
            masses = [each for each in of if self.has_kind(each, f"{INERTIA}MassScalar")]
            tensors = [each for each in of if self.has_kind(each, f"{INERTIA}MomentOfInertiaXYZ")]
            if not masses:
                continue
            self.in_unit(masses[0], "KiloGM")
            seen_by = self.value(masses[0], f"{INERTIA}as-seen-by")
            assert all(self.value(each, f"{INERTIA}as-seen-by") == seen_by for each in tensors)
            turn = self.poses[seen_by][1].turn if seen_by in self.poses else IDENTITY
            tensor = self._tensor(tensors[0]) if tensors else (ZERO, ZERO, ZERO)
            own = Inertia(self.number(masses[0], f"{INERTIA}mass"), ZERO, tensor)
            centre = centres.get(self.value(node, f"{BODY}about"), ZERO)
            yield self.key(self.value(node, f"{BODY}of-body")), own.seen(Motion(turn, centre))

    def _tensor(self, node: Term) -> Matrix:
        self.in_unit(node, "KiloGM-M2")
        names = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
        xx, yy, zz, xy, xz, yz = self.numbers(node, *(INERTIA + each for each in names))
        return ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))

    @cached_property
    def _centres(self) -> Mapping[Term, Vector]:
        """Where points other than the origins of bodies are: by a position, or with a frame."""
        found = {}
        for relation in self.instances(f"{REL}Position"):
            for node in self.into[iri(f"{COORD}of-position")][relation]:
                self.in_unit(node, "M")
                found[self.value(relation, f"{REL}of")] = self._xyz(node)
        for frame, (_, motion) in self.poses.items():
            for origin in self.values(frame, f"{GEOM}origin"):
                found[origin] = motion.shift
        return found


def name(node: Term) -> str:
    """The part of an IRI by which its author knows it."""
    return unquote(node[1:-1].rpartition("#")[2].rpartition("/")[2])


def vector(values: Sequence[float]) -> Vector:
    x, y, z = values
    return x, y, z


def matrix(rows: Sequence[Sequence[float]]) -> Matrix:
    first, second, third = map(vector, rows)
    return first, second, third


def summed(one: Matrix, other: Matrix) -> Matrix:
    return matrix([add(a, b) for a, b in zip(one, other, strict=True)])


def roll_pitch_yaw(roll: float, pitch: float, yaw: float) -> Matrix:
    """Turns about fixed x, then y, then z."""
    x, y, z = IDENTITY
    return product(about(z, yaw), product(about(y, pitch), about(x, roll)))


def about(axis: Vector, angle: float) -> Matrix:
    """A turn by *angle* about *axis*, of any length but zero."""
    length = math.hypot(*axis)
    half = math.sin(angle / 2.0) / length if length else 0.0
    return quaternion(*scale(half, axis), math.cos(angle / 2.0))


def quaternion(x: float, y: float, z: float, w: float) -> Matrix:
    norm = math.hypot(x, y, z, w)
    x, y, z, w = (each / norm for each in (x, y, z, w))
    return (
        (1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)),
        (2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)),
        (2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)),
    )
