"""Wheels as they are drawn, and the drives of plugins compared with them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

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
    axes. Of a plugin with a left and a right wheel on one axle: what `_drive` tells.
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
    """Yield what is drawn of the wheels of each controller in a file beside the robot.

    Of several wheels on a side, the first counts, with the one beside it.
    """
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
        if left and right:
            beside = min(right, key=lambda each: abs(each.step[0] - left[0].step[0]))
            yield from _drive(controller, left[0], beside, shapes)


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
    for plugin in plugins:
        sides = []
        for keys in (LEFT, RIGHT):
            told = [each for key in keys for each in scan.table(key).values(plugin)]
            texts = [scan.single(TEXT).get(each) for each in told]
            sides += [named.get(literal_value(text)) for text in texts if text is not None]
        if len(sides) == len((LEFT, RIGHT)) and sides[0] is not None and sides[1] is not None:
            yield from _drive(plugin, sides[0], sides[1], shapes)


def _drive(plugin: Term, left: Drawn, right: Drawn, shapes: BodyShapes) -> Iterator[Triple]:
    """Yield the cosine between two axes, their distance and the radius of the left wheel in m.

    Where both are along y: how far the left one is to the left of the right one.
    """
    one = left is not right and left.edge.parent == right.edge.parent
    if left.axis is None or right.axis is None or not one:
        return
    yield from numbers(plugin, [("drive-cosine", dot(left.axis, right.axis))])
    beside = left.step[1] - right.step[1]
    if abs(left.step[0] - right.step[0]) <= AHEAD * abs(beside):
        yield from numbers(plugin, [("track", abs(beside))])
    if min(left.axis[1], right.axis[1]) > UPRIGHT:
        yield from numbers(plugin, [("leftward", beside)])
    if (shape := _round(left, shapes)) is not None:
        yield from numbers(plugin, [("rolling-radius", shape.sizes[0])])
