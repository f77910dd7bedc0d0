"""Statements about links of COLLADA that are elsewhere than their joints have them.

Readers place the shapes of a link by its node, and the link by its joints. Where joints form a
loop, two ways lead to a link.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from math import acos, asin, degrees, hypot
from operator import mul

from kinlint.formats.collada.addressing import Addressing
from kinlint.formats.collada.asset_units import metres
from kinlint.formats.collada.collada_elements import ColladaElement
from kinlint.formats.collada.kinematics import Joint, Model
from kinlint.formats.collada.transforms import place
from kinlint.formats.derived_statements import DerivedStatements
from kinlint.formats.rigid_transform import (
    IDENTITY,
    Transform,
    Vector,
    between,
    composed,
    inverse,
    rotated,
)

FARTHEST, WIDEST = 1e-3, 0.5
"""Metres and degrees by which a node may stand elsewhere: drawings are rounded."""


def state_drawn_elsewhere(
    model: Model,
    nodes: Mapping[ColladaElement, ColladaElement],
    root: ColladaElement,
    addressing: Addressing,
    said: DerivedStatements,
) -> None:
    """State how far the *nodes* that show links of *model* are from where joints place them.

    Only if each node is in the one that shows the parent: what is drawn side by side may have
    geometries seen by the scene. A transform that is bound to an axis may show a position of the
    joint.
    """
    joints = [each for each in model.joints if each.child in nodes and each.end is None]
    if any(nodes[each.child].parent is not nodes.get(each.parent) for each in joints):
        return
    bound = set(_bound(root, addressing)) if joints else set[ColladaElement]()
    for joint in joints:
        node, on_parent, on_child = nodes[joint.child], joint.on_parent, joint.on_child
        if on_parent is None or on_child is None:
            continue
        expected = composed(on_parent, inverse(on_child))
        drawn = (place(node, metres(node), each) for each in ((), bound))
        errors = [_error(between(expected, each)) for each in drawn if each is not None]
        if errors and all(far > FARTHEST or wide > WIDEST for far, wide in errors):
            far, wide = min(errors)
            said.state(joint.child.node, "drawnBy", node.node)
            said.number(joint.child.node, "drawnOff", round(far, 6))
            said.number(joint.child.node, "drawnTurned", round(wide, 3))
        elif len(joint.primitives) == 1:
            _state_turn(joint, node, on_parent, bound, said)


def state_open_loops(model: Model, said: DerivedStatements) -> None:
    """State how far the two frames of each joint of *model* that closes a loop are apart at zero.

    That is in metres beside the way that the joint slides, and in degrees beside its turn.
    """
    places = {each: (each, IDENTITY) for each in model.roots}
    for joint in model.joints:
        on_parent, on_child = joint.on_parent, joint.on_child
        if joint.parent not in places or on_parent is None or on_child is None:
            continue
        root, carrier = places[joint.parent]
        frame = composed(carrier, on_parent)
        if joint.end is None:
            places[joint.child] = root, composed(frame, inverse(on_child))
            continue
        if len(joint.primitives) != 1 or places.get(joint.child, (None,))[0] is not root:
            continue
        axis, slides = joint.primitives[0].first("axis"), joint.primitives[0].tag == "prismatic"
        written = axis.numbers() if axis is not None else []
        if len(written) == 3 and any(written):  # noqa: PLR2004  x, y, z
            about = _unit(written)
            apart, turned = between(frame, composed(places[joint.child][1], on_child))
            far = _aside(apart, about) if slides else hypot(*apart)
            wide = _error((apart, turned))[1] if slides else _angle(rotated(turned, about), about)
            if far > FARTHEST or wide > WIDEST:
                said.number(joint.end.node, "loopOff", round(far, 6))
                said.number(joint.end.node, "loopTurned", round(wide, 3))


def _state_turn(
    joint: Joint,
    node: ColladaElement,
    on_parent: Transform,
    bound: set[ColladaElement],
    said: DerivedStatements,
) -> None:
    """State how far the axis about which *node* turns, either way, is from that of *joint*."""
    axis = joint.primitives[0].first("axis")
    shown = [each for each in node.all("rotate") if each in bound]
    if axis is None or len(shown) != 1 or joint.primitives[0].tag != "revolute":
        return
    written, own = shown[0].numbers()[:3], axis.numbers()
    at = place(node, metres(node), node.children[node.children.index(shown[0]) :])
    if at is None or len(own) != 3 or not any(own) or not any(written):  # noqa: PLR2004  x, y, z
        return
    (apart, turned), about = between(on_parent, at), _unit(own)
    aside = _aside(apart, about)
    angle = _angle(rotated(turned, _unit(written)), about)
    angle = min(angle, 180 - angle)
    if aside > FARTHEST or angle > WIDEST:
        said.state(shown[0].node, "showsJoint", joint.node)
        said.number(shown[0].node, "axisOff", round(aside, 6))
        said.number(shown[0].node, "axisTurned", round(angle, 3))


def _aside(offset: Vector, about: Vector) -> float:
    """Return the distance of *offset* from the line along *about*, of length 1."""
    along = sum(map(mul, offset, about))
    return hypot(*(x - along * y for x, y in zip(offset, about, strict=True)))


def _angle(one: Vector, other: Vector) -> float:
    """Return the angle in degrees between two vectors of length 1."""
    return degrees(acos(max(-1.0, min(1.0, sum(map(mul, one, other))))))


def _unit(vector: Sequence[float]) -> Vector:
    """Return *vector*, which is not zero, at length 1."""
    x, y, z = vector
    length = hypot(x, y, z)
    return x / length, y / length, z / length


def _bound(root: ColladaElement, addressing: Addressing) -> Iterator[ColladaElement]:
    """Yield the transforms that show axes."""
    for each in root.below():
        if each.tag == "bind_joint_axis":
            target = addressing.by_path(each.text("target"), each)
            if isinstance(target, ColladaElement):
                yield target


def _error(offset: Transform) -> tuple[float, float]:
    """Return the distance in metres and the angle in degrees of *offset*."""
    return hypot(*offset[0]), 2 * degrees(asin(min(1.0, hypot(*offset[1][:3]))))
