"""The one visual and the one collision shape of a body, compared where both are primitives."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from operator import mul

from kinlint.facts.body_shapes import BOX, CAPSULE, BodyShapes, Shape
from kinlint.facts.fact_statements import fact, numbers
from kinlint.facts.linear_algebra import IDENTITY, length, subtract
from kinlint.terms import Triple


def _collides(shape: Shape) -> bool:
    return shape.collides


def shape_pairs(shapes: BodyShapes) -> Iterator[Triple]:
    """Yield the collision shape of each body with its visual one, if both are of one kind.

    With the distance in m of their middles, and the greatest ratio of their sizes: as they are
    listed, in order of size, and along the axes of the body.
    """
    for body in sorted(shapes.references):
        pair = [shapes.shape(node) for node in shapes.references[body]]
        known = sorted((each for each in pair if each is not None), key=_collides)
        if [each.collides for each in known] != [False, True] or len(pair) > len(known):
            continue
        drawn, solid = known
        if drawn.kind != solid.kind:
            continue
        places = [
            at
            for each in (drawn, solid)
            if (at := shapes.placements.shape_placement(each.node)) is not None
        ]
        points = [at.point for at in places if at.point is not None]
        if len(points) == len((drawn, solid)):
            yield solid.node, fact("drawn-as"), drawn.node
            one, other = (
                [sum(map(mul, map(abs, row), _edges(each))) for row in at.turn or IDENTITY]
                for each, at in zip((drawn, solid), places, strict=True)
            )
            apart = length(subtract(*points))
            yield from numbers(
                solid.node,
                [
                    ("apart", apart),
                    ("size-ratio", _greatest(drawn.sizes, solid.sizes)),
                    ("sorted-ratio", _greatest(sorted(drawn.sizes), sorted(solid.sizes))),
                    ("extent-ratio", _greatest(one, other)),
                ],
            )


def _edges(shape: Shape) -> tuple[float, ...]:
    """Return the edges in m of the box round a shape, along its own axes."""
    if shape.kind == BOX:
        return shape.sizes
    wide = 2.0 * shape.sizes[0]
    high = shape.sizes[1] if len(shape.sizes) > 1 else wide
    return wide, wide, high + (wide if shape.kind == CAPSULE else 0.0)


def _greatest(some: Sequence[float], others: Sequence[float]) -> float:
    """Return the greatest ratio of two sizes in the same place of both lists, 1 or more."""
    return max(max(a / b, b / a) for a, b in zip(some, others, strict=True))
