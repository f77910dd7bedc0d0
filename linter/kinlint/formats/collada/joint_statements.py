"""Statements about the joints of a COLLADA document: ends, axes, limits and rates, in SI."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.formats.collada.addressing import Addressing
from kinlint.formats.collada.asset_units import metres, speeds_in_radians
from kinlint.formats.collada.collada_elements import ColladaElement
from kinlint.formats.collada.joint_motions import DEGREE, joint_uses, kind_of, turns, unit_of
from kinlint.formats.collada.kinematics import PRIMITIVES, Joint, Model
from kinlint.formats.collada.parameter_values import number_of
from kinlint.formats.derived_statements import DerivedStatements
from kinlint.formats.rigid_transform import IDENTITY
from kinlint.terms import XSD, Term, literal

RATES = {"speed": "velocity", "acceleration": "acceleration"}
"""Properties of the rates in a motion, by tag."""
TRUE = literal("true", f"{XSD}boolean")
MOST_FOLLOWED = 8
"""Greatest number of axis_infos that lead to each other."""


class JointStatements:
    """Statements about the joints of *models*."""

    def __init__(
        self,
        root: ColladaElement,
        models: Sequence[Model],
        addressing: Addressing,
        said: DerivedStatements,
    ) -> None:
        self.models, self.addressing, self.said = models, addressing, said
        self.rate_unit = 1.0 if speeds_in_radians(root) else DEGREE
        self.tool = root.first("asset", "contributor", "authoring_tool")
        self.uses = joint_uses(models)
        self.infos = [each for each in root.below() if each.tag == "axis_info"]
        self.angles: dict[Term, list[float]] = {}
        """Limits as they are written, by the nodes of joints."""

    def state(self) -> None:
        """State all joints."""
        for model in self.models:
            for joint in model.joints:
                self._joint(joint)
        limited = set[Joint]()
        for info in self.infos:
            for joint, unit in self._moved(info):
                limits = info.first("limits")
                if limits is not None and joint not in limited:
                    limited.add(joint)
                    self._limits(joint, limits, unit if turns(joint) else metres(info))
                self._rates(joint, info)
        for joint in (each for model in self.models for each in model.joints):
            own = joint.primitives[0].first("limits") if len(joint.primitives) == 1 else None
            if own is None:
                continue
            if joint in limited:
                self._bounds(joint, own, unit_of(joint), "own-")
            else:
                self._limits(joint, own, unit_of(joint))
        for model in self.models:
            self._angles(model)

    def _angles(self, model: Model) -> None:
        """State how many joints of *model* have limits in degrees, and the greatest of these."""
        angles = [
            max(map(abs, bounds))
            for joint in model.joints
            if len(joint.primitives) == 1
            and turns(joint)
            and (bounds := self.angles.get(joint.node, ()))
        ]
        if angles:
            self.said.number(model.element.node, "limitedJoints", len(angles))
            self.said.number(model.element.node, "greatestAngle", max(angles))

    def _joint(self, joint: Joint) -> None:
        said, node = self.said, joint.node
        if node != joint.element.node:
            said.made_of[node] = joint.element.node
        said.state(node, "compiledFrom", joint.element.node)
        said.state(node, "inModel", joint.model.node)
        said.state(node, "attachment", joint.attachment.node)
        said.state(node, "parentBody", joint.parent.node)
        said.pose(node, "parent", joint.on_parent)
        said.state(node, "childBody", joint.child.node)
        if joint.on_child == IDENTITY:
            said.state(node, "childFrame", joint.child.node)
        else:
            said.state(node, "childFrame", node)
            if joint.end is not None:
                said.state(node, "end", joint.end.node)
            said.pose(node, "child", joint.on_child)
        kind = kind_of(joint)
        if kind:
            said.word(node, "jointType", kind)
        if kind in PRIMITIVES:
            axis = joint.primitives[0].first("axis")
            numbers = axis.numbers() if axis is not None else []
            if axis is not None and len(numbers) == 3:  # noqa: PLR2004  x, y, z
                said.state(node, "axisFrom", axis.node)

    def _moved(self, info: ColladaElement) -> Iterator[tuple[Joint, float]]:
        """Yield the joints of one motion that *info* is about, with their units in SI."""
        at = info
        for _ in range(MOST_FOLLOWED):
            found = self.addressing.by_path(at.text("axis"), at)
            meant = self.addressing.followed(found) if isinstance(found, ColladaElement) else None
            if meant is None or meant.tag != "axis_info":
                break
            at = meant
        else:
            return
        for joint in self.uses.get(meant, ()) if meant is not None else ():
            if len(joint.primitives) == 1:
                yield joint, unit_of(joint)

    def _limits(self, joint: Joint, limits: ColladaElement, unit: float) -> None:
        self.said.state(joint.node, "limits", limits.node)
        if limits.first("min") is None and limits.first("max") is None:
            self.said.state(joint.node, "emptyLimits", limits.node)
        self._bounds(joint, limits, unit)

    def _bounds(self, joint: Joint, limits: ColladaElement, unit: float, stem: str = "") -> None:
        for tag, name in (("min", "lower"), ("max", "upper")):
            bound = self._quantity(joint, f"{stem}{name}", limits.first(tag), unit)
            if bound is not None and not stem:
                self.angles.setdefault(joint.node, []).append(bound)

    def _rates(self, joint: Joint, info: ColladaElement) -> None:
        unit = self.rate_unit if turns(joint) else metres(info)
        for tag, name in RATES.items():
            self._quantity(joint, name, info.first(tag), unit)
        if turns(joint) and self.rate_unit == DEGREE:
            self._quantity(joint, "degrees", info.first("speed"), 1.0)
        elif turns(joint) and self.tool is not None and info.first("speed") is not None:
            self.said.state(self.tool.node, "turnsSpeeds", TRUE)

    def _quantity(
        self, joint: Joint, name: str, value: ColladaElement | None, unit: float
    ) -> float | None:
        """State the number that *value* has in itself, in a child, or by a parameter, in SI.

        Return it as it is written; None if there is none.
        """
        found = number_of(value, self.addressing) if value is not None else None
        if found is None:
            return None
        self.said.state(joint.node, f"{name}From", found[0].node)
        self.said.number(joint.node, name, found[1] * unit)
        return found[1]
