"""Statements about what a scene of COLLADA binds: which nodes show which axes, and from where on.

Readers find the motion of an axis, and at times its limits, by the node that shows it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from kinlint.formats.collada.addressing import Addressing
from kinlint.formats.collada.asset_units import speeds_in_radians
from kinlint.formats.collada.collada_elements import ColladaElement
from kinlint.formats.collada.joint_motions import DEGREE, turns, unit_of
from kinlint.formats.collada.kinematics import PRIMITIVES, Joint
from kinlint.formats.collada.parameter_values import meant_by, number_of
from kinlint.formats.derived_statements import DerivedStatements

SCENE = "instance_kinematics_scene"
MODELS = ("instance_kinematics_model", "kinematics_model")
SHOWN_BY = {"revolute": ("rotate", "matrix"), "prismatic": ("translate", "matrix")}
"""Transforms that can show a motion, by its tag; the first is the usual one."""


class BindingStatements:
    """Statements about the bindings of the instances of kinematics scenes below *root*."""

    def __init__(
        self,
        root: ColladaElement,
        uses: Mapping[ColladaElement, Sequence[Joint]],
        addressing: Addressing,
        said: DerivedStatements,
    ) -> None:
        self.uses, self.addressing, self.said = uses, addressing, said
        self.turn_unit = 1.0 if speeds_in_radians(root) else DEGREE
        elements = [*root.below()]
        self.scenes = [each for each in elements if each.tag == SCENE]
        self.infos = [each for each in elements if each.tag == "axis_info"]
        self.shown = any(each.tag == "node" for each in elements)

    def state(self) -> None:
        """State the bindings, and what is not bound though other parts of the robot are drawn."""
        published = dict.fromkeys(filter(None, map(self._axis, self.infos)))
        for scene in self.scenes:
            bound = dict.fromkeys(map(self._bound, scene.all("bind_joint_axis")))
            if not self.shown:
                continue
            for binding in scene.all("bind_kinematics_model"):
                self._meant(binding, MODELS)
            if not any(scene.all("bind_kinematics_model")):
                self.said.word(scene.node, "unbound", "model")
            if None in bound:  # A binding that leads nowhere may be meant for any axis.
                continue
            for axis in (*self._instanced(scene), *published):
                if axis not in bound:
                    bound[axis] = None
                    for joint in self.uses.get(axis, ()):
                        self.said.state(scene.node, "unboundAxis", joint.node)

    def _bound(self, binding: ColladaElement) -> ColladaElement | None:
        """Return the motion that *binding* has a node show, and state what is to be said of it."""
        axis = self._meant(binding.first("axis"), PRIMITIVES)
        if axis is None or axis.tag not in PRIMITIVES:
            return axis
        self._start(binding, axis)
        target = self.addressing.by_path(binding.text("target"), binding)
        fitting = SHOWN_BY[axis.tag]
        known = {each for tags in SHOWN_BY.values() for each in tags}
        if isinstance(target, ColladaElement) and target.tag in known - {*fitting}:
            self.said.word(binding.node, "shows", axis.tag)
            self.said.word(binding.node, "shownBy", target.tag)
            self.said.word(binding.node, "usually", fitting[0])
        return axis

    def _meant(
        self, holder: ColladaElement | None, expected: tuple[str, ...]
    ) -> ColladaElement | None:
        """Return what the parameter or path in *holder* leads to; state what else it is."""
        named = holder and (holder.first("param") or holder.first("SIDREF"))
        meant = meant_by(named, self.addressing) if named is not None else None
        if named is not None and meant is not None and meant.tag not in expected:
            self.said.word(named.node, "leadsTo", meant.tag)
            self.said.word(named.node, "bound", " or ".join(f"<{each}>" for each in expected))
        return meant

    def _start(self, binding: ColladaElement, axis: ColladaElement) -> None:
        """State the position at which *binding* has the joints of *axis* begin, in SI."""
        value = binding.first("value")
        found = number_of(value, self.addressing) if value is not None else None
        for joint in self.uses.get(axis, ()) if found is not None else ():
            if found is not None and len(joint.primitives) == 1:
                unit = self.turn_unit if turns(joint) else unit_of(joint)
                self.said.state(joint.node, "startFrom", found[0].node)
                self.said.number(joint.node, "start", found[1] * unit)

    def _axis(self, info: ColladaElement) -> ColladaElement | None:
        """Return the motion of a joint that *info* is about, if it is directly about one."""
        found = self.addressing.by_path(info.text("axis"), info)
        meant = self.addressing.followed(found) if isinstance(found, ColladaElement) else None
        return meant if meant is not None and meant.tag in PRIMITIVES else None

    def _instanced(self, scene: ColladaElement) -> Iterator[ColladaElement]:
        """Yield the motions that the parameters of the kinematics scene lead to."""
        instanced = self.addressing.instanced(scene)
        for instance in instanced.children if instanced is not None else ():
            for parameter in instance.all("newparam"):
                meant = self.addressing.followed(parameter)
                if meant is not None and meant.tag in PRIMITIVES:
                    yield meant
