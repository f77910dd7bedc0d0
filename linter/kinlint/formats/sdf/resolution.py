"""Resolution of the names and poses of an SDF file, which no query could compute.

Stated are the scope of each element, the frame that its pose is relative to, the bodies that a
joint connects and its poses on them, the direction of an axis in the joint frame, the joints that a
gearbox couples, and references that lead nowhere.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.formats.derived_statements import COMPONENTS, number
from kinlint.formats.rigid_transform import Transform, between, composed, rounded
from kinlint.formats.sdf.axis import AXES, direction
from kinlint.formats.sdf.format import SDF
from kinlint.formats.sdf.frames import CircularReference, Frames, transform_of
from kinlint.formats.sdf.gearbox import gears
from kinlint.formats.sdf.name_references import References
from kinlint.formats.sdf.scopes import Scopes, known_by_name
from kinlint.formats.sdf.sdf_elements import SdfElement
from kinlint.formats.source_layer import src
from kinlint.formats.xml.references import names
from kinlint.formats.xml.schema import schema
from kinlint.terms import Term, Triple

ENTITIES = ("model", "actor", "light")


def resolve_names(
    root: SdfElement, statements: Sequence[Triple]
) -> tuple[dict[Triple, Triple | None], list[CircularReference]]:
    """Return the triples and the circles that follow from *root* and all elements below it.

    The *statements* of the document have the names by which elements refer to others. A triple that
    follows from one of them has that as its value.
    """
    scopes = Scopes.below(root)
    resolution = _Resolution(root, scopes, Frames(scopes))
    leading = References(scopes).statements(names(statements, schema(SDF.name)))
    worked_out = dict.fromkeys(resolution.statements())
    return {**worked_out, **dict(leading)}, resolution.frames.circles


class _Resolution:
    def __init__(self, root: SdfElement, scopes: Scopes, frames: Frames) -> None:
        self.root = root
        self.scopes, self.frames = scopes, frames
        self.earth = f"{root.node[:-1]}/world>"

    def node(self, element: SdfElement) -> Term:
        """Return the node of *element*; that of the world also for a file that describes none."""
        return self.earth if element.tag == "sdf" else element.node

    def statements(self) -> Iterator[Triple]:
        """Yield all derived triples."""
        yield from self._left_out()
        for element, scope in self.scopes.enclosing.items():
            yield element.node, src("scope"), self.node(scope.element)
            self.frames.pose_in_world(element)
            base, body = self.frames.base(element), self.frames.body(element)
            if body is not None and element.tag in ("frame", "model"):
                yield element.node, src("attachedTo"), self.node(body)
            if element.tag != "link" and (element.tag != "joint" or self._moved(element)):
                yield from self._seen(element, body, base, self.frames.pose_in_world(element))
            if element.tag in ("link", "joint"):
                yield from self._parts(element, body)
            if element.tag == "joint":
                yield from self._joint(element)
        yield from self._gears()

    def _gears(self) -> Iterator[Triple]:
        joints = (each for each in self.scopes.enclosing if each.tag == "joint")
        for box, leader, follower, sense in gears(self.frames, joints):
            yield box.node, src("leader"), leader.node
            yield box.node, src("follower"), follower.node
            yield box.node, src("sense"), number(sense)

    def _left_out(self) -> Iterator[Triple]:
        """Yield the entities that readers ignore.

        They take one model, actor or light from a file.
        """
        files = [self.root, *(m.parent for m in self.scopes.included if m.parent is not None)]
        for root in dict.fromkeys(files):
            entities = [each for each in root.children if each.tag in ENTITIES]
            for each in entities[1:]:
                yield each.node, src("leftOutFor"), entities[0].node

    def _seen(
        self,
        element: SdfElement,
        body: SdfElement | None,
        base: SdfElement | None,
        place: Transform | None,
    ) -> Iterator[Triple]:
        """Yield the pose of *element* on its *body*.

        As written, if its *base* is on the body, too.
        """
        seer = self._seat(base) if base is not None else None
        pose = self.frames.pose(element)
        if body is None or place is None:
            return
        if seer is not None and self._fixed(element, seer, body):
            if pose is not None and pose.numbers:
                yield pose.node, src("poseOf"), element.node
                yield pose.node, src("relativeTo"), self.node(seer)
            else:
                yield element.node, src("coincidesWith"), self.node(seer)
        elif (on := self.frames.pose_in_world(body)) is not None:
            yield element.node, src("placedOn"), self.node(body)
            yield from _pose(element.node, "placed", between(on, place))

    def _fixed(self, element: SdfElement, seer: SdfElement, body: SdfElement) -> bool:
        """Tell whether *element* and *seer*, in whose frame its pose is, are fixed to *body*."""
        return element.tag != "model" and self.frames.body(seer) is body

    def _seat(self, element: SdfElement) -> SdfElement | None:
        """Return the element with the frame of *element*.

        A joint without a pose has that of its child.
        """
        at: SdfElement | None = element
        seen = set()
        while at is not None and at.tag == "joint" and not self._moved(at):
            if at in seen:
                return None
            seen.add(at)
            at = self.frames.end(at, "child")
        return at

    def _parts(self, element: SdfElement, body: SdfElement | None) -> Iterator[Triple]:
        """Yield the poses of what is in a link or a joint."""
        for part in element.children:
            pose = (
                part.first("pose")
                if part.tag not in (*known_by_name("model"), "inertial")
                else None
            )
            if pose is None:
                continue
            name = pose.attributes.get("relative_to") or pose.attributes.get("frame", "")
            seer = self.frames.find(name, element) if name else element
            seen, own = self.frames.pose_in_world(seer) if seer else None, transform_of(pose)
            if pose.numbers and seen is not None and own is not None:
                yield from self._seen(part, body, seer, composed(seen, own))

    def _joint(self, joint: SdfElement) -> Iterator[Triple]:
        place = self.frames.pose_in_world(joint)
        seat = self._seat(joint)
        if seat is not None:
            yield joint.node, src("childFrame"), self.node(seat)
        for tag in ("parent", "child"):
            end = self.frames.end(joint, tag)
            body = self.frames.body(end) if end is not None else None
            if body is None:
                continue
            yield joint.node, src(f"{tag}Body"), self.node(body)
            on = self.frames.pose_in_world(body)
            if tag == "parent" and place is not None and on is not None:
                yield from _pose(joint.node, tag, between(on, place))
        for axis in (each for each in joint.children if each.tag in AXES):
            xyz, own = axis.first("xyz"), direction(self.frames, joint, axis)
            if xyz is not None and own is not None:
                for component, value in zip("xyz", rounded(own), strict=True):
                    yield xyz.node, src(component), number(value)
            mimic = axis.first("mimic")
            leader = mimic.attributes.get("joint", "") if mimic else ""
            if mimic is not None and leader:
                found = self.frames.find(leader, joint)
                if found is not None:
                    yield mimic.node, src("leader"), found.node

    @staticmethod
    def _moved(joint: SdfElement) -> bool:
        pose = joint.first("pose")
        return pose is not None and bool(pose.numbers)


def _pose(node: Term, body: str, pose: Transform) -> Iterator[Triple]:
    for component, value in zip(COMPONENTS, rounded((*pose[0], *pose[1])), strict=True):
        yield node, src(f"{body}-{component}"), number(value)
