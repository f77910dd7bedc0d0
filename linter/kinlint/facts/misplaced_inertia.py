"""Moments of inertia that belong to other axes of the body, or to another body."""

from __future__ import annotations

import math
from collections.abc import Iterator

from kinlint.facts.assembly import Assemblies
from kinlint.facts.body_shapes import CYLINDER, BodyShapes
from kinlint.facts.fact_statements import derived, fact, numbers
from kinlint.facts.inertia import Inertias
from kinlint.facts.inertia_repair import solid_moments
from kinlint.facts.laterality import without_side
from kinlint.facts.linear_algebra import Matrix, Vector, product, transpose
from kinlint.facts.mirror_symmetry import split_name
from kinlint.facts.orientation_graph import OrientationGraph
from kinlint.light_dataclasses import replace
from kinlint.terms import Term, Triple

ALIKE = 0.05
"""The part of the greatest moment up to which one counts as that of a solid."""
OTHER = 0.2
"""The part of the greatest moment by which one about another axis differs at least."""
COPIED = 0.01
"""The part of a moment up to which another is a copy of it."""
DIGITS = 5
"""Fewest digits of the different moments of two bodies that are no coincidence."""


def misplaced_inertias(
    inertias: Inertias, assemblies: Assemblies, geometries: BodyShapes, axes: OrientationGraph
) -> Iterator[Triple]:
    """Yield the bodies whose moments are those of their solid shape, in another order of its axes.

    And those whose moments are, to the last digit, those of another body of another mass, or those
    of their cylinder with its radius and its length swapped.
    """
    first: dict[tuple[str, Matrix], tuple[Term, Term, float]] = {}
    for node, tensor in sorted(inertias.central.items()):
        weighed = assemblies.weighed(node)
        if weighed is None:
            continue
        body, mass = weighed
        space, name = split_name(body)
        other = first.setdefault((space, tensor), (node, body, mass))
        unlike = without_side(split_name(other[1])[1]) != without_side(name)
        if unlike and not math.isclose(other[2], mass, rel_tol=ALIKE) and _telling(tensor):
            yield node, fact("inertia-of"), other[1]
            yield from derived(node, [other[0]])
        shape = geometries.sole(body)
        seen_by = assemblies.companions.frames.get(node)
        own = geometries.frame(shape.node) if shape is not None else None
        if shape is None or own is None or seen_by is None:
            continue
        turn = axes.between(*map(geometries.placements.relations.axes, (own, seen_by)))
        if turn is None:
            continue
        moments = _along(tensor, turn)
        solid = solid_moments(shape, mass)
        if moments is not None and _reordered(moments, solid):
            yield node, fact("other-axes-of"), shape.node
            named = zip("xyz", moments, solid, strict=True)
            for axis, moment, meant in named:
                yield from numbers(
                    node, [(f"moment-{axis}", _short(moment)), (f"solid-{axis}", _short(meant))]
                )
        elif moments is not None and shape.kind == CYLINDER:
            radius, long = shape.sizes
            swapped = solid_moments(replace(shape, sizes=(long, radius)), mass)
            if _alike(moments, swapped) and not _alike(moments, solid):
                yield node, fact("swapped-sizes-of"), shape.node


def _short(moment: float) -> float:
    """Return *moment* with the digits that a message needs."""
    return float(f"{moment:.4g}")


def _along(tensor: Matrix, turn: Matrix) -> Vector | None:
    """Return the moments about the axes that *turn* leads to; None if there are products."""
    turned = product(product(turn, tensor), transpose(turn))
    across = max(abs(turned[0][1]), abs(turned[0][2]), abs(turned[1][2]))
    moments = (turned[0][0], turned[1][1], turned[2][2])
    return moments if across <= ALIKE * max(moments) else None


def _alike(moments: Vector, solid: Vector) -> bool:
    """Tell whether *moments* are those of the *solid*."""
    return all(
        abs(one - own) <= ALIKE * max(solid) for one, own in zip(moments, solid, strict=True)
    )


def _reordered(moments: Vector, solid: Vector) -> bool:
    """Tell whether *moments* are those of the *solid*, but one or more of them about other axes."""
    size = max(solid)
    ordered = zip(sorted(moments), sorted(solid), strict=True)
    known = all(abs(one - own) <= ALIKE * size for one, own in ordered) or all(
        any(math.isclose(one, own, rel_tol=COPIED) for own in solid) for one in moments
    )
    return known and any(
        abs(one - own) > OTHER * size for one, own in zip(moments, solid, strict=True)
    )


def _telling(tensor: Matrix) -> bool:
    """Tell whether two of the moments differ, and have digits enough to be measured or computed."""
    moments = {tensor[at][at] for at in range(3)}
    digits = (f"{each:.12e}".partition("e")[0].replace(".", "").rstrip("0") for each in moments)
    return len(moments) > 1 and sum(map(len, digits)) >= DIGITS
