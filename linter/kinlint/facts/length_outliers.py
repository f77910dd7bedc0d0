"""Lengths of a model that are far above its others, as if stated in another unit."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Mapping

from kinlint.addresses import is_address
from kinlint.facts.body_shapes import BodyShapes
from kinlint.facts.fact_statements import numbers
from kinlint.facts.frame_placement import Placements
from kinlint.facts.linear_algebra import length
from kinlint.facts.mechanism import model_of
from kinlint.terms import Term, Triple

LEAST = 4
"""Least count of lengths of which the median tells how large a model is."""
FACTOR = 50.0
"""Least ratio to the median of what is stated: links of real robots differ by less."""


def outlying_lengths(placements: Placements, geometries: BodyShapes) -> Iterator[Triple]:
    """Yield the median length in m of each robot, and each length above `FACTOR` times of it.

    With each of these comes the median, too. Lengths of zero do not count, and those of shapes from
    the frames of their bodies are none of which the median is.
    """
    away = _shapes_away(placements, geometries)
    for model, lengths in _by_model(placements, geometries).items():
        if len(lengths) < LEAST:
            continue
        typical = _median([size for _, size in lengths])
        yield from numbers(model, [("median-length", typical)])
        for what, sizes in (("outlying-length", lengths), ("outlying-place", away.get(model, []))):
            for node, size in sorted(sizes):
                if size > FACTOR * typical:
                    yield from numbers(node, [(what, size), ("typical-length", typical)])


def _shapes_away(
    placements: Placements, geometries: BodyShapes
) -> Mapping[str, list[tuple[Term, float]]]:
    """Return how far the shapes of each model are from the frames of their bodies."""
    found: dict[str, list[tuple[Term, float]]] = defaultdict(list)
    for body, shapes in geometries.references.items():
        for node in shapes if is_address(body) else ():
            placed = placements.shape_placement(node)
            if placed is not None and placed.point is not None:
                found[model_of(body)].append((node, length(placed.point)))
    return found


def _median(sizes: list[float]) -> float:
    """Return the median of *sizes*, for which `statistics` takes too long to import."""
    ordered, half = sorted(sizes), len(sizes) // 2
    return ordered[half] if len(sizes) % 2 else (ordered[half - 1] + ordered[half]) / 2


def _by_model(
    placements: Placements, geometries: BodyShapes
) -> Mapping[str, list[tuple[Term, float]]]:
    """Return the lengths of each model, with their joints, bodies and shapes.

    They are distances of joints and centres of mass from the frames of their bodies, and the
    extents of shapes.
    """
    found: dict[str, list[tuple[Term, float]]] = defaultdict(list)
    sizes = [
        (node, node, length(point))
        for points in (placements.origins, placements.centres)
        for node, point in points.items()
    ]
    sizes += [
        (body, node, shape.extent)
        for body, shapes in geometries.references.items()
        for node in shapes
        if (shape := geometries.shape(node))
    ]
    for owner, node, size in sizes:
        if size > 0.0 and is_address(owner):
            found[model_of(owner)].append((node, size))
    return found
