"""Statements about actuators, tendons and equalities: the parts of a model that they join."""

from __future__ import annotations

from itertools import pairwise

from kinlint.formats.mjcf.body_statements import is_limited, joint_type
from kinlint.formats.mjcf.compiled_model import CompiledBody, CompiledModel, CompiledPart
from kinlint.formats.mjcf.default_classes import ACTUATORS
from kinlint.formats.mjcf.mjcf_elements import MjcfElement
from kinlint.formats.mjcf.model_statements import ModelStatements
from kinlint.formats.mjcf.tendon_couplings import tendon_coupling
from kinlint.formats.rigid_transform import IDENTITY, Transform, between, composed
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import literal

COEFFICIENTS = (0.0, 1.0, 0.0, 0.0, 0.0)
JOINTS = ("joint", "jointinparent")


@dataclass
class RelationStatements:
    """Statements about what refers to the bodies and joints of *model*."""

    model: CompiledModel
    """The model."""
    said: ModelStatements
    """The statements."""
    _names: dict[tuple[str, str], CompiledBody | CompiledPart] = field(default_factory=dict)

    def state(self) -> None:
        """State all actuators, tendons and equalities of the main file."""
        self._names = {
            **{("body", each.name): each for each in self.model.bodies},
            **{("joint", each.name): each for body in self.model.bodies for each in body.joints},
            **{("site", e.name): e for body in self.model.bodies for e in body.parts
               if e.element.tag == "site"},
        }  # fmt: skip
        for section in self.model.root.all("actuator"):
            for each in section.all(*ACTUATORS):
                self._actuator(each)
        for section in self.model.root.all("equality"):
            for each in section.content():
                self._equality(each)
        for section in self.model.root.all("asset"):
            for each in section.all("mesh"):
                self._file(each)
        for section in self.model.root.all("tendon"):
            for each in section.content():
                self._tendon(each)

    def _joint(self, name: str) -> CompiledPart | None:
        found = self._names.get(("joint", name)) if name else None
        return found if isinstance(found, CompiledPart) else None

    def _file(self, element: MjcfElement) -> None:
        """State the path of the file of a mesh, from the folder of the main file."""
        self.said.copy(element.node, element)
        file, settings = element.text("file").replace("\\", "/"), self.model.settings
        if not file:
            return
        folder = settings.text("meshdir") or settings.text("assetdir")
        if settings.text("strippath") == "true":
            file = file.rpartition("/")[2]
        joined = file if file.startswith("/") or not folder else f"{folder.rstrip('/')}/{file}"
        of = element.said["file"][0] if joined == element.text("file") else None
        self.said.state(element.node, "path", literal(joined), of)

    def _actuator(self, element: MjcfElement) -> None:
        self.said.copy(element.node, element)
        settings = self.model.settings
        for name in JOINTS:
            joint = self._joint(element.text(name))
            if joint is not None:
                self.said.state(element.node, "actuates", joint.node)
                type_ = joint_type(joint.element)
                self.said.truth(element.node, "linear", value=type_ == "slide")
        for limited, range_ in (("ctrllimited", "ctrlrange"), ("forcelimited", "forcerange")):
            value = is_limited(element, settings, limited, range_)
            self.said.truth(element.node, limited, value=value)
            self.said.undecided(element.node, element, settings, limited, range_)

    def _tendon(self, element: MjcfElement) -> None:
        """State the order of the path of a tendon."""
        self.said.copy(element.node, element)
        settings = self.model.settings
        self.said.truth(element.node, "limited", value=is_limited(element, settings))
        self.said.undecided(element.node, element, settings, "limited", "range")
        path = [*element.content()]
        for before, after in pairwise(path):
            self.said.state(after.node, "follows", before.node)

    def _equality(self, element: MjcfElement) -> None:
        self.said.copy(element.node, element)
        if element.tag == "joint":
            self._coupling(element)
        elif element.tag == "tendon":
            self._tendons(element)
        elif element.tag in ("connect", "weld"):
            self._loop(element)

    def _coupling(self, element: MjcfElement) -> None:
        self._coupled(element, element.text("joint1"), element.text("joint2"))
        given = element.numbers("polycoef")
        polynomial = (*given, *COEFFICIENTS[len(given) :])
        self.said.truth(element.node, "linearLaw", value=not any(polynomial[2:]))

    def _tendons(self, element: MjcfElement) -> None:
        coupling = tendon_coupling(element, self.model.root)
        if coupling is not None:
            self._coupled(element, coupling.follower, coupling.leader)
            self.said.truth(element.node, "linearLaw", value=True)
            self.said.number(element.node, "multiplier", coupling.multiplier)
            self.said.number(element.node, "offset", coupling.offset)

    def _coupled(self, element: MjcfElement, follower: str, leader: str) -> None:
        """State the joints that *element* couples, by their names."""
        following, led = self._joint(follower), self._joint(leader)
        if following is not None:
            self.said.state(element.node, "follower", following.node)
            linear = joint_type(following.element) == "slide"
            self.said.truth(element.node, "linear", value=linear)
        if led is not None:
            self.said.state(element.node, "leader", led.node)

    def _loop(self, element: MjcfElement) -> None:
        """State the bodies that an equality joins, and the place of their common point on each."""
        for kind in ("body", "site"):
            if element.text(f"{kind}1"):
                self._ends(element, kind)

    def _ends(self, element: MjcfElement, kind: str) -> None:
        first, second = (
            self._names.get((kind, element.text(f"{kind}{number}"))) for number in (1, 2)
        )
        if kind == "body" and not element.text("body2") and self.model.bodies:
            second = self.model.bodies[0]
        if first is None or second is None:
            return
        one, other = _owner(first), _owner(second)
        self.said.state(element.node, "firstBody", one.node)
        self.said.state(element.node, "secondBody", other.node)
        places = _drawn(one), _drawn(other)
        if isinstance(first, CompiledPart) and isinstance(second, CompiledPart):
            self.said.pose(element.node, "first", first.place)
            self.said.pose(element.node, "second", second.place)
            return
        anchor = [*element.numbers("anchor"), 0.0, 0.0, 0.0][:3]
        at: Transform = (anchor[0], anchor[1], anchor[2]), IDENTITY[1]
        if places[0] is None or places[1] is None:
            return
        if element.tag == "connect":
            self.said.pose(element.node, "first", at)
            self.said.pose(element.node, "second", between(places[1], composed(places[0], at)))
        elif not any(element.numbers("relpose")[3:]):
            self.said.pose(element.node, "first", between(places[0], places[1]))
            self.said.pose(element.node, "second", IDENTITY)


def _owner(found: CompiledBody | CompiledPart) -> CompiledBody:
    return found.body if isinstance(found, CompiledPart) else found


def _drawn(body: CompiledBody) -> Transform | None:
    """Return the pose of *body* in the world as it is drawn."""
    place: Transform | None = IDENTITY
    at: CompiledBody | None = body
    while at is not None:
        place = composed(at.place, place) if place is not None and at.place is not None else None
        at = at.parent
    return place
