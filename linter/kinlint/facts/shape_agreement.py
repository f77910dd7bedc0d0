"""The one visual and the one collision shape of a body, compared where both are primitives."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.facts.body_shapes import BodyShapes, Shape
from kinlint.facts.fact_statements import fact, numbers
from kinlint.facts.linear_algebra import length, subtract
from kinlint.terms import Triple


def _collides(shape: Shape) -> bool:
    return shape.collides


def shape_pairs(shapes: BodyShapes) -> Iterator[Triple]:
    """Yield the collision shape of each body with its visual one, if both are of one kind.

    With the distance in m of their middles, and the greatest ratio of their sizes.
    """
    for body in sorted(shapes.references):
        pair = [shapes.shape(node) for node in shapes.references[body]]
        known = sorted((each for each in pair if each is not None), key=_collides)
        if [each.collides for each in known] != [False, True] or len(pair) > len(known):
            continue
        drawn, solid = known
        if drawn.kind != solid.kind:
            continue
        places = [shapes.placements.shape_placement(each.node) for each in (drawn, solid)]
        points = [at.point for at in places if at is not None and at.point is not None]
        if len(points) == len(places):
            yield solid.node, fact("drawn-as"), drawn.node
            ratios = [a / b for a, b in zip(drawn.sizes, solid.sizes, strict=True)]
            greatest = max(max(each, 1.0 / each) for each in ratios)
            apart = length(subtract(*points))
            yield from numbers(solid.node, [("apart", apart), ("size-ratio", greatest)])
