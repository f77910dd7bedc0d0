"""What an inertia says of the size of its body, beside the shapes that the body is given."""

from __future__ import annotations

import math
from collections.abc import Iterator

from kinlint.facts.assembly import Assemblies
from kinlint.facts.body_shapes import UNKNOWN, BodyShapes
from kinlint.facts.fact_statements import numbers
from kinlint.facts.frame_placement import Placements
from kinlint.facts.inertia import Inertias
from kinlint.facts.linear_algebra import IDENTITY
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.terms import Triple


def com_outside(
    assemblies: Assemblies, geometries: BodyShapes, scan: PredicateIndex
) -> Iterator[Triple]:
    """How far the centre of mass of each body is outside all its shapes, where it is."""
    for body, centre in sorted(Placements(scan).centres.items()):
        gap = geometries.outside(body, centre) if assemblies.masses.get(body, 0.0) > 0.0 else None
        if gap is not None and gap > 0.0:
            yield from numbers(body, [("astray", gap)])


def proportions(
    inertias: Inertias, assemblies: Assemblies, geometries: BodyShapes
) -> Iterator[Triple]:
    """The radius of gyration of each body, its extent and its density, where they are known.

    There are two densities, which differ where a body has shapes to be seen and shapes to be hit.
    """
    for node, tensor in inertias.central.items():
        body = assemblies.body(node)
        mass = assemblies.masses.get(body, 0.0) if body is not None else 0.0
        if body is None or mass <= 0.0:
            continue
        size = geometries.of(body)
        greatest = inertias.principal[node][2]
        if greatest > 0.0 and tensor != IDENTITY:
            yield from numbers(node, [("gyration", math.sqrt(greatest / mass))])
        if size.extent is not None:
            yield from numbers(node, [("extent", size.extent)])
    for node, mass in inertias.quantities.masses.items():
        body = assemblies.body(node)
        size = geometries.of(body) if body is not None else UNKNOWN
        if mass > 0.0 and size.least_volume and size.greatest_volume:
            least, greatest = mass / size.greatest_volume, mass / size.least_volume
            yield from numbers(node, [("least-density", least), ("greatest-density", greatest)])
