"""Bodies that the frames of an SDF file are attached to, and poses in the zero configuration.

Everything is computed along the references from frame to frame, once for each frame.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import dropwhile
from typing import TypeAlias, TypeVar

from kinlint.formats.rigid_transform import IDENTITY, Transform, composed, inverse, transform
from kinlint.formats.sdf.scopes import WORLD, Scopes, UnknownName
from kinlint.formats.sdf.sdf_elements import SdfElement
from kinlint.light_dataclasses import dataclass, field

Found: TypeAlias = SdfElement | None
"""An element, or None for what is unknown."""
Why: TypeAlias = Callable[[SdfElement], tuple[SdfElement, str, str] | None]
"""Returns the element with a reference, its role and the name, as in `CircularReference`."""
Value = TypeVar("Value")


@dataclass(frozen=True)
class CircularReference:
    """Frames that refer to each other in a circle."""

    owner: SdfElement
    """The first of them."""
    carrier: SdfElement
    """The element with its reference."""
    role: str
    """Attribute or text of the reference."""
    written: str
    """The name."""
    members: tuple[SdfElement, ...]
    """The others."""


@dataclass
class Frames:
    """The frames in *scopes*."""

    scopes: Scopes
    """Scopes of the names."""
    circles: list[CircularReference] = field(default_factory=list)
    """The circles that were met on the way."""
    _bases: dict[SdfElement, Found] = field(default_factory=dict)
    _bodies: dict[SdfElement, Found] = field(default_factory=dict)
    _places: dict[SdfElement, Transform | None] = field(default_factory=dict)
    _reported: set[tuple[SdfElement, str]] = field(default_factory=set)

    def find(self, name: str, owner: SdfElement) -> Found:
        """Return the element that *owner* calls *name* in its scope."""
        return _known(self.scopes.find(name, owner))

    # Poses

    def pose(self, element: SdfElement) -> SdfElement | None:
        """Return the `pose` of *element*; that of an include counts instead of the model's own."""
        include = self.scopes.included.get(element)
        return (include.first("pose") if include else None) or element.first("pose")

    def base(self, element: SdfElement) -> Found:
        """Return the frame that sees the pose of *element*: one in its scope, or a world."""
        if element not in self._bases:
            pose = self.pose(element)
            attributes = pose.attributes if pose else {}
            name = attributes.get("relative_to") or attributes.get("frame", "")
            if pose is not None and name:
                self._bases[element] = self.find(name, element)
            elif element.tag == "joint":
                self._bases[element] = self.end(element, "child")
            elif element.tag == "frame" and element.attributes.get("attached_to"):
                self._bases[element] = self._attached(element)
            else:
                self._bases[element] = element.holder
        return self._bases[element]

    def end(self, joint: SdfElement, tag: str) -> Found:
        """Return the frame that *joint* names as its parent or child."""
        end = joint.first(tag)
        name = end.text.strip() if end else ""
        if end is None or not name:
            return None
        if name == WORLD and name not in self.scopes.enclosing[joint].names:
            return self.scopes.outermost(joint)
        return self.find(name, joint)

    def pose_in_world(self, element: SdfElement) -> Transform | None:
        """Return the pose of *element* in its world, if it can be computed."""

        def world(at: SdfElement) -> Transform | None:
            return None if at in self.scopes.enclosing else IDENTITY

        path, seen = self._walk(element, self.base, self._places, world, self._why_posed)
        for each in reversed(path):
            if each not in self._places:
                own = self._own(each)
                self._places[each] = None if seen is None or own is None else composed(seen, own)
            seen = self._places[each]
        return self._places[element]

    def _own(self, element: SdfElement) -> Transform | None:
        """Return the pose of *element* as its base sees it."""
        own = transform_of(self.pose(element))
        if own is None or element.tag != "model":
            return own
        inner = self._placed_by(element)
        return own if inner is None else composed(own, inverse(inner))

    def _placement_frame(self, model: SdfElement) -> str:
        include = self.scopes.included.get(model)
        placement = include.first("placement_frame") if include else None
        if placement is not None:
            return placement.text.strip()
        return model.attributes.get("placement_frame", "")

    def _placed_by(self, model: SdfElement) -> Transform | None:
        """Return the pose, in *model*, of the frame that the pose of *model* is meant to place."""
        name = self._placement_frame(model)
        if not name:
            return None
        found = _known(self.scopes.find_inside(name, model))
        at, pose, seen = found, IDENTITY, {model}
        while at is not None and at not in seen and at in self.scopes.enclosing:
            seen.add(at)
            own = self._own(at)
            if own is None:
                return None
            pose = composed(own, pose)
            at = self.base(at)
        return pose if at is model else None

    # Bodies

    def body(self, element: SdfElement) -> Found:
        """Return the link that *element* is attached to, or a world."""

        def itself(at: SdfElement) -> Found:
            return at if at.tag == "link" or at not in self.scopes.enclosing else None

        path, found = self._walk(element, self._carrier, self._bodies, itself, self._why_attached)
        for each in path:
            self._bodies.setdefault(each, found)
        return self._bodies[element]

    def _carrier(self, element: SdfElement) -> Found:
        """Return the element that *element* is attached to."""
        if element.tag == "joint":
            return self.end(element, "child")
        if element.tag == "model":
            return self.canonical(element)
        return self._attached(element) if element.attributes.get("attached_to") else element.holder

    def _attached(self, frame: SdfElement) -> Found:
        return self.find(frame.attributes["attached_to"], frame)

    def canonical(self, model: SdfElement) -> Found:
        """Return the link, or the model, that the frame of *model* is attached to."""
        name = model.attributes.get("canonical_link", "")
        if name:
            return _known(self.scopes.find_inside(name, model))
        scope = self.scopes.own[model]
        own = model.first("link")
        every = [own] if own else [*scope.names.values()]
        links = (each for each in every if each.tag == "link" and each is not model)
        models = (each for each in every if each.tag == "model" and each is not model)
        return next(links, None) or next(models, None)

    # Walks from element to element

    def _walk(
        self,
        start: SdfElement,
        following: Callable[[SdfElement], Found],
        known: dict[SdfElement, Value | None],
        end: Callable[[SdfElement], Value | None],
        why: Why,
    ) -> tuple[Sequence[SdfElement], Value | None]:
        """Return the path from *start* to the first element with a value, and that value.

        Values are *known*, or those of an *end*. There is none where the path leads nowhere, nor in
        a circle, which is noted by *why* each element leads to the next.
        """
        path: dict[SdfElement, None] = {}
        at: Found = start
        while at is not None and at not in known:
            value = end(at)
            if value is not None:
                known[at] = value
            elif at in path:
                self._circular(_from(at, path), why)
                known.update(path)
            else:
                path[at] = None
                at = following(at)
        return list(path), None if at is None else known[at]

    def _circular(
        self,
        cycle: list[SdfElement],
        why: Why,
    ) -> None:
        """Note a cycle once, where it says so first."""
        order = sorted(cycle, key=lambda each: each.order)
        for each in order:
            reason = why(each)
            if reason is not None:
                carrier, role, name = reason
                others = tuple(other for other in order if other is not each)
                if (carrier, role) not in self._reported:
                    self._reported.add((carrier, role))
                    self.circles.append(CircularReference(each, carrier, role, name, others))
                return

    def _why_posed(self, element: SdfElement) -> tuple[SdfElement, str, str] | None:
        pose = self.pose(element)
        if pose is not None:
            for name in ("relative_to", "frame"):
                if pose.attributes.get(name):
                    return pose, "relative_to", pose.attributes[name]
        return self._why_attached(element)

    @staticmethod
    def _why_attached(element: SdfElement) -> tuple[SdfElement, str, str] | None:
        if element.tag == "frame" and element.attributes.get("attached_to"):
            return element, "attached_to", element.attributes["attached_to"]
        child = element.first("child") if element.tag == "joint" else None
        return (child, "child", child.text.strip()) if child is not None else None


def _known(found: SdfElement | UnknownName) -> Found:
    return found if isinstance(found, SdfElement) else None


def _from(first: SdfElement, path: Iterable[SdfElement]) -> list[SdfElement]:
    """Return the end of *path* that begins with *first*."""
    return list(dropwhile(lambda each: each is not first, path))


def transform_of(pose: SdfElement | None) -> Transform | None:
    """Return the transform of *pose*; a missing pose and an empty one are the identity."""
    if pose is None or not (pose.numbers or pose.text.strip()):
        return IDENTITY
    degrees = pose.attributes.get("degrees", "").lower() in ("true", "1")
    return transform(pose.numbers, degrees=degrees)
