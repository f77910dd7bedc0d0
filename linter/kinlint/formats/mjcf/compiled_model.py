"""The model that MuJoCo's compiler makes of an MJCF file: bodies in bodies, and what is on them.

Frames are gone: what stands in them has their transformation. What is replicated or attached is
there as often as that says, each copy with a node and a name of its own.
"""

from __future__ import annotations

from collections.abc import Sequence

from kinlint.formats.mjcf.compiler_settings import CompilerSettings
from kinlint.formats.mjcf.element_copy import ElementCopy, ModelFile
from kinlint.formats.mjcf.mjcf_elements import MjcfElement
from kinlint.formats.mjcf.orientation import euler, unit
from kinlint.formats.rigid_transform import (
    IDENTITY,
    Transform,
    Vector,
    composed,
    rotated,
)
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.terms import Term

JOINTS = frozenset({"joint", "freejoint"})
PARTS = frozenset({"geom", "site", "camera", "light"})
UPWARD: Vector = (0.0, 0.0, 1.0)
MOST_PARTS = 20_000
"""The most bodies, parts and copies of a model; more are left out."""
MOST_DEEP = 200


@dataclass(eq=False)
class CompiledPart:
    """Joint, geom, site, camera, light or inertial of a body."""

    element: MjcfElement
    """Element that it is made of."""
    node: Term
    """Its node: that of the element, but for copies."""
    name: str
    """Its name in the model; empty if it has none."""
    body: CompiledBody
    """Body that it is on."""
    place: Transform | None
    """Its pose on the body; None if that cannot be computed."""
    frame: Transform | None = None
    """Pose on the body of the frame that it is written in; None like the pose."""
    axis: Vector | None = None
    """Of a joint its direction on the body, of length 1; None if it has none."""


@dataclass(eq=False)
class CompiledBody:
    """Rigid body, or the world."""

    element: MjcfElement
    """Element that it is made of."""
    node: Term
    """Its node: that of the element, but for copies."""
    name: str
    """Its name in the model; empty if it has none."""
    settings: CompilerSettings
    """Settings of the compiler of the model that it is written in."""
    parent: CompiledBody | None
    """The body around it; None for the world."""
    place: Transform | None
    """Its pose on the parent, as drawn; None if that cannot be computed."""
    joints: list[CompiledPart] = field(default_factory=list)
    """Its joints, the one nearest to the parent first."""
    parts: list[CompiledPart] = field(default_factory=list)
    """Its geoms, sites, cameras and lights."""
    inertial: CompiledPart | None = None
    """Its inertial, if it is written."""

    @property
    def moves(self) -> bool:
        """Tell whether it moves relative to the world."""
        at: CompiledBody | None = self
        while at is not None and not at.joints:
            at = at.parent
        return at is not None

    @property
    def geoms(self) -> list[CompiledPart]:
        """Its geoms."""
        return [each for each in self.parts if each.element.tag == "geom"]


