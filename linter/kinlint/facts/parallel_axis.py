"""Tensors of inertia that look as if they were about the origin of their link."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.facts.assembly import Assemblies
from kinlint.facts.fact_statements import numbers
from kinlint.facts.frame_placement import Placements
from kinlint.facts.inertia import Inertias
from kinlint.facts.linear_algebra import Matrix, Vector, dot, eigenvalues, length, subtract
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.terms import Triple

LEAST_SHARE = 0.05
"""Least size of the products of inertia, as a share of the trace, that tells anything.

A body that is not quite symmetric has products of that size about its own centre.
"""


def parallel_axis_residuals(
    inertias: Inertias, assemblies: Assemblies, scan: PredicateIndex
) -> Iterator[Triple]:
    """Yield the relative distance of products of inertia from those of a point mass.

    That is 0 for a tensor about the origin of the link if the body is symmetric about its centre,
    by the parallel axis theorem (Featherstone, Rigid Body Dynamics Algorithms, 2008, section 2.13).
    Only where the products are large enough to tell, the axes are those of the link, and the
    remainder about the centre is a tensor that a body can have.
    """
    placements = Placements(scan)
    for node, tensor in inertias.central.items():
        body = assemblies.body(node)
        mass = assemblies.masses.get(body, 0.0) if body is not None else 0.0
        if body is None or mass <= 0.0 or body in placements.turned:
            continue
        centre = placements.centres.get(body)
        if centre is None:
            continue
        moved = about_origin(mass, centre)
        expected, size = _products(moved), length(_products(moved))
        trace = sum(tensor[at][at] for at in range(3))
        if trace <= 0.0 or size <= LEAST_SHARE * trace or not _possible(_less(tensor, moved)):
            continue
        yield from numbers(
            node, [("transfer", length(subtract(_products(tensor), expected)) / size)]
        )


def about_origin(mass: float, at: Vector) -> Matrix:
    """Return the tensor in kg m² of a point mass at *at*, about the origin: m (r·r 1 - r rᵀ)."""
    square = dot(at, at)
    x, y, z = (
        tuple(
            mass * ((square if row == column else 0.0) - at[row] * at[column])
            for column in range(3)
        )
        for row in range(3)
    )
    return (x[0], x[1], x[2]), (y[0], y[1], y[2]), (z[0], z[1], z[2])


def _products(tensor: Matrix) -> Vector:
    return tensor[0][1], tensor[0][2], tensor[1][2]


def _less(tensor: Matrix, other: Matrix) -> Matrix:
    x, y, z = (subtract(mine, theirs) for mine, theirs in zip(tensor, other, strict=True))
    return x, y, z


def _possible(tensor: Matrix) -> bool:
    """Tell whether a body can have *tensor*: positive moments that obey the triangle inequality."""
    least, middle, greatest = eigenvalues(tensor)
    return least > 0.0 and least + middle >= greatest
