"""Attributes that MuJoCo does not read because of what else is written."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.formats.mjcf.body_statements import joint_type
from kinlint.formats.mjcf.compiled_model import CompiledBody, CompiledModel
from kinlint.formats.mjcf.default_classes import ORIENTATIONS
from kinlint.formats.mjcf.mjcf_elements import MjcfElement
from kinlint.light_dataclasses import dataclass

OF_JOINTS = {
    "ball": ("axis", "ref", "springref", "actuatorfrcrange"),
    "free": ("axis", "pos", "range", "ref", "actuatorfrcrange"),
}
"""Attributes that joints of a type do not have, by type."""
TARGETS = ("site", "slidersite", "joint", "jointinparent", "tendon", "body")
"""Attributes with what an actuator acts on; the first of them that is written counts."""
PARAMETERS = {"biasprm": "biastype", "dynprm": "dyntype"}
"""Parameters of general actuators, and the types without which they do not count."""
SIZES = {"sphere": 1, "capsule": 2, "cylinder": 2}
"""The most sizes that geoms of a type have."""
UNCHECKED = frozenset({"frame", "replicate"})


@dataclass(frozen=True)
class UnreadAttribute:
    """Attribute that is written on an element, and not read."""

    element: MjcfElement
    """Element."""
    attribute: str
    """Attribute."""
    reason: str
    """Attribute or element because of which it is not read."""
    first: int = 0
    """Index of the first number that is not read."""


def unread(model: CompiledModel) -> Iterator[UnreadAttribute]:
    """Yield the attributes of *model* that its elements say themselves without effect."""
    seen = set()
    for body in model.bodies:
        for each in (*_of_joints(body), *_of_geoms(body)):
            if (each.element.node, each.attribute) not in seen:
                seen.add((each.element.node, each.attribute))
                yield each
    for section in model.root.all("actuator"):
        for element in section.content():
            named = [each for each in TARGETS if each in element.said and element.text(each)]
            for name in named[1:]:
                yield UnreadAttribute(element, name, named[0])
            for name, type_ in PARAMETERS.items() if element.tag == "general" else ():
                if name in element.said and element.text(type_) in ("", "none"):
                    yield UnreadAttribute(element, name, type_)


def _of_joints(body: CompiledBody) -> Iterator[UnreadAttribute]:
    for joint in body.joints:
        for name in OF_JOINTS.get(joint_type(joint.element), ()):
            if name in joint.element.said and (name != "pos" or any(joint.element.numbers(name))):
                yield UnreadAttribute(joint.element, name, "type")


def _of_geoms(body: CompiledBody) -> Iterator[UnreadAttribute]:
    inferred = body.settings.text("inertiafromgeom") == "true"
    for geom in body.geoms:
        element = geom.element
        most = SIZES.get(element.text("type") or "sphere")
        if most is not None and len(element.said.get("size", ())) > most:
            yield UnreadAttribute(element, "size", "type", most)
        if element.text("mesh") and "size" in element.said:
            yield UnreadAttribute(element, "size", "mesh")
        if element.numbers("fromto"):
            for name in sorted(ORIENTATIONS & element.said.keys()):
                yield UnreadAttribute(element, name, "fromto")
        weighs = "mass" in element.said and element.number("mass") != 0
        if body.inertial is not None and not inferred and weighs:
            yield UnreadAttribute(element, "mass", "inertial")
        elif weighs and "density" in element.said:
            yield UnreadAttribute(element, "density", "mass")


def unchecked(root: MjcfElement) -> Iterator[tuple[MjcfElement, MjcfElement]]:
    """Yield each element that no schema is held to, with the frame or replicate that it is in."""
    pending: list[tuple[MjcfElement, MjcfElement | None]] = [(root, None)]
    while pending:
        at, frame = pending.pop()
        frame = frame or (at if at.tag in UNCHECKED else None)
        if frame is not None:
            yield at, frame
        pending += [(each, frame) for each in at.content() if at.tag != "model"]
