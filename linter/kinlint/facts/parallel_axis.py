"""Tensors of inertia that look as if they were about the origin of their link."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.facts.assembly import Assemblies
from kinlint.facts.fact_statements import numbers
from kinlint.facts.frame_placement import Placements
from kinlint.facts.inertia import Inertias, about_origin
from kinlint.facts.linear_algebra import Matrix, Vector, difference, eigenvalues, length, subtract
from kinlint.terms import Triple

LEAST_SHARE = 0.05
"""Least size of the products of inertia, as a share of the trace, that tells anything.

A body that is not quite symmetric has products of that size about its own centre.
"""


def parallel_axis_residuals(
    inertias: Inertias, assemblies: Assemblies, placements: Placements
) -> Iterator[Triple]:
    """Yield the relative distance of products of inertia from those of a point mass.

    That is 0 for a tensor about the origin of the link if the body is symmetric about its centre,
    by the parallel axis theorem (Featherstone, Rigid Body Dynamics Algorithms, on rigid-body
    inertia). Only where the products are large enough to tell, the axes are those of the link, and
    the remainder about the centre is a tensor that a body can have.
    """
    for node, tensor in inertias.central.items():
        body, mass = assemblies.weighed(node) or (None, 0.0)
        centre = placements.centres.get(body) if body is not None else None
        if centre is None or body in placements.turned:
            continue
        moved = about_origin(mass, centre)
        expected, size = _products(moved), length(_products(moved))
        trace = sum(tensor[at][at] for at in range(3))
        if trace <= 0.0 or size <= LEAST_SHARE * trace or not _possible(difference(tensor, moved)):
            continue
        yield from numbers(
            node, [("transfer", length(subtract(_products(tensor), expected)) / size)]
        )


def _products(tensor: Matrix) -> Vector:
    return tensor[0][1], tensor[0][2], tensor[1][2]


def _possible(tensor: Matrix) -> bool:
    """Tell whether a body can have *tensor*: positive moments that obey the triangle inequality."""
    least, middle, greatest = eigenvalues(tensor)
    return least > 0.0 and least + middle >= greatest
