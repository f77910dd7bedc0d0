"""Statements about the bodies of a compiled model, their joints, inertias and geoms."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.formats.mjcf.body_inertia import BodyInertia, inertias, massless, shape
from kinlint.formats.mjcf.compiled_model import CompiledBody, CompiledModel, CompiledPart
from kinlint.formats.mjcf.compiler_settings import CompilerSettings
from kinlint.formats.mjcf.mjcf_elements import MjcfElement
from kinlint.formats.mjcf.model_statements import ModelStatements
from kinlint.formats.mjcf.orientation import UNTURNED
from kinlint.formats.rigid_transform import IDENTITY, Transform, composed
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term, iri
from kinlint.vocabulary import UNIT

MOMENTS = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
TURNING = frozenset({"hinge", "ball"})
LIMITABLE = frozenset({"hinge", "slide", "ball"})
DEGREE, RADIAN, METRE = (iri(f"{UNIT}{name}") for name in ("DEG", "RAD", "M"))


def joint_type(element: MjcfElement) -> str:
    """Return the type of the joint *element*."""
    return "free" if element.tag == "freejoint" else element.text("type") or "hinge"


def is_limited(
    element: MjcfElement, settings: CompilerSettings, name: str = "limited", range_: str = "range"
) -> bool:
    """Tell whether the range of *element* counts."""
    said = element.text(name) or "auto"
    low, high = [*element.numbers(range_), 0.0, 0.0][:2]
    return said == "true" or (said != "false" and settings.autolimits and low < high)


@dataclass
class BodyStatements:
    """Statements about the bodies of *model*."""

    model: CompiledModel
    """The model."""
    said: ModelStatements
    """The statements."""

    def state(self) -> None:
        """State all bodies."""
        known, title = inertias(self.model), self.model.root.text("model")
        if "angle" not in self.model.settings.said:
            self._greatest_angle()
        for empty in massless(self.model):
            bound = empty.settings.number("boundmass", 0.0)
            self.said.truth(empty.node, "mended" if bound > 0 else "massless", value=True)
        if title:
            self.said.word(self.model.root.node, "name", title)
        for body in self.model.bodies:
            self.said.element(body)
            if body.name:
                self.said.word(body.node, "name", body.name)
            if body.parent is not None:
                self.said.state(body.node, "inBody", body.parent.node)
                self.said.pose(body.node, "placed", body.place)
                self._joints(body, body.parent)
            if body in known:
                self._inertia(body, known[body])
            elif body.parent is not None and body.geoms and not _is_given(body):
                self.said.truth(body.node, "inertiaUnknown", value=self._unknown(body))
            for part in body.parts:
                self._part(part)

    def _greatest_angle(self) -> None:
        """State the greatest bound of a hinge, in the unit that the main file leaves open."""
        hinges = (
            each.element
            for body in self.model.bodies
            for each in body.joints
            if body.settings is self.model.settings and joint_type(each.element) == "hinge"
        )
        angles = [abs(bound) for each in hinges for bound in each.numbers("range")]
        if angles:
            self.said.number(self.model.root.node, "greatestAngle", max(angles))

    def _unknown(self, body: CompiledBody) -> bool:
        return any(each.element.text("mesh") for each in body.geoms)

    def _joints(self, body: CompiledBody, parent: CompiledBody) -> None:
        """State the joints between *body* and its *parent*, or that there is none."""
        joints = body.joints
        if not joints:
            weld = f"{body.node[:-1]}/weld>"
            self.said.made_of[weld] = body.element.node
            self.said.word(weld, "type", "fixed")
            self._between(weld, parent.node, body.node, body.place, IDENTITY)
            return
        at, above = body.place, parent.node
        for joint, below in zip(joints, _carried(self.said, body), strict=True):
            self.said.element(joint)
            type_ = joint_type(joint.element)
            self.said.word(joint.node, "type", type_)
            here: Transform | None = IDENTITY
            if type_ in TURNING:
                here = (joint.place[0], UNTURNED) if joint.place is not None else None
            seen = composed(at, here) if at is not None and here is not None else None
            self._between(joint.node, above, below, seen, here)
            if joint.axis is not None and type_ in ("hinge", "slide"):
                self.said.numbers(joint.node, "xyz", joint.axis)
            if type_ in LIMITABLE:
                self._range(joint, type_, body.settings)
            at, above = IDENTITY, below

    def _between(
        self, joint: Term, above: Term, below: Term, on: Transform | None, at: Transform | None
    ) -> None:
        self.said.state(self.model.root.node, "joint", joint)
        self.said.state(joint, "parentBody", above)
        self.said.state(joint, "childBody", below)
        self.said.pose(joint, "parent", on)
        if at != IDENTITY:
            self.said.pose(joint, "child", at)

    def _range(self, joint: CompiledPart, type_: str, settings: CompilerSettings) -> None:
        element = joint.element
        unit = METRE if type_ == "slide" else DEGREE if settings.degrees else RADIAN
        self.said.state(joint.node, "rangeUnit", unit)
        self.said.truth(joint.node, "limited", value=is_limited(element, settings))
        self.said.undecided(joint.node, element, settings, "limited", "range")
        reference = element.number("ref")
        bounds = element.numbers("range")
        if reference and len(bounds) == 2 and type_ != "ball":  # noqa: PLR2004  a range
            low, high = (each - reference for each in bounds)
            self.said.numbers(joint.node, ("lower", "upper"), (low, high))

    def _inertia(self, body: CompiledBody, inertia: BodyInertia) -> None:
        """State the inertia of *body*: where it is written, or what was computed."""
        inertial = body.inertial
        if inertia.given and inertial is not None:
            self.said.state(body.node, "inertial", inertial.element.node)
            self.said.word(
                body.node,
                "momentsIn",
                "fullinertia" if inertial.element.numbers("fullinertia") else "diaginertia",
            )
        else:
            settings = body.settings
            if inertial is not None and settings.number("settotalmass", -1.0) <= 0:
                mended = settings.text("inertiafromgeom") != "true"
                self.said.truth(body.node, "mended", value=mended)
            self.said.number(body.node, "mass", inertia.mass)
            for name, value in zip(MOMENTS, inertia.moments, strict=True):
                self.said.number(body.node, name, value)
        self.said.pose(body.node, "centre", inertia.place)

    def _part(self, part: CompiledPart) -> None:
        self.said.element(part)
        self.said.state(part.node, "onBody", part.body.node)
        if part.element.tag != "geom":
            self.said.pose(part.node, "placed", part.place)
            return
        element = part.element
        place, size = shape(part)
        self.said.pose(part.node, "placed", place)
        self.said.word(part.node, "shape", element.text("type") or "sphere")
        bits = element.number("contype", 1.0), element.number("conaffinity", 1.0)
        self.said.truth(part.node, "collides", value=any(bits))
        if element.numbers("fromto") and size:
            names = (f"size-{number + 1}" for number in range(len(size)))
            self.said.numbers(part.node, names, size)


def _is_given(body: CompiledBody) -> bool:
    return body.inertial is not None


def _carried(said: ModelStatements, body: CompiledBody) -> Iterator[Term]:
    """Yield what each joint of *body* moves: bodies between the joints, and the body itself."""
    for number in range(1, len(body.joints)):
        stage = f"{body.node[:-1]}/stage/{number}>"
        said.made_of[stage] = body.element.node
        said.state(stage, "stageOf", body.node)
        yield stage
    yield body.node
