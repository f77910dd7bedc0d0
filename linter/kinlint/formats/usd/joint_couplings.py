"""Couplings of joints: positions of followers that are linear in those of leaders."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.formats.usd.physics_joints import PhysicsJoint
from kinlint.formats.usd.stage import Stage, StagePrim
from kinlint.light_dataclasses import dataclass

NEWTON, PHYSX = "NewtonMimicAPI", "PhysxMimicJointAPI"


@dataclass(frozen=True, slots=True)
class PrimCoupling:
    """Coupling: the follower is at the leader's position times the multiplier, plus the offset."""

    follower: StagePrim
    """Joint that follows."""
    leader: StagePrim
    """Joint that leads."""
    multiplier: float
    """Factor, without a unit."""
    offset: float
    """Offset, in degrees or units of length of the stage."""
    slides: bool
    """True if the follower slides."""


def couplings(joints: Sequence[PhysicsJoint], stage: Stage) -> Iterator[PrimCoupling]:
    """Yield the couplings between *joints*, by the schemas of Newton and PhysX."""
    known = {each.prim.path: each for each in joints if each.kind in ("revolute", "prismatic")}
    for path, joint in known.items():
        prim = joint.prim
        said = _newton(prim) if prim.has(NEWTON) else _physx(prim)
        if said is None:
            continue
        leader, multiplier, offset = said
        if leader in known and leader != path and leader in stage.prims:
            slides = joint.kind == "prismatic"
            yield PrimCoupling(prim, stage.prims[leader], multiplier, offset, slides)


def _newton(prim: StagePrim) -> tuple[str, float, float] | None:
    """Return leader, multiplier and offset of a mimic of Newton; None if it is switched off."""
    targets = prim.targets("newton:mimicJoint")
    if not targets or not prim.flag("newton:mimicEnabled", default=True):
        return None
    factor, offset = (prim.number(f"newton:mimicCoef{number}") for number in "10")
    return targets[0], 1.0 if factor is None else factor, offset or 0.0


def _physx(prim: StagePrim) -> tuple[str, float, float] | None:
    """Return leader, multiplier and offset of a mimic of PhysX, which states their negatives."""
    for schema in prim.applied:
        name, _, instance = schema.partition(":")
        stem = f"physxMimicJoint:{instance}"
        targets = prim.targets(f"{stem}:referenceJoint") if name == PHYSX else []
        if targets:
            gearing, offset = (prim.number(f"{stem}:{each}") for each in ("gearing", "offset"))
            return targets[0], 0.0 - (1.0 if gearing is None else gearing), 0.0 - (offset or 0.0)
    return None
