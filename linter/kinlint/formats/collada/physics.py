"""Masses and shapes of the links of a COLLADA document, by the nodes that rigid bodies move.

Nothing leads from a link to a rigid body: they meet in a node of the visual scene. A mass frame is
that of the physics model, not of the link; what is stated is the pose in the link, as OpenRAVE and
collada_parser work it out.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import hypot

from kinlint.formats.collada.addressing import Addressing
from kinlint.formats.collada.asset_units import metres
from kinlint.formats.collada.collada_elements import ColladaElement
from kinlint.formats.collada.drawn_links import state_drawn_elsewhere
from kinlint.formats.collada.kinematics import Model
from kinlint.formats.collada.parameter_values import meant_by
from kinlint.formats.collada.transforms import place, world_place
from kinlint.formats.derived_statements import DerivedStatements
from kinlint.formats.rigid_transform import IDENTITY, Transform, between, composed, inverse
from kinlint.light_dataclasses import dataclass

NODES = ("node", "instance_node")
SOLIDS = ("box", "sphere", "cylinder", "capsule")


@dataclass(eq=False)
class BodyInstance:
    """Rigid body where a physics scene instances it."""

    instance: ColladaElement
    """The instance_rigid_body."""
    body: ColladaElement
    """The rigid_body."""
    model: Transform
    """Pose of the physics model in the scene."""

    def first(self, tag: str) -> ColladaElement | None:
        """Return the element *tag* that counts: of the instance, and else of the body."""
        own = self.instance.first("technique_common", tag)
        return own if own is not None else self.body.first("technique_common", tag)

    def shapes(self) -> Iterator[ColladaElement]:
        """Yield the shapes, of the instance if it has any."""
        for holder in (self.instance, self.body):
            technique = holder.first("technique_common")
            found = [*technique.all("shape")] if technique is not None else []
            yield from found
            if found:
                return


def link_nodes(
    root: ColladaElement, models: Sequence[Model], addressing: Addressing
) -> dict[ColladaElement, ColladaElement]:
    """Return the nodes of the visual scenes that show links, by link."""
    moved: dict[ColladaElement | None, ColladaElement] = {}
    roots: dict[ColladaElement | None, ColladaElement] = {
        each.element: link for each in models for link in each.roots[:1]
    }
    for joint in (each for model in models for each in model.joints):
        for motion in joint.primitives:
            moved.setdefault(motion, joint.child)
    found: dict[ColladaElement, ColladaElement] = {}
    for bind in root.below():
        if bind.tag == "bind_joint_axis":
            target = addressing.by_path(bind.text("target"), bind)
            link = moved.get(_followed(addressing, bind.first("axis")))
            node = target.parent if isinstance(target, ColladaElement) else None
        elif bind.tag == "bind_kinematics_model":
            target = addressing.by_path(bind.text("node"), bind)
            link = roots.get(_model(addressing, bind))
            node = target if isinstance(target, ColladaElement) else None
        else:
            continue
        if link is not None and node is not None and node.tag in NODES:
            found.setdefault(link, node)
    return found


def _model(addressing: Addressing, bind: ColladaElement) -> ColladaElement | None:
    """Return the kinematics model that *bind* ties to a node."""
    meant = _followed(addressing, bind)
    if meant is not None and meant.tag == "instance_kinematics_model":
        return addressing.instanced(meant)
    return meant


def _followed(addressing: Addressing, holder: ColladaElement | None) -> ColladaElement | None:
    """Return what the parameter or the path in *holder* leads to."""
    named = holder and (holder.first("param") or holder.first("SIDREF"))
    return meant_by(named, addressing) if named is not None else None


class PhysicsStatements:
    """Statements about the masses and shapes of the links of *models*."""

    def __init__(
        self,
        root: ColladaElement,
        models: Sequence[Model],
        addressing: Addressing,
        said: DerivedStatements,
    ) -> None:
        self.root, self.models, self.addressing, self.said = root, models, addressing, said
        self.nodes = link_nodes(root, models, addressing)
        self.bodies: dict[ColladaElement, BodyInstance] = {}
        self._take_bodies()

    def _take_bodies(self) -> None:
        """Find the bodies by the nodes that they move, and state what moves or is moved again."""
        first: dict[tuple[ColladaElement | None, ColladaElement], BodyInstance] = {}
        for body in self._instances():
            target = self.addressing.by_uri(body.instance.text("target"))
            if not isinstance(target, ColladaElement):
                continue
            if self.bodies.setdefault(target, body) is not body:
                before = self.bodies[target]
                self.said.state(body.instance.node, "movesAfter", before.body.node)
            placed = first.setdefault((body.instance.parent, body.body), body)
            if placed is not body:
                self.said.state(body.instance.node, "instancedAfter", placed.instance.node)

    def state(self) -> None:
        """State the nodes that show links, and all links that have a rigid body."""
        for link, node in self.nodes.items():
            self.said.state(link.node, "shownIn", node.node)
        for model in self.models:
            places = self._places(model)
            centres = list[tuple[ColladaElement, float, float]]()
            for link in model.links:
                body = self.bodies.get(self.nodes[link]) if link in self.nodes else None
                if body is not None and link in places:
                    centres += self._link(link, body, between(places[link], body.model))
            self._mass_frames(centres)
            state_drawn_elsewhere(model, self.nodes, self.root, self.addressing, self.said)

    def _mass_frames(self, centres: Sequence[tuple[ColladaElement, float, float]]) -> None:
        """State the mass frames that look as if links saw them.

        *centres* are mass frames with the squared distances of the origin from the link and from
        the physics model, of links whose frames are not that of the model.
        """
        from_link = sum(square for _, square, _ in centres)
        from_model = sum(square for _, _, square in centres)
        if len(centres) >= FEWEST_BODIES and from_model * FARTHER**2 < from_link:
            for axes, _, _ in centres:
                origin = axes.first("translate")
                self.said.state(axes.node, "seenByLink", (origin or axes).node)

    def _instances(self) -> Iterator[BodyInstance]:
        """Yield the rigid bodies of all physics scenes whose models stand at a known place."""
        for instance in self.root.below():
            if instance.tag != "instance_physics_model":
                continue
            model, parent = self.addressing.instanced(instance), instance.text("parent")
            node = self.addressing.by_uri(parent) if parent else None
            at = world_place(node, metres(node)) if isinstance(node, ColladaElement) else IDENTITY
            if model is None or at is None:
                continue
            for each in instance.all("instance_rigid_body"):
                body = self.addressing.by_path(each.text("body"), each)
                if isinstance(body, ColladaElement) and body.tag == "rigid_body":
                    yield BodyInstance(each, body, at)

    def _places(self, model: Model) -> dict[ColladaElement, Transform]:
        """Return the poses of the links of *model* in the scene at zero, as far as known."""
        found: dict[ColladaElement, Transform] = {}
        for link in model.roots[:1]:
            node = self.nodes.get(link)
            at = world_place(node, metres(node)) if node is not None else None
            if at is not None:
                found[link] = at
        moving = {joint.child: joint for joint in model.joints if joint.end is None}
        for link in model.links:
            joint = moving.get(link)
            if joint is None or joint.on_parent is None or joint.on_child is None:
                continue
            if joint.parent in found:
                at = composed(found[joint.parent], joint.on_parent)
                found[link] = composed(at, inverse(joint.on_child))
        return found

    def _link(
        self, link: ColladaElement, body: BodyInstance, frame: Transform
    ) -> Iterator[tuple[ColladaElement, float, float]]:
        """State mass, inertia and shapes of *link*, which sees the physics model at *frame*.

        Yield the mass frame as `_mass_frames` takes it.
        """
        said, node = self.said, link.node
        mass, inertia, axes = (body.first(tag) for tag in ("mass", "inertia", "mass_frame"))
        said.state(node, "rigidBody", body.body.node)
        unit = metres(body.body)
        if mass is not None:
            said.state(node, "mass", mass.node)
        self._substitutes(link, body)
        if inertia is not None and len(inertia.numbers()) == 3:  # noqa: PLR2004  moments
            said.state(node, "inertia", inertia.node)
            names = ("moment-x", "moment-y", "moment-z")
            for name, value in zip(names, inertia.numbers(), strict=True):
                said.number(node, name, value * unit * unit)
        own = place(axes, metres(axes)) if axes is not None else IDENTITY
        if own is not None:
            if axes is not None:
                said.state(node, "massFrame", axes.node)
            centre = composed(frame, own)
            said.pose(node, "centre", centre)
            if axes is not None and hypot(*frame[0]) > EQUAL:
                yield axes, hypot(*centre[0]) ** 2, hypot(*own[0]) ** 2
        for shape in body.shapes():
            self._shape(link, shape, frame, metres(shape))

    def _substitutes(self, link: ColladaElement, body: BodyInstance) -> None:
        """State what *link* has or needs in place of a mass."""
        for each in (one.first(tag) for one in body.shapes() for tag in ("mass", "density")):
            if each is not None:
                self.said.state(link.node, "shapeMass", each.node)
        dynamic = body.first("dynamic")
        if dynamic is not None and dynamic.text() == "false":
            self.said.state(link.node, "static", dynamic.node)

    def _shape(
        self, link: ColladaElement, shape: ColladaElement, frame: Transform, unit: float
    ) -> None:
        own = place(shape, unit)
        solid = next(shape.all(*SOLIDS), None)
        if own is None or solid is None:
            return
        sizes = _sizes(solid, unit)
        if not sizes:
            return
        said, node = self.said, shape.node
        said.state(node, "onBody", link.node)
        said.word(node, "shape", solid.tag)
        said.state(node, "solid", solid.node)
        said.numbers(node, (f"size-{number + 1}" for number in range(len(sizes))), sizes)
        turned = AXIS_Y if solid.tag in ("cylinder", "capsule") else IDENTITY
        said.pose(node, "placed", composed(composed(frame, own), turned))


def _sizes(solid: ColladaElement, unit: float) -> list[float]:
    """Return the sizes of *solid* in metres: edges, or radius and height; none if not known."""
    if solid.tag == "box":
        edges = solid.first("half_extents")
        halves = edges.numbers() if edges is not None else []
        return [2 * each * unit for each in halves]
    radius, height = solid.first("radius"), solid.first("height")
    radii = _numbers(radius) if radius is not None else []
    if not radii or max(radii) - min(radii) > EQUAL * max(map(abs, radii)):
        return []
    if solid.tag == "sphere":
        return [radii[0] * unit]
    heights = _numbers(height) if height is not None else []
    return [radii[0] * unit, heights[0] * unit] if heights else []


def _numbers(element: ColladaElement) -> list[float]:
    if element.components:
        return element.numbers()
    try:
        return [float(element.text())]
    except ValueError:
        return []


FEWEST_BODIES = 2
FARTHER = 2.0
"""Ratio of the distances of centres of mass from their links to those from the model, above which
the mass frames look as if links saw them."""
EQUAL = 1e-9
"""Radii that differ by more than this share are those of an ellipse."""
AXIS_Y: Transform = (0.0, 0.0, 0.0), (-(0.5**0.5), 0.0, 0.0, 0.5**0.5)
"""Turns axis z to axis y, along which COLLADA's cylinders and capsules stand."""
