"""Parts of robots in one sentence: what a link weighs and what moves it, what a joint moves."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from math import degrees

from kinlint.addresses import is_address, lifted
from kinlint.facts.fact_context import FactContext
from kinlint.facts.mechanism import named
from kinlint.facts.part_names import PartPlaces
from kinlint.facts.robot_structures import Extraction
from kinlint.navigation.occurrence import Entity
from kinlint.structure import Joint, Link, Vector

AXES = "xyz"
TINY = 1e-9
TURNING = frozenset({"revolute", "continuous", "RevoluteJoint"})
MOST = 3


class PartSummaries:
    """Sentences about the parts of the robots of *context*, whose places *places* knows."""

    def __init__(self, context: FactContext, places: PartPlaces) -> None:
        self._context, self._places = context, places

    def summary(self, entity: Entity) -> str:
        """Return a sentence about *entity*, in Markdown; empty if it is no part of a robot."""
        node = lifted(entity) if is_address(entity) else entity
        iri = named(node)
        if (joint := self._joints.get(iri)) is not None:
            return f"**joint {joint.name}**: {self._joint(joint)}"
        if (link := self._links.get(iri)) is not None:
            told = [*self._inertial(node), *self._hanging(link)]
            return f"**link {link.name}**: {', '.join(told) or 'without mass'}"
        return ""

    @cached_property
    def _robots(self) -> tuple[Mapping[str, Link], Mapping[str, Joint]]:
        found = Extraction(self._context, self._places, located=False).structures()
        links = {each.iri: each for robot in found for each in robot.links}
        return links, {each.iri: each for robot in found for each in robot.joints}

    @property
    def _links(self) -> Mapping[str, Link]:
        return self._robots[0]

    @property
    def _joints(self) -> Mapping[str, Joint]:
        return self._robots[1]

    def _inertial(self, body: Entity) -> list[str]:
        mass = self._context.assemblies.masses.get(body)
        centre = self._context.placements.centres.get(body)
        told = [] if mass is None else [f"{mass:.6g} kg"]
        return told if centre is None or mass is None else [*told, f"centre {_vector(centre)} m"]

    def _hanging(self, link: Link) -> list[str]:
        """Return which joint moves *link*, and which ones it carries."""
        moving = [each for each in self._joints.values() if each.child == link.iri]
        carried = [each.name for each in self._joints.values() if each.parent == link.iri]
        told = [
            f"{'fixed by' if each.kind == 'fixed' else 'moved by'} {each.name}{_motion(each)}"
            for each in moving[:1]
        ]
        if not moving and carried:
            told.append("root")
        if carried:
            more = f" and {len(carried) - MOST} more" if len(carried) > MOST else ""
            told.append(f"carries {', '.join(carried[:MOST])}{more}")
        return told

    def _joint(self, joint: Joint) -> str:
        links = self._links
        child, parent = (links.get(each or "") for each in (joint.child, joint.parent))
        told = f"{joint.kind or 'kind unknown'}{_motion(joint)}"
        if child is not None and parent is not None:
            verb = "fixes" if joint.kind == "fixed" else "moves"
            told += f", {verb} {child.name} {'to' if verb == 'fixes' else 'on'} {parent.name}"
        return told


def _motion(joint: Joint) -> str:
    """Return the axis and the range of *joint*, such as ` about y, -115 to 115°`."""
    turning = joint.kind in TURNING
    told = ""
    if joint.axis is not None and joint.kind != "fixed":
        told = f" {'about' if turning else 'along'} {_direction(joint.axis)}"
    if joint.lower is not None and joint.upper is not None and joint.kind != "continuous":
        lower, upper = joint.lower, joint.upper
        if turning:
            told += f", {degrees(lower):.4g} to {degrees(upper):.4g}°"
        else:
            told += f", {lower:.4g} to {upper:.4g} m"
    return told


def _direction(axis: Vector) -> str:
    """Return the name of the coordinate axis that *axis* is along, or its components."""
    for name, own in zip(AXES, axis, strict=True):
        if abs(abs(own) - 1) < TINY:
            return name if own > 0 else f"-{name}"
    return _vector(axis)


def _vector(vector: tuple[float, ...]) -> str:
    return f"({', '.join(f'{each + 0.0:.4g}' for each in vector)})"
