"""Differences of the masses, centres of mass and inertias of rigid groups that correspond."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.facts.comparison.described_robot import Body, Group
from kinlint.facts.comparison.frame_alignment import centre_of_mass, total_mass
from kinlint.facts.comparison.measured import Measured, Parts
from kinlint.facts.comparison.pose import HERE, Pose
from kinlint.facts.comparison.tolerances import Tolerances
from kinlint.facts.inertia import about_origin
from kinlint.facts.linear_algebra import ZERO, Matrix, Vector, add, scale, subtract
from kinlint.light_dataclasses import replace

NOTHING: Matrix = (ZERO, ZERO, ZERO)
FEW = 64
"""Most bodies of a group that are compared one by one."""


def mass_differences(
    here: Group, there: Group, pose: Pose, tolerances: Tolerances
) -> Iterator[Measured]:
    """Yield what is measured of the masses of two groups, of which *here* sees *there* at *pose*.

    Bodies that are welded to each other count together: converters lump links behind fixed joints
    into one. Where the groups differ as a whole, bodies of the same name are compared one by one.
    """
    there = Group(tuple(_seen(body, pose) for body in there.bodies))
    wholes = list(_whole(here, there, tolerances))
    if not any(each.differs for each in wholes):
        yield from wholes
        return
    pairs = list(_pairs(here, there, tolerances))
    if not pairs:
        yield from _lumped(here, there, wholes, tolerances)
    for one, other in pairs:
        yield from _least(one, other, tolerances)


def _pairs(here: Group, there: Group, tolerances: Tolerances) -> Iterator[tuple[Body, Body]]:
    """Yield the bodies that are the same, if each with a mass has its counterpart.

    By name, or as the ones that are left where the others agree.
    """
    mine, yours = (
        [each for each in group.bodies if each.mass is not None] for group in (here, there)
    )
    names = {body.name: body for body in yours}
    if len(mine) != len(yours) or len(mine) > FEW:
        return
    if all(body.name in names for body in mine):
        yield from ((body, names[body.name]) for body in mine)
        return
    left, done = [], []
    for body in mine:
        same = next((each for each in yours if _agree(body, each, tolerances)), None)
        if same is None:
            left.append(body)
        else:
            yours.remove(same)
            done.append((body, same))
    if len(left) == 1:
        yield from (*done, (left[0], yours[0]))


def _agree(one: Body, other: Body, tolerances: Tolerances) -> bool:
    return not any(each.differs for each in _bodies(one, other, tolerances))


def _least(one: Body, other: Body, tolerances: Tolerances) -> Iterator[Measured]:
    """Yield what is measured of two bodies as their groups see them.

    Or as they do themselves, if less differs: a body may have been put elsewhere as a whole.
    """
    alike = _seen(other, one.pose.of(other.pose.inverse))
    tries = [list(_bodies(one, each, tolerances)) for each in (other, alike)]
    yield from min(tries, key=lambda each: sum(one.differs for one in each))


def _seen(body: Body, pose: Pose) -> Body:
    """Return *body* as an observer sees it that sees the frame of its group at *pose*."""
    if pose == HERE:
        return body
    return replace(
        body,
        pose=pose.of(body.pose),
        centre=None if body.centre is None else pose.at(body.centre),
        tensor=None if body.tensor is None else pose.tensor(body.tensor),
    )


def lumped(bodies: Sequence[Body]) -> Body | None:
    """Return one body that moves as *bodies* that are welded together do.

    Its tensor is the sum of theirs about the common centre of mass (Huygens and Steiner); None if
    one that has a mass has no tensor. Returns None where no mass is stated.
    """
    heavy = [body for body in bodies if body.mass is not None]
    if not heavy:
        return None
    if len(heavy) == 1:
        return heavy[0]
    whole = Group(tuple(heavy))
    centre, tensor = centre_of_mass(whole), NOTHING
    for body in heavy:
        if centre is None or body.centre is None or body.tensor is None:
            return replace(heavy[0], mass=total_mass(whole), centre=centre, tensor=None)
        shifted = about_origin(body.mass or 0.0, subtract(body.centre, centre))
        tensor = _sum(tensor, _sum(body.tensor, shifted))
    return replace(heavy[0], mass=total_mass(whole), centre=centre, tensor=tensor)


def _sum(one: Matrix, other: Matrix) -> Matrix:
    a, b, c = (add(*rows) for rows in zip(one, other, strict=True))
    return a, b, c


def _whole(here: Group, there: Group, tolerances: Tolerances) -> Iterator[Measured]:
    one, other = lumped(here.bodies), lumped(there.bodies)
    if one is not None and other is not None:
        yield from _bodies(one, other, tolerances)


def _bodies(one: Body, other: Body, tolerances: Tolerances) -> Iterator[Measured]:
    """Yield mass, centre of mass and inertia of two bodies that are seen alike."""
    sides = (one.inertia_node or one.node, other.inertia_node or other.node)
    parts = Parts(one.name, other.name, one.node, other.node, tolerances, sides, "mass")
    weighed = replace(parts, sides=(one.mass_node or sides[0], other.mass_node or sides[1]))
    yield weighed.number("mass", "kg", one.mass or 0.0, other.mass or 0.0)
    if one.mass or other.mass:
        yield from parts.point("centre of mass", one.centre, other.centre)
    if one.tensor is not None and other.tensor is not None:
        differs = tolerances.unlike(one.tensor, other.tensor)
        moments = (_moments(one.tensor), _moments(other.tensor))
        products = (_products(one.tensor), _products(other.tensor))
        which, (a, b) = (
            ("moments", moments)
            if _apart(moments) >= _apart(products)
            else (
                "products",
                products,
            )
        )
        yield parts.measured(f"{which} of inertia", "kg m²", a, b, differs=differs)


def _moments(tensor: Matrix) -> Vector:
    return tensor[0][0], tensor[1][1], tensor[2][2]


def _products(tensor: Matrix) -> Vector:
    return tensor[0][1], tensor[0][2], tensor[1][2]


def _apart(pair: tuple[Vector, Vector]) -> float:
    return max(abs(a - b) for a, b in zip(*pair, strict=True))


def _lumped(
    here: Group, there: Group, wholes: Sequence[Measured], tolerances: Tolerances
) -> Iterator[Measured]:
    """Yield the one value of a body that explains how the wholes differ, or else the wholes.

    One of the groups may have lumped its bodies.
    """
    one, other = lumped(here.bodies), lumped(there.bodies)
    if one is None or other is None:
        return
    for group, target, turned in ((here, other, False), (there, one, True)):
        if found := _one_change(group, target, tolerances):
            pair = found[::-1] if turned else found
            named = replace(pair[0], name=one.name, node=one.node) if turned else pair[0]
            yield from (each for each in _bodies(named, pair[1], tolerances) if each.differs)
            return
    yield from wholes


def _one_change(group: Group, target: Body, tolerances: Tolerances) -> tuple[Body, Body] | None:
    """Return the body of *group* and what it would have to be for all to be as *target*.

    It weighs something else, or has its centre of mass elsewhere; None if no such change will do.
    """
    heavy = [body for body in group.bodies if body.mass]
    whole = lumped(heavy)
    if whole is None or whole.mass is None or not 1 < len(heavy) <= FEW:
        return None
    missing = (target.mass or 0.0) - whole.mass
    for body in heavy:
        changed = replace(body, mass=(body.mass or 0.0) + missing)
        if whole.centre and target.centre and body.centre and not tolerances.apart(missing, 0.0):
            moment = scale(whole.mass / (body.mass or 1.0), subtract(target.centre, whole.centre))
            changed = replace(body, centre=add(body.centre, moment))
        others = [changed if each is body else each for each in heavy]
        then = lumped(others) if (changed.mass or 0.0) > 0.0 else None
        if then is not None and _agree(then, target, tolerances):
            return body, changed
    return None
