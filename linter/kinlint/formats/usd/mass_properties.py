"""Masses, centres of mass and inertias of bodies, by the precedence of UsdPhysics.

What a body states counts before what follows from its colliders: their own masses, or their
volumes and densities. The computation is that of UsdPhysicsRigidBodyAPI::ComputeMassProperties.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite

from kinlint.formats.rigid_transform import IDENTITY, Quaternion, Vector, rotated
from kinlint.formats.usd.colliders import Shape
from kinlint.formats.usd.matrices import quaternion, turning
from kinlint.formats.usd.stage import Stage, StagePrim
from kinlint.light_dataclasses import dataclass

MASS = "PhysicsMassAPI"
BINDINGS = ("material:binding:physics", "material:binding")
WATER = 1000.0
"""Density in kilograms per cubic metre, if none is stated."""

Tensor = tuple[Vector, Vector, Vector]


@dataclass(eq=False)
class MassProperties:
    """Mass properties of a body, in units of the stage."""

    mass: float | None
    """Mass; None if nothing tells it."""
    centre: Vector
    """Centre of mass on the body."""
    axes: Quaternion
    """Orientation of the axes of `inertia` on the body."""
    inertia: Tensor | None
    """Inertia about the centre of mass; None if nothing tells it."""
    sources: tuple[StagePrim, ...]
    """Prims that they are read from: the body, or its colliders."""
    weighed: tuple[StagePrim, ...] = ()
    """Prims that `inertia` is computed from; none if the body states it."""


@dataclass(eq=False)
class _Stated:
    """Mass properties that a body or a collider states."""

    mass: float | None
    """Mass; None if it states none that counts."""
    density: float | None
    """Density; None if it states none that counts."""
    centre: Vector | None
    """Centre of mass, scaled; None if it states none."""
    moments: Vector | None
    """Principal moments of inertia; None if it states none."""
    axes: Quaternion
    """Orientation of the principal axes."""

    @classmethod
    def from_prim(cls, prim: StagePrim, scale: Sequence[float]) -> _Stated:
        """Return what *prim* states with its *scale*; without the schema, nothing is read."""
        if not prim.has(MASS):
            return cls.nothing()
        mass, density = (_positive(prim.number(f"physics:{n}")) for n in ("mass", "density"))
        centre = prim.numbers("physics:centerOfMass", 3)
        moments = prim.numbers("physics:diagonalInertia", 3)
        axes = prim.numbers("physics:principalAxes", 4)
        known = centre is not None and all(map(isfinite, centre))
        turn = IDENTITY[1]
        if axes is not None and any(axes):
            w, x, y, z = axes
            turn = quaternion(turning((x, y, z, w)))
        return cls(
            mass,
            density,
            _vector([a * b for a, b in zip(centre, scale, strict=True)])
            if centre and known
            else None,
            _vector(moments) if moments is not None and any(moments) else None,
            turn,
        )

    @classmethod
    def nothing(cls) -> _Stated:
        """Return what a prim says that states nothing."""
        return cls(None, None, None, None, IDENTITY[1])


def mass_properties(
    body: StagePrim, shapes: Sequence[Shape], stage: Stage, scales: dict[str, Vector]
) -> MassProperties | None:
    """Return the mass properties of *body* with *shapes*; None if nothing tells them.

    *scales* are those of the prims, by their paths.
    """
    own = _Stated.from_prim(body, scales[body.path])
    complete = own.mass is not None and own.moments is not None and own.centre is not None
    found = None if complete else _sum(body, own, shapes, stage, scales)
    mass = own.mass
    if mass is None and found is not None:
        mass = found.mass
    if mass is None and own.moments is None:
        return None
    centre = own.centre or (found.centre if found is not None else (0.0, 0.0, 0.0))
    sources = (body, *(each.prim for each in shapes if each.collides and found is not None))
    if own.moments is not None:
        (a, b, c), zero = own.moments, 0.0
        return MassProperties(
            mass, centre, own.axes, ((a, zero, zero), (zero, b, zero), (zero, zero, c)), sources
        )
    inertia = None
    if found is not None and found.inertia is not None and found.mass and mass is not None:
        share = mass / found.mass
        inertia = _tensor([[share * each for each in row] for row in found.inertia])
        if own.centre is not None:
            away = _minus(own.centre, found.centre)
            inertia = _plus(inertia, _moved(mass, away))
    return MassProperties(mass, centre, IDENTITY[1], inertia, sources, weighed=sources)


def _sum(
    body: StagePrim,
    own: _Stated,
    shapes: Sequence[Shape],
    stage: Stage,
    scales: dict[str, Vector],
) -> MassProperties | None:
    """Return the mass properties that the colliders among *shapes* have together."""
    parts: list[tuple[float, Vector, Tensor]] = []
    colliders = [each for each in shapes if each.collides]
    for shape in colliders:
        prim = shape.prim
        stated = _Stated.nothing() if prim is body else _Stated.from_prim(prim, scales[prim.path])
        part = _part(own, stated, shape, stage)
        if part is None:
            return None
        parts.append(part)
    whole = sum(mass for mass, _, _ in parts)
    if not whole:
        return None
    centre = _vector([sum(m * c[k] for m, c, _ in parts) / whole for k in range(3)])
    inertia: Tensor = ((0.0,) * 3,) * 3
    for mass, at, tensor in parts:
        inertia = _plus(_plus(inertia, tensor), _moved(mass, _minus(at, centre)))
    return MassProperties(whole, centre, IDENTITY[1], inertia, ())


def _part(
    own: _Stated, stated: _Stated, shape: Shape, stage: Stage
) -> tuple[float, Vector, Tensor] | None:
    """Return mass, centre and inertia of *shape*, which states this, along the axes of the body."""
    volume = shape.volume
    if volume is None or volume <= 0:
        return None
    density = stated.density or _material_density(shape.prim, stage) or own.density or _water(stage)
    mass = stated.mass or volume * density
    position, turn = shape.place
    if stated.moments is not None:
        moments, axes = stated.moments, stated.axes
    else:
        share = mass / volume
        moments, axes = _vector([each * share for each in shape.moments]), IDENTITY[1]
    rows = [
        rotated(turn, rotated(axes, unit))
        for unit in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    ]
    tensor = _tensor(
        [
            [sum(moments[n] * rows[n][i] * rows[n][j] for n in range(3)) for j in range(3)]
            for i in range(3)
        ]
    )
    away = rotated(turn, stated.centre) if stated.centre is not None else (0.0, 0.0, 0.0)
    return mass, _vector([a + b for a, b in zip(position, away, strict=True)]), tensor


def _water(stage: Stage) -> float:
    metres, kilograms = stage.number("metersPerUnit", 0.01), stage.number("kilogramsPerUnit", 1.0)
    return WATER * metres**3 / kilograms if kilograms else WATER


def _material_density(prim: StagePrim, stage: Stage) -> float | None:
    """Return the density of the physical material of *prim*; None if it has none."""
    for each in (prim, *prim.around()):
        for name in BINDINGS:
            material = next((stage.prims.get(path) for path in each.targets(name)), None)
            if material is not None and material.has("PhysicsMaterialAPI"):
                return _positive(material.number("physics:density"))
    return None


def _positive(number: float | None) -> float | None:
    return number if number is not None and isfinite(number) and number > 0 else None


def _vector(numbers: Sequence[float]) -> Vector:
    x, y, z = numbers
    return x, y, z


def _tensor(rows: Sequence[Sequence[float]]) -> Tensor:
    a, b, c = map(_vector, rows)
    return a, b, c


def _minus(a: Vector, b: Vector) -> Vector:
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def _plus(a: Tensor, b: Tensor) -> Tensor:
    return _tensor([[x + y for x, y in zip(p, q, strict=True)] for p, q in zip(a, b, strict=True)])


def _moved(mass: float, away: Vector) -> Tensor:
    """Return the inertia of a point of *mass* that is *away*."""
    square = sum(each * each for each in away)
    return _tensor(
        [
            [mass * ((square if i == j else 0.0) - away[i] * away[j]) for j in range(3)]
            for i in range(3)
        ]
    )
