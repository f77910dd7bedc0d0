"""Proportions between the inertia of a body, its mass and its shapes."""

from __future__ import annotations

import math
from collections.abc import Iterator

from kinlint.facts.assembly import Assemblies
from kinlint.facts.body_shapes import UNKNOWN, BodyShapes
from kinlint.facts.fact_statements import numbers
from kinlint.facts.frame_placement import Placements
from kinlint.facts.inertia import Inertias
from kinlint.facts.linear_algebra import IDENTITY
from kinlint.terms import Triple


def com_outside(
    assemblies: Assemblies, geometries: BodyShapes, placements: Placements
) -> Iterator[Triple]:
    """Yield how far, in m, each centre of mass is from the shapes of its body, if outside of them.

    `astray` only where the sizes of all shapes are known; otherwise `remote` has an error.
    """
    for body, centre in sorted(placements.centres.items()):
        if assemblies.masses.get(body, 0.0) <= 0.0:
            continue
        gap, error = geometries.distance(body, centre) or (0.0, None)
        if gap <= 0.0:
            continue
        if error is None:
            yield from numbers(body, [("astray", gap)])
        yield from numbers(body, [("remote", gap), ("remote-error", error or 0.0)])


def proportions(
    inertias: Inertias, assemblies: Assemblies, geometries: BodyShapes
) -> Iterator[Triple]:
    """Yield the radius of gyration of each body, its extent and its density, where they are known.

    The radius √(I/m) of the greatest principal moment is the distance at which a point mass would
    have that moment, so it cannot exceed the extent. There are two densities, which differ where a
    body has visual and collision shapes.
    """
    for node, tensor in inertias.central.items():
        if (weighed := assemblies.weighed(node)) is None:
            continue
        body, mass = weighed
        size = geometries.extents(body)
        greatest = inertias.principal[node][2]
        if greatest > 0.0 and tensor != IDENTITY:
            yield from numbers(node, [("gyration", math.sqrt(greatest / mass))])
        if size.extent is not None:
            yield from numbers(node, [("extent", size.extent)])
    for node, mass in inertias.quantities.masses.items():
        owner = assemblies.body(node)
        size = geometries.extents(owner) if owner is not None else UNKNOWN
        if mass > 0.0 and size.least_volume and size.greatest_volume:
            least, greatest = mass / size.greatest_volume, mass / size.least_volume
            yield from numbers(node, [("least-density", least), ("greatest-density", greatest)])
