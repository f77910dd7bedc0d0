"""Statements about keyframes: the positions and controls that they set, and their sizes."""

from __future__ import annotations

from math import hypot

from kinlint.formats.mjcf.body_inertia import OPAQUE
from kinlint.formats.mjcf.body_statements import joint_type
from kinlint.formats.mjcf.compiled_model import CompiledModel, CompiledPart
from kinlint.formats.mjcf.default_classes import ACTUATORS
from kinlint.formats.mjcf.mjcf_elements import MjcfElement
from kinlint.formats.mjcf.model_statements import ModelStatements
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term

COORDINATES = {"hinge": 1, "slide": 1, "ball": 4, "free": 7}
"""Numbers of a keyframe for each type of joint."""
VELOCITIES = {"hinge": 1, "slide": 1, "ball": 3, "free": 6}
"""Degrees of freedom of each type of joint."""
SINGLE = ("hinge", "slide")
QUATERNION = 4
STATELESS = frozenset({"motor", "position", "velocity", "damper", "adhesion"})
"""Actuators without activation, unless they have a time constant."""


@dataclass
class KeyframeStatements:
    """Statements about the keyframes of *model*."""

    model: CompiledModel
    """The model."""
    said: ModelStatements
    """The statements."""

    def state(self) -> None:
        """State all keyframes of the main file."""
        keys = [each for section in self.model.root.all("keyframe") for each in section.all("key")]
        if not keys:
            return
        joints = [each for body in self.model.bodies[1:] for each in body.joints]
        sections = self.model.root.all("actuator")
        actuators = [each for section in sections for each in section.all(*ACTUATORS)]
        sizes = self._sizes(joints, actuators)
        for key in keys:
            self.said.copy(key.node, key)
            self._positions(key, joints)
            if sizes:
                self._other_sizes(key, sizes)
                self._controls(key, actuators)

    def _positions(self, key: MjcfElement, joints: list[CompiledPart]) -> None:
        """State the position of each joint of one degree of freedom, and quaternions of zeros."""
        said, values = key.said.get("qpos", []), key.numbers("qpos")
        sizes = [COORDINATES.get(joint_type(each.element), 0) for each in joints]
        if len(values) != sum(sizes):
            return
        at = 0
        for number, (joint, size) in enumerate(zip(joints, sizes, strict=True), 1):
            node = f"{key.node[:-1]}/position/{number}>"
            turn = values[at + size - QUATERNION : at + size] if size >= QUATERNION else [1.0]
            if size == 1 or not hypot(*turn):
                self.said.made_of[node] = key.node
                self.said.state(node, "ofKey", key.node)
                self.said.state(node, "ofJoint", joint.node)
            if size == 1:
                self._position(node, joint, key, at, said[at][2])
            elif not hypot(*turn):
                of = said[at + size - QUATERNION]
                self.said.state(node, "quaternionNorm", of[2], of)
            at += size

    def _position(
        self, node: Term, joint: CompiledPart, key: MjcfElement, at: int, written: Term
    ) -> None:
        reference = joint.element.number("ref")
        linear = joint_type(joint.element) == "slide"
        self.said.truth(node, "linear", value=linear)
        if not reference:
            self.said.state(node, "position", written, key.said["qpos"][at])
            return
        shift = reference if linear else joint.body.settings.angle(reference)
        self.said.number(node, "position-drawn", key.numbers("qpos")[at] - shift)

    def _sizes(self, joints: list[CompiledPart], actuators: list[MjcfElement]) -> dict[str, int]:
        """Return the numbers that the attributes of keyframes have, of those that are known."""
        types = [joint_type(each.element) for each in joints]
        if not VELOCITIES.keys() >= set(types) or any(
            e.tag in OPAQUE and not (e.tag == "include" and e.children)
            for e in self.model.root.below()
        ):
            return {}
        bodies = sum(body.element.text("mocap") == "true" for body in self.model.bodies)
        found = {
            "qpos": sum(COORDINATES[each] for each in types),
            "qvel": sum(VELOCITIES[each] for each in types),
            "ctrl": len(actuators),
            "mpos": 3 * bodies,
            "mquat": 4 * bodies,
        }
        if all(each.tag in STATELESS and not each.number("timeconst") for each in actuators):
            found["act"] = 0
        return found

    def _other_sizes(self, key: MjcfElement, sizes: dict[str, int]) -> None:
        """State the attributes of *key* that are longer or shorter than *sizes* say."""
        for name, size in sizes.items():
            count = len(key.said.get(name, ()))
            if count and count != size and key.text(name):
                node = f"{key.node[:-1]}/{name}>"
                self.said.made_of[node] = key.node
                self.said.state(node, "ofKey", key.node)
                self.said.word(node, "attribute", name)
                self.said.number(node, "count", count)
                self.said.number(node, "expected", size)

    def _controls(self, key: MjcfElement, actuators: list[MjcfElement]) -> None:
        said = key.said.get("ctrl", [])
        if len(said) != len(actuators):
            return
        for number, (actuator, triple) in enumerate(zip(actuators, said, strict=True), 1):
            node = f"{key.node[:-1]}/control/{number}>"
            self.said.made_of[node] = key.node
            self.said.state(node, "ofKey", key.node)
            self.said.state(node, "ofActuator", actuator.node)
            self.said.state(node, "control", triple[2], triple)
