"""Shapes of bodies: their volumes, and how far they extend."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import cached_property

from kinlint.facts.frame_placement import ATTACHED_TO, Placements
from kinlint.facts.linear_algebra import Vector, length, subtract
from kinlint.facts.metamodel_terms import kin
from kinlint.facts.predicate_index import PredicateIndex, Table
from kinlint.facts.units import LENGTH, Units
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term

COLLISION = kin("CollisionGeometry")
KINDS = tuple(kin(name) for name in ("Box", "Sphere", "Cylinder", "Capsule"))
BOX, SPHERE, CYLINDER, CAPSULE = KINDS
MESH = kin("mesh")
REACH = 4.0
"""Distance in m beyond which no mesh of a link extends from where it is placed."""


@dataclass(frozen=True, slots=True)
class Shape:
    """Primitive shape of a body."""

    volume: float
    """Volume in m³."""
    extent: float
    """Largest distance between two of its points in m."""
    node: Term
    """Node that gives the body the shape."""
    collides: bool
    """True for collision shapes, False for visual ones."""
    kind: Term
    """Class of the primitive."""
    sizes: tuple[float, ...]
    """Edges of a box in m, else the radius and the length, if there is one."""


@dataclass(frozen=True, slots=True)
class Extents:
    """Size of one body by its shapes.

    None where a mesh, or a shape of unknown size or place, leaves it open.
    """

    extent: float | None
    """Upper bound of the distance in m between two points of all shapes."""
    least_volume: float | None
    """Volume in m³ of the visual or the collision shapes, the smaller of both."""
    greatest_volume: float | None
    """Volume in m³ of the visual or the collision shapes, the larger of both."""


UNKNOWN = Extents(None, None, None)


class BodyShapes:
    """Shapes of each body of a model."""

    def __init__(self, scan: PredicateIndex, units: Units, placements: Placements) -> None:
        self.scan = scan
        self.placements = placements
        self.units = units
        self._known: dict[Term, Extents] = {}

    @cached_property
    def references(self) -> Mapping[Term, list[Term]]:
        """Nodes that give each body a shape."""
        known = self.scan.instances(kin("GeometryReference"))
        found: dict[Term, list[Term]] = {}
        for node, body in self.scan.single(kin("of-body")).items():
            if node in known:
                found.setdefault(body, []).append(node)
        return found

    def extents(self, body: Term) -> Extents:
        """Return the size of *body* by its shapes."""
        if body not in self._known:
            self._known[body] = self._extents(body)
        return self._known[body]

    def _extents(self, body: Term) -> Extents:
        shapes = [self.shape(node) for node in self.references.get(body, ())]
        known = [shape for shape in shapes if shape is not None]
        if not known or len(known) < len(shapes):
            return UNKNOWN
        sums = [
            sum(each.volume for each in known if each.collides is side) for side in (True, False)
        ]
        volumes = [each for each in sums if each > 0.0]
        return Extents(self._extent(known), min(volumes, default=None), max(volumes, default=None))

    def _extent(self, shapes: list[Shape]) -> float | None:
        """Return an upper bound in m of the distance between two points of *shapes*.

        None if unknown.
        """
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

    def distance(self, body: Term, point: Vector) -> tuple[float, float | None] | None:
        """Return the distance in m from *point* to the nearest shape of *body*, and its error.

        Shapes are bounding balls, inside of which it is negative, and those of unknown size points,
        so that the error is the size that they may have: that of the others, or else `REACH`. There
        is no error where all sizes are known, and no distance without shapes that are all placed.
        """
        nodes = self.references.get(body, ())
        shapes = {node: self.shape(node) for node in nodes}
        sizes = {node: shape.extent for node, shape in shapes.items() if shape is not None}
        gaps = [
            length(subtract(point, middle)) - sizes.get(node, 0.0) / 2.0
            for node in nodes
            if (middle := self._middle(node)) is not None
        ]
        if not gaps or len(gaps) < len(nodes):
            return None
        error = max(sizes.values(), default=REACH) if len(sizes) < len(nodes) else None
        return min(gaps), error

    def sole(self, body: Term) -> Shape | None:
        """Return the only collision shape of *body*, or else its only visual one.

        None if no primitive.
        """
        nodes = self.references.get(body, ())
        chosen = [node for node in nodes if node in self._solid] or nodes
        return self.shape(chosen[0]) if len(chosen) == 1 else None

    def uniform(self, body: Term) -> Shape | None:
        """Return the primitive that all visual and collision shapes of *body* are.

        None if they differ.
        """
        shapes = [self.shape(node) for node in self.references.get(body, ())]
        forms = {(each.kind, each.sizes) if each is not None else None for each in shapes}
        return shapes[0] if len(forms) == 1 else None

    def form(self, body: Term) -> frozenset[tuple[object, ...]]:
        """Return the forms of the shapes of *body*, wherever they are.

        Meshes, or primitives with sizes.
        """
        return frozenset(self._form(node) for node in self.references.get(body, ()))

    def meshes(self, node: Term) -> Sequence[Term]:
        """Return the files of the mesh *node*; none if it is no mesh."""
        return self._meshes.values(node)

    def collides(self, node: Term) -> bool:
        """Tell whether *node* is a collision shape."""
        return node in self._solid

    def _form(self, node: Term) -> tuple[object, ...]:
        meshes = tuple(sorted(self._meshes.values(node)))
        shape = self.shape(node)
        return meshes or ((shape.kind, *shape.sizes) if shape is not None else (node,))

    def shape(self, node: Term) -> Shape | None:
        """Return the shape of *node*, if it is one primitive of known, positive size."""
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
        """Return three edges, a radius, or a radius and a length, in the unit of the node."""
        if kind == BOX:
            return self._boxes.get(node)
        names = ("radius",) if kind == SPHERE else ("radius", "length")
        found = tuple(self.scan.numbers(kin(name)).get(node) for name in names)
        known = tuple(each for each in found if each is not None)
        return known if len(known) == len(found) else None

    @cached_property
    def _boxes(self) -> Mapping[Term, tuple[float, ...]]:
        return self.scan.lists(kin("size"), 3)

    def frame(self, node: Term) -> Term | None:
        """Return the frame along whose axes the shape *node* is drawn."""
        return self.scan.single(ATTACHED_TO).get(node)

    def _middle(self, node: Term) -> Vector | None:
        """Return the centre of a shape in the frame of its link, in m.

        None where it is not known.
        """
        placed = self.placements.shape_placement(node)
        return placed.point if placed is not None else None


def _measures(kind: Term, size: tuple[float, ...]) -> tuple[float, float]:
    """Return the volume in m³, and the largest distance between two points in m."""
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
