"""Alignment of the frames of two descriptions of one rigid group.

Files may draw the frame of a link at different places, and a robot of many files may begin in
another frame. The frames are aligned such that most of what is known of the group agrees: masses'
centres, inertias, joint axes, shapes, and bodies of the same name.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import permutations, product

from kinlint.facts.comparison.described_robot import DescribedRobot, Group, MovingJoint, Shape
from kinlint.facts.comparison.name_matching import first_word
from kinlint.facts.comparison.pose import Pose
from kinlint.facts.comparison.tolerances import EXPORTED
from kinlint.facts.linear_algebra import (
    ZERO,
    Matrix,
    Vector,
    add,
    cross,
    determinant,
    difference,
    dot,
    length,
    scale,
    subtract,
)

NEAR = 0.25
"""Weight of joints that are near each other, beside 1 for one that coincides."""
TURNED = 0.25
"""Evidence that a turn of the whole by right angles needs beyond none."""
HALF = 0.05
"""Distance in m at which a joint is half as near as where it coincides."""
LEVER = 0.2
"""Distance in m that counts as much as a right angle between axes."""
SAME_WORD = 0.2
"""Share that joints count more if their names begin alike."""
MANY = 8
"""Most joints or shapes of a group from whose frames an alignment is tried."""


def total_mass(group: Group) -> float:
    """Return the mass in kg of all bodies of *group*."""
    return sum(body.mass for body in group.bodies if body.mass is not None)


def centre_of_mass(group: Group) -> Vector | None:
    """Return the common centre of mass in m; None if that of a body with a mass is not stated."""
    total, moment = 0.0, ZERO
    for body in group.bodies:
        if body.mass:
            if body.centre is None:
                return None
            total += body.mass
            moment = add(moment, scale(body.mass, body.centre))
    return scale(1.0 / total, moment) if total > 0.0 else None


def line_distance(one: Vector, direction: Vector | None, other: Vector) -> float:
    """Return the distance in m of *other* from a line through *one*, or from *one* itself."""
    apart = subtract(other, one)
    return length(apart) if direction is None else length(cross(apart, direction))


def on_parent(joint: MovingJoint) -> tuple[Vector, Vector | None]:
    """Return the origin of *joint*, and the direction of its axis, as its parent sees them."""
    axis = None if joint.axis is None else joint.transform.along(joint.axis)
    return joint.transform.at(joint.anchor), axis


class Alignment:
    """Alignment of groups of *one* robot with groups of *other*, whose joints may be known.

    *named* are indices of joints of both robots that are taken to be the same.
    """

    def __init__(
        self, one: DescribedRobot, other: DescribedRobot, named: Mapping[int, int]
    ) -> None:
        self.one = one
        self.other = other
        self.named = named

    def pose(self, mine: int, yours: int, guesses: Iterable[Pose], *, searching: bool) -> Pose:
        """Return the pose of the frame of group *yours*, as group *mine* sees it.

        The first of *guesses* with which most agrees counts; if *searching*, those are tried too
        that have two joints coincide.
        """
        given = [(guess, 0.0) for guess in (*guesses, *self._by_bodies(mine, yours))]
        if searching:
            # The joint that a guess was made from is no evidence for it.
            given += [(guess, 1.0) for guess in self._by_joints(mine, yours)]
            given += [(guess, TURNED) for guess in right_angles()]
        found = {
            guess: self._agreement(mine, yours, guess) - assumed
            for guess, assumed in reversed(given)
        }
        order = [guess for guess, _ in given]
        if max(found.values()) < 1.0:
            return max(
                order,
                key=lambda guess: found[guess] + NEAR * self._nearness(mine, yours, guess),
            )
        return max(order, key=found.__getitem__)

    def _by_bodies(self, mine: int, yours: int) -> Iterator[Pose]:
        """Yield the poses that have bodies of the same name coincide."""
        names = {body.name: body for body in self.other.groups[yours].bodies}
        for body in self.one.groups[mine].bodies[:MANY]:
            if body.name in names:
                yield body.pose.of(names[body.name].pose.inverse)

    def _by_joints(self, mine: int, yours: int) -> Iterator[Pose]:
        """Yield the poses that have the frames behind joints of one kind coincide."""
        for index in self.one.around[mine][:MANY]:
            joint = self.one.seen_from(index, mine)
            known = self.named.get(index)
            for candidate in self.other.around[yours][:MANY] if known is None else [known]:
                there = self.other.joints[candidate]
                if yours in (there.parent, there.child) and there.kind == joint.kind:
                    seen = self.other.seen_from(candidate, yours)
                    yield joint.transform.of(seen.transform.inverse)

    def _agreement(self, mine: int, yours: int, guess: Pose) -> float:
        """Return how much of the groups agrees if *guess* is the pose of one for the other."""
        a, b = self.one.groups[mine], self.other.groups[yours]
        found = 0.0
        centres = centre_of_mass(a), centre_of_mass(b)
        if centres[0] is not None and centres[1] is not None:
            found += not EXPORTED.away(centres[0], guess.at(centres[1]))
        if len(a.bodies) == len(b.bodies) == 1:
            tensors = a.bodies[0].tensor, b.bodies[0].tensor
            if tensors[0] is not None and tensors[1] is not None:
                found += not EXPORTED.unlike(tensors[0], guess.tensor(tensors[1]))
        names = {body.name: body for body in b.bodies}
        for body in a.bodies[:MANY]:
            if body.name in names:
                there = guess.of(names[body.name].pose)
                found += 0.5 * coincide(body.pose, there)
        found += self._coinciding_joints(mine, yours, guess)
        return found + _coinciding_shapes(a.shapes[:MANY], b.shapes[:MANY], guess)

    def _nearness(self, mine: int, yours: int, guess: Pose) -> float:
        """Return how near the joints are to the nearest ones, 1 for each that coincides.

        Names that begin with the same word decide between ways that a symmetric robot looks alike.
        """
        found = 0.0
        for index in self.one.around[mine][:MANY]:
            joint = self.one.seen_from(index, mine)
            here, direction = on_parent(joint)
            best = 0.0
            for candidate in self.other.around[yours][:MANY]:
                seen = self.other.seen_from(candidate, yours)
                there, other = on_parent(seen)
                gap = length(subtract(here, guess.at(there)))
                if direction is not None and other is not None:
                    gap += length(cross(direction, guess.along(other))) * LEVER
                near = 1.0 / (1.0 + gap / HALF)
                near += SAME_WORD * (first_word(joint.name) == first_word(seen.name)) * near
                best = max(best, near)
            found += best
        return found

    def _coinciding_joints(self, mine: int, yours: int, guess: Pose) -> float:
        """Return the number of joints whose axes coincide."""
        ways = self.other.around[yours]
        found = 0.0
        for index in self.one.around[mine][:MANY]:
            known = self.named.get(index)
            candidates = ways[:MANY] if known is None else [known] if known in ways else []
            here, direction = on_parent(self.one.seen_from(index, mine))
            for candidate in candidates:
                there, other = on_parent(self.other.seen_from(candidate, yours))
                other = None if other is None else guess.along(other)
                if parallel(direction, other) and (
                    line_distance(here, direction, guess.at(there)) <= EXPORTED.distance
                ):
                    found += 1.0
                    break
        return found


def right_angles() -> Iterator[Pose]:
    """Yield the turns that take axes to axes: files differ in which axis is up, or forward."""
    for order in permutations(range(3)):
        for signs in product((1.0, -1.0), repeat=3):
            rows = [
                tuple(sign * (column == at) for column in range(3))
                for at, sign in zip(order, signs, strict=True)
            ]
            turn: Matrix = (_vector(rows[0]), _vector(rows[1]), _vector(rows[2]))
            if determinant(turn) > 0.0:
                yield Pose(ZERO, turn)


def _vector(row: tuple[float, ...]) -> Vector:
    return row[0], row[1], row[2]


def parallel(one: Vector | None, other: Vector | None) -> bool:
    """Tell whether two unit vectors are parallel, in either sense; two that are not known are."""
    if one is None or other is None:
        return one is other
    return length(cross(one, other)) <= EXPORTED.angle


def coincide(one: Pose, other: Pose) -> bool:
    """Tell whether two poses are the same."""
    if EXPORTED.away(one.point, other.point):
        return False
    return all(length(row) <= EXPORTED.angle for row in difference(one.turn, other.turn))


def _coinciding_shapes(mine: tuple[Shape, ...], yours: tuple[Shape, ...], guess: Pose) -> float:
    """Return a measure of how many shapes of one kind are at the same place."""
    if len(mine) != len(yours) or not mine:
        return 0.0
    agreeing = sum(
        a.kind == b.kind and coincide(a.pose, guess.of(b.pose))
        for a, b in zip(mine, yours, strict=True)
    )
    return agreeing / len(mine)


def tilt(one: Vector, other: Vector) -> float:
    """Return the sine of the angle between two unit vectors, 2 less it beyond a right angle."""
    sine = min(length(cross(one, other)), 1.0)
    return sine if dot(one, other) >= 0.0 else 2.0 - sine
