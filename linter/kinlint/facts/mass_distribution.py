"""Proportions between the inertia of a body, its mass and its shapes."""

from __future__ import annotations

import math
from collections.abc import Iterator

from kinlint.facts.assembly import Assemblies
from kinlint.facts.body_shapes import UNKNOWN, BodyShapes
from kinlint.facts.fact_statements import numbers
from kinlint.facts.frame_placement import PARENT_BODY, Placements
from kinlint.facts.inertia import Inertias
from kinlint.facts.linear_algebra import IDENTITY, ZERO, Vector, length, subtract
from kinlint.facts.mechanism import model_of
from kinlint.terms import Term, Triple


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


def com_far_from_joints(
    assemblies: Assemblies, geometries: BodyShapes, placements: Placements
) -> Iterator[Triple]:
    """Yield how far, in m, the centre of mass of each body without shapes is from its joints.

    `beyond-joints` is the distance to the nearest of them and of the body's own frame, and
    `widest` that of the joint of the same model that is farthest from the frame of its own body.
    """
    anchors: dict[Term, list[Vector]] = {}
    widest: dict[str, float] = {}
    carriers = placements.scan.single(PARENT_BODY)
    for joint, point in placements.origins.items():
        anchors.setdefault(carriers[joint], []).append(point)
        model = model_of(joint)
        widest[model] = max(widest.get(model, 0.0), length(point))
    for body, centre in sorted(placements.centres.items()):
        reach = widest.get(model_of(body), 0.0)
        shaped = body in geometries.references
        if shaped or reach == 0.0 or assemblies.masses.get(body, 0.0) <= 0.0:
            continue
        gap = min(length(subtract(centre, each)) for each in (ZERO, *anchors.get(body, ())))
        yield from numbers(body, [("beyond-joints", gap), ("widest", reach)])


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