@dataclass
class CompiledModel:
    """The bodies of a model, the world first, each before those in it."""

    root: MjcfElement
    """The root of the main file."""
    settings: CompilerSettings
    """The settings of the main file."""
    bodies: list[CompiledBody] = field(default_factory=list)
    """All bodies."""
    excessive: list[MjcfElement] = field(default_factory=list)
    """Elements of which there would be too many copies."""
    attached: list[tuple[MjcfElement, str]] = field(default_factory=list)
    """Roots of attached models, with the prefixes of their names."""
    repeated: list[tuple[MjcfElement, MjcfElement]] = field(default_factory=list)
    """Elements that attach what another one does, by the same prefix, and that one."""
    unmatched: list[tuple[MjcfElement, str, Sequence[str]]] = field(default_factory=list)
    """Elements with the attribute that names no part of their model, and names that it has."""
    _count: int = 0
    _files: dict[MjcfElement, ModelFile] = field(default_factory=dict)
    _attaching: dict[tuple[MjcfElement, str, str], MjcfElement] = field(default_factory=dict)

    @classmethod
    def from_root(cls, root: MjcfElement) -> CompiledModel:
        """Return the model of the file with *root*, whose elements get what they inherit."""
        file = ModelFile.from_root(root)
        model = cls(root, file.settings, _files={root: file})
        worlds = list(root.all("worldbody"))
        if worlds:
            top = worlds[0]
            world = CompiledBody(top, top.node, "world", file.settings, None, IDENTITY)
            model.bodies.append(world)
            copy = ElementCopy(file)
            for each in worlds:
                model._take(each, world, IDENTITY, copy, 0)
        return model

    def _take(
        self,
        holder: MjcfElement,
        body: CompiledBody,
        at: Transform | None,
        copy: ElementCopy,
        depth: int,
    ) -> None:
        """Take in what *holder* has, which is on *body*, in a frame that is there *at*."""
        if depth > MOST_DEEP:
            self.excessive.append(holder)
            return
        for each in holder.content():
            if self._count >= MOST_PARTS:
                self.excessive.append(each)
                return
            if each.tag == "body":
                self._count += 1
                inner = CompiledBody(
                    each, copy.node(each), copy.name(each), copy.file.settings, body,
                    _seen(at, copy.pose(each)),
                )  # fmt: skip
                self.bodies.append(inner)
                self._take(each, inner, IDENTITY, copy, depth + 1)
            elif each.tag == "frame":
                inside = replace(copy, scaled=copy.scaled or _is_scaled(each))
                self._take(each, body, _seen(at, copy.pose(each)), inside, depth + 1)
            elif each.tag == "replicate":
                self._replicate(each, body, at, copy, depth + 1)
            elif each.tag == "attach":
                self._attach(each, body, at, copy, depth + 1)
            elif each.tag in JOINTS or each.tag in PARTS or each.tag == "inertial":
                self._count += 1
                self._part(each, body, at, copy)

    def _part(
        self, element: MjcfElement, body: CompiledBody, at: Transform | None, copy: ElementCopy
    ) -> None:
        seen = _seen(at, copy.pose(element))
        part = CompiledPart(element, copy.node(element), copy.name(element), body, seen, at)
        if element.tag == "inertial":
            body.inertial = body.inertial or part
        elif element.tag in PARTS:
            body.parts.append(part)
        else:
            axis = unit(element.numbers("axis") or UPWARD)
            part.axis = rotated(at[1], axis) if axis is not None and at is not None else None
            body.joints.append(part)

    def _replicate(
        self,
        element: MjcfElement,
        body: CompiledBody,
        at: Transform | None,
        copy: ElementCopy,
        depth: int,
    ) -> None:
        count = element.number("count")
        if count > MOST_PARTS or count != count:  # noqa: PLR0124  not a number
            self.excessive.append(element)
            return
        offset = element.numbers("offset") or [0.0, 0.0, 0.0]
        angles = element.numbers("euler") or [0.0, 0.0, 0.0]
        turned = euler(angles, copy.file.settings) if len(angles) == len(UPWARD) else None
        step = None
        if turned is not None and len(offset) == len(UPWARD):
            step = (offset[0], offset[1], offset[2]), turned
        digits, separator = len(str(int(count) - 1)), element.text("sep")
        for number in range(int(count)):
            inner = ElementCopy(
                copy.file, copy.prefix,
                f"{separator}{number:0{digits}}{copy.suffix}", f"@{number}{copy.mark}",
                copy.scaled,
            )  # fmt: skip
            self._take(element, body, at, inner, depth)
            at = _seen(at, step)
            self._count += 1
            if self._count >= MOST_PARTS:
                self.excessive.append(element)
                return

    def _attach(
        self,
        element: MjcfElement,
        body: CompiledBody,
        at: Transform | None,
        copy: ElementCopy,
        depth: int,
    ) -> None:
        model = element.text("model")
        root = copy.file.models.get(model) if model else copy.file.root
        if root is None:
            return
        self._count += 1
        file = copy.file if root is copy.file.root else self._file(root)
        prefix = f"{copy.prefix}{element.text('prefix')}"
        mark = f"@{len(self.attached)}{copy.mark}"
        inner = ElementCopy(file, prefix, copy.suffix, mark, copy.scaled)
        self.attached.append((root, prefix))
        tag = next((each for each in ("body", "frame") if element.text(each)), "")
        first = self._attaching.setdefault((root, prefix, element.text(tag)), element)
        if first is not element:
            self.repeated.append((element, first))
        if not tag:
            for each in root.all("worldbody"):
                self._take(each, body, at, inner, depth)
            return
        found = file.named.get((tag, element.text(tag)))
        if found is None and model:
            names = [name for kind, name in file.named if kind == tag and name]
            self.unmatched.append((element, tag, names))
        if found is not None and not _is_around(found, element):
            stand_in = MjcfElement(element.node, "attach", None, element.type, {}, [found])
            self._take(stand_in, body, at, inner, depth)

    def _file(self, root: MjcfElement) -> ModelFile:
        """Return the file with *root*, whose elements get what they inherit."""
        if root not in self._files:
            self._files[root] = ModelFile.from_root(root)
        return self._files[root]


def _is_scaled(frame: MjcfElement) -> bool:
    return any(each != 1 for each in frame.numbers("scale"))


def _is_around(holder: MjcfElement, element: MjcfElement) -> bool:
    at: MjcfElement | None = element
    while at is not None and at is not holder:
        at = at.parent
    return at is holder


def _seen(outer: Transform | None, inner: Transform | None) -> Transform | None:
    return None if outer is None or inner is None else composed(outer, inner)
