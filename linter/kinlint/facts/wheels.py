"""Wheels as they are drawn, and the drives of plugins compared with them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from kinlint.addresses import element_of
from kinlint.facts.body_shapes import BOX, CYLINDER, BodyShapes, Shape
from kinlint.facts.drawn_symmetry import Drawn, DrawnSymmetry
from kinlint.facts.elements_by_tag import elements
from kinlint.facts.fact_statements import numbers
from kinlint.facts.linear_algebra import IDENTITY, apply, dot
from kinlint.terms import Term, Triple, iri, literal_value
from kinlint.vocabulary import EXTENSION, REFERENCE, SRC

LEFT = tuple(iri(f"{EXTENSION}{name}") for name in ("left_joint", "leftJoint"))
RIGHT = tuple(iri(f"{EXTENSION}{name}") for name in ("right_joint", "rightJoint"))
STEERING = (iri(f"{EXTENSION}left_steering_joint"),)
TEXT = iri(f"{SRC}text")
PLUGIN = iri(f"{EXTENSION}plugin")
SIDES = (iri(f"{SRC}left"), iri(f"{SRC}right"))
MEMBER, JOINT = iri(f"{SRC}memberOf"), iri(f"{REFERENCE}joint")
AHEAD = 0.02
"""The part of the track by which two wheels of one axle may be ahead of each other."""
UPRIGHT = 0.9
"""The least component along y of the axis of a wheel that rolls forward along x."""


def wheels(drawn: DrawnSymmetry, shapes: BodyShapes) -> Iterator[Triple]:
    """Yield how discs lie on the axes of their joints, and how drives lie on their wheels.

    Of an endless joint whose child is a cylinder that is wider than long: the cosine between both
    axes. Of a plugin with left and right wheels: what `_drive` tells of one axle, and how far
    the steered one is ahead of it.
    """
    for robot, joints in drawn.robots.items():
        for joint, each in joints.items():
            element = drawn.trees.mechanism.element(joint)
            shape = _round(each, shapes)
            if element is not None and shape is not None and shape.kind == CYLINDER:
                yield from _disc(element, each, shape, drawn, shapes)
        yield from _drives(element_of(robot), joints, drawn, shapes)
    yield from _controlled(drawn, shapes)


def _controlled(drawn: DrawnSymmetry, shapes: BodyShapes) -> Iterator[Triple]:
    """Yield what is drawn of the wheels of each controller in a file beside the robot."""
    scan = drawn.trees.scan
    lists = [scan.single(side) for side in SIDES]
    if not all(lists):
        return
    named: dict[Term, list[Term]] = {}
    for entry, group in scan.single(MEMBER).items():
        named.setdefault(group, []).append(entry)
    at = {
        drawn.trees.mechanism.element(joint) or joint: each
        for joints in drawn.robots.values()
        for joint, each in joints.items()
    }
    joints = scan.single(JOINT)
    for controller in sorted(lists[0].keys() & lists[1].keys()):
        left, right = (
            [
                at[joints[entry]]
                for entry in sorted(named.get(each[controller], ()))
                if joints.get(entry) in at
            ]
            for each in lists
        )
        yield from _drive(controller, left, right, shapes)


def _axle(left: Sequence[Drawn], right: Sequence[Drawn]) -> tuple[Drawn, Drawn] | None:
    """Return the first wheel on the left that is on one body with one on the right, and that one.

    Of several, the one that is beside it.
    """
    for one in left:
        if beside := [each for each in right if each.edge.parent == one.edge.parent]:
            return one, min(beside, key=lambda each: abs(each.step[0] - one.step[0]))
    return None


def _round(joint: Drawn, shapes: BodyShapes) -> Shape | None:
    """Return the only collision shape of the child of *joint*, if it is round."""
    shape = shapes.sole(joint.edge.child) if joint.edge.child is not None else None
    return shape if shape is not None and shape.kind != BOX else None


def _disc(
    element: Term, joint: Drawn, shape: Shape, drawn: DrawnSymmetry, shapes: BodyShapes
) -> Iterator[Triple]:
    along = drawn.axis_on_child(joint.edge)
    placed = shapes.placements.shape_placement(shape.node)
    if 2.0 * shape.sizes[0] > shape.sizes[1] and placed is not None and along is not None:
        own = apply(placed.turn or IDENTITY, (0.0, 0.0, 1.0))
        yield from numbers(element, [("disc-cosine", abs(dot(own, along)))])


def _drives(
    robot: Term, joints: Mapping[Term, Drawn], drawn: DrawnSymmetry, shapes: BodyShapes
) -> Iterator[Triple]:
    """Yield what is drawn of the wheels of each plugin of *robot*."""
    scan = drawn.trees.scan
    gazebo = (
        each for part in elements(scan, robot, "gazebo") for each in scan.table(PLUGIN).values(part)
    )
    plugins = [*elements(scan, robot, "plugin"), *gazebo]
    if not plugins:
        return
    named = {
        drawn.trees.attribute_text(drawn.trees.mechanism.element(joint) or joint, "name"): each
        for joint, each in joints.items()
    }
    texts = scan.single(TEXT)
    for plugin in plugins:
        left, right, steering = (
            [
                named[name]
                for key in keys
                for each in sorted(scan.table(key).values(plugin))
                if each in texts and (name := literal_value(texts[each])) in named
            ]
            for keys in (LEFT, RIGHT, STEERING)
        )
        yield from _drive(plugin, left, right, shapes)
        axle = _axle(left, right)
        if axle and steering and steering[0].edge.parent == axle[0].edge.parent:
            ahead = abs(steering[0].step[0] - axle[0].step[0])
            yield from numbers(plugin, [("wheel-base", ahead)])


def _drive(
    plugin: Term, lefts: Sequence[Drawn], rights: Sequence[Drawn], shapes: BodyShapes
) -> Iterator[Triple]:
    """Yield the greatest cosine between axes of both sides, and the numbers of one axle in m.

    The distance of its wheels, the radius of the left one and, where both axes are along y: how far
    the left one is to the left of the right one.
    """
    if (axle := _axle(lefts, rights)) is None:
        return
    left, right = axle
    if left.axis is None or right.axis is None or left is right:
        return
    cosines = [
        dot(one.axis, other.axis)
        for one in lefts
        for other in rights
        if one.axis is not None and other.axis is not None
    ]
    yield from numbers(plugin, [("drive-cosine", max(cosines))])
    beside = left.step[1] - right.step[1]
    if abs(left.step[0] - right.step[0]) <= AHEAD * abs(beside):
        yield from numbers(plugin, [("track", abs(beside))])
    if min(left.axis[1], right.axis[1]) > UPRIGHT:
        yield from numbers(plugin, [("leftward", beside)])
    if (shape := _round(left, shapes)) is not None:
        yield from numbers(plugin, [("rolling-radius", shape.sizes[0])])
