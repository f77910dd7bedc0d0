"""How large the shapes of a body are: their volumes, and how far they extend."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from kinlint.facts.frame_placement import Placements
from kinlint.facts.linear_algebra import Vector, length, subtract
from kinlint.facts.metamodel_terms import kin
from kinlint.facts.predicate_index import PredicateIndex, Table
from kinlint.facts.units import LENGTH, Units
from kinlint.terms import Term

COLLISION = kin("CollisionGeometry")
KINDS = tuple(kin(name) for name in ("Box", "Sphere", "Cylinder", "Capsule"))
BOX, SPHERE, CYLINDER = KINDS[:3]
MESH = kin("mesh")


@dataclass(frozen=True, slots=True)
class Shape:
    """One shape of a body: its volume in m³, its largest extent in m, and the node it is of.

    `sizes` in m: of a box its edges, else the radius and the length, if it has one.
    """

    volume: float
    extent: float
    node: Term
    collides: bool
    kind: Term
    sizes: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Extents:
    """What is known of the shapes of one body: the largest extent of all that are drawn or hit.

    None where a mesh, or a shape of unknown size or place, leaves it open.
    """

    extent: float | None
    least_volume: float | None
    greatest_volume: float | None


UNKNOWN = Extents(None, None, None)


class BodyShapes:
    """The shapes of each body."""

    def __init__(self, scan: PredicateIndex, units: Units) -> None:
        self.scan = scan
        self.units = units
        self._known: dict[Term, Extents] = {}

    @cached_property
    def references(self) -> Mapping[Term, list[Term]]:
        """The nodes that give each body a shape."""
        known = self.scan.instances(kin("GeometryReference"))
        found: dict[Term, list[Term]] = {}
        for node, body in self.scan.single(kin("of-body")).items():
            if node in known:
                found.setdefault(body, []).append(node)
        return found

    def of(self, body: Term) -> Extents:
        """How large *body* is by its shapes."""
        if body not in self._known:
            self._known[body] = self._extents(body)
        return self._known[body]

    def _extents(self, body: Term) -> Extents:
        shapes = [self._shape(node) for node in self.references.get(body, ())]
        known = [shape for shape in shapes if shape is not None]
        if not known or len(known) < len(shapes):
            return UNKNOWN
        sums = [
            sum(each.volume for each in known if each.collides is side) for side in (True, False)
        ]
        volumes = [each for each in sums if each > 0.0]
        return Extents(self._extent(known), min(volumes, default=None), max(volumes, default=None))

    def _extent(self, shapes: list[Shape]) -> float | None:
        """At most how far apart two points of *shapes* are."""
        if len(shapes) == 1:
            return shapes[0].extent
        middles = [self._middle(shape.node) for shape in shapes]
        known = [middle for middle in middles if middle is not None]
        if len(known) < len(shapes):
            return None
        reaches = (
            length(subtract(middle, known[0])) + shape.extent / 2.0
            for middle, shape in zip(known, shapes, strict=True)
        )
        return 2.0 * max(reaches)

    def outside(self, body: Term, point: Vector) -> float | None:
        """How far *point* is from the nearest ball about a shape of *body*, if all are known."""
        shapes = [self._shape(node) for node in self.references.get(body, ())]
        known = [(shape, self._middle(shape.node)) for shape in shapes if shape is not None]
        if not known or len(known) < len(shapes):
            return None
        gaps = [
            length(subtract(point, middle)) - shape.extent / 2.0
            for shape, middle in known
            if middle is not None
        ]
        return min(gaps) if len(gaps) == len(known) else None

    def sole(self, body: Term) -> Shape | None:
        """The one shape that *body* is hit by, or else is seen as, if it is simple."""
        nodes = self.references.get(body, ())
        chosen = [node for node in nodes if node in self._solid] or nodes
        return self._shape(chosen[0]) if len(chosen) == 1 else None

    def uniform(self, body: Term) -> Shape | None:
        """The simple shape that *body* is both hit by and seen as, where nothing else is."""
        shapes = [self._shape(node) for node in self.references.get(body, ())]
        forms = {(each.kind, each.sizes) if each is not None else None for each in shapes}
        return shapes[0] if len(forms) == 1 else None

    def form(self, body: Term) -> frozenset[tuple[object, ...]]:
        """What the shapes of *body* look like, wherever they are."""
        return frozenset(self._form(node) for node in self.references.get(body, ()))

    def _form(self, node: Term) -> tuple[object, ...]:
        meshes = tuple(sorted(self._meshes.of(node)))
        shape = self._shape(node)
        return meshes or ((shape.kind, *shape.sizes) if shape is not None else (node,))

    def _shape(self, node: Term) -> Shape | None:
        """The shape of *node*, where it has one simple form and its size is known."""
        kind = self._kinds.get(node)
        unit = self.units.measuring(node, LENGTH)
        if kind is None or unit is None or node in self._meshes:
            return None
        size = self._size(node, kind)
        if size is None or min(size) <= 0.0:
            return None
        metres = tuple(unit.si(each) for each in size)
        volume, extent = _measures(kind, metres)
        collides = node in self._solid
        return Shape(volume, extent, node, collides, kind, metres)

    @cached_property
    def _kinds(self) -> Mapping[Term, Term]:
        """The simple form of each shape: of several, the first of `KINDS`."""
        return {node: kind for kind in reversed(KINDS) for node in self.scan.instances(kind)}

    @cached_property
    def _meshes(self) -> Table:
        return self.scan.table(MESH)

    @cached_property
    def _solid(self) -> frozenset[Term]:
        return self.scan.instances(COLLISION)

    def _size(self, node: Term, kind: Term) -> tuple[float, ...] | None:
        """Three edges, a radius, or a radius and a length."""
        if kind == BOX:
            return self._boxes.get(node)
        names = ("radius",) if kind == SPHERE else ("radius", "length")
        found = tuple(self.scan.numbers(kin(name)).get(node) for name in names)
        known = tuple(each for each in found if each is not None)
        return known if len(known) == len(found) else None

    @cached_property
    def _boxes(self) -> Mapping[Term, tuple[float, ...]]:
        return self.scan.lists(kin("size"), 3)

    def _middle(self, node: Term) -> Vector | None:
        """Where the shape is on its link; None where that is not known."""
        placed = self._placements.of_shape(node)
        return placed.point if placed is not None else None

    @cached_property
    def _placements(self) -> Placements:
        return Placements(self.scan)


def _measures(kind: Term, size: tuple[float, ...]) -> tuple[float, float]:
    """Volume, and the largest distance between two points."""
    if kind == BOX:
        return math.prod(size), math.hypot(*size)
    radius = size[0]
    ball = 4.0 / 3.0 * math.pi * radius**3
    if kind == SPHERE:
        return ball, 2.0 * radius
    column = math.pi * radius**2 * size[1]
    if kind == CYLINDER:
        return column, math.hypot(2.0 * radius, size[1])
    return column + ball, size[1] + 2.0 * radius
