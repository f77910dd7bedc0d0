"""Bodies, joints and masses are those that UsdPhysics works out of the same stage."""

from __future__ import annotations

from math import hypot
from pathlib import Path
from typing import Any

import pytest
from test_usd_composition import stage_of
from usd_stages import ARM, layer

from kinlint.formats.rigid_transform import Quaternion
from kinlint.formats.usd.articulations import assemblies
from kinlint.formats.usd.colliders import Shape, shapes
from kinlint.formats.usd.mass_properties import mass_properties
from kinlint.formats.usd.matrices import turning
from kinlint.formats.usd.physics_joints import PhysicsJoint, bound, is_body, joints
from kinlint.formats.usd.prim_transforms import PrimTransforms
from kinlint.formats.usd.stage import Stage, StagePrim

UsdPhysics = pytest.importorskip("pxr.UsdPhysics")
DATA = Path(__file__).parents[4] / "shared" / "data"
pytestmark = pytest.mark.filterwarnings("ignore:LoadUsdPhysicsFromRange:DeprecationWarning")
UNITS = [(1, 1), (0.01, 1), (0.001, 0.001)]
SINGLE = 1e-6
"""Relative precision of numbers of 32 bits."""


def public_stages() -> list[Path]:
    """Return the stages of others, where they are."""
    return sorted(
        each
        for folder in ("robots/usd", "defects/usd")
        for each in (DATA / folder).rglob("*.usda")
        if each.name.startswith(("clean", "usdPhysics"))
    )


def parsed(path: Path) -> dict[Any, dict[str, Any]]:
    """Return what UsdPhysics says of the stage at *path*, by kind and path of the prim."""
    from pxr import Usd  # noqa: PLC0415  not installed with kinlint

    stage = Usd.Stage.Open(str(path))
    found = UsdPhysics.LoadUsdPhysicsFromRange(stage, ["/"])
    kinds = {kind: {str(p): d for p, d in zip(*each, strict=True)} for kind, each in found.items()}
    return {**kinds, "stage": stage}


def turn(quat: Any) -> Quaternion:
    """Return the unit quaternion of usd-core's *quat* with a w that is not negative."""
    x, y, z, w = (*quat.GetImaginary(), quat.GetReal())
    length = hypot(x, y, z, w) * (-1 if w < 0 else 1)
    return x / length, y / length, z / length, w / length


def same_turn(quat: Any, ours: Quaternion) -> bool:
    """Tell whether both are the same rotation."""
    return abs(sum(a * b for a, b in zip(turn(quat), ours, strict=True))) > 1 - SINGLE


@pytest.fixture(params=[*UNITS, *public_stages()], ids=str)
def path(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    """The path of a stage."""
    if isinstance(request.param, Path):
        return request.param
    file = tmp_path / "arm.usda"
    metres, kilograms = request.param
    file.write_text(layer(ARM, metres=metres, kilograms=kilograms), "utf-8")
    return file


def test_joints(path: Path) -> None:
    theirs = parsed(path)
    found = {each.prim.path: each for each in joints(stage_of(path), PrimTransforms())}
    said = {
        path: joint
        for kind, each in theirs.items()
        if "Joint" in str(kind)
        for path, joint in each.items()
    }

    assert set(found) == set(said)
    for name, joint in said.items():
        _compare_joint(found[name], joint)


def _compare_joint(ours: PhysicsJoint, joint: Any) -> None:
    kinds = {"PrismaticJoint": "prismatic", "RevoluteJoint": "revolute", "FixedJoint": "fixed"}
    known = kinds.get(str(joint.type).rpartition(".")[2])
    assert known in (None, ours.kind)
    for side, number in zip(ours.sides, "01", strict=True):
        body = str(getattr(joint, f"body{number}"))
        if body and side.body is None and side.target == body:
            continue  # a collider that stands still: the place in the world is the same
        assert body == (side.body.path if side.body else "")
        position = getattr(joint, f"localPose{number}Position")
        assert side.frame[0] == pytest.approx(tuple(position), rel=SINGLE, abs=SINGLE)
        assert same_turn(getattr(joint, f"localPose{number}Orientation"), side.frame[1])
    if known in ("prismatic", "revolute"):
        assert str(joint.axis).rpartition(".")[2] == ours.axis
        low, high = (bound(ours.prim, f"physics:{end}Limit") for end in ("lower", "upper"))
        assert joint.limit.enabled == (low is not None and high is not None)
        if joint.limit.enabled:
            assert (low, high) == pytest.approx((joint.limit.lower, joint.limit.upper))


def test_bodies(path: Path) -> None:
    theirs, stage, transforms = parsed(path), stage_of(path), PrimTransforms()
    found = {each.path: each for each in stage.defined() if is_body(each)}
    said = theirs.get(UsdPhysics.ObjectType.RigidBody, {})

    assert set(found) == set(said)
    for name, body in said.items():
        place = transforms.pose(found[name]).place
        assert place[0] == pytest.approx(tuple(body.position), rel=SINGLE, abs=SINGLE)
        assert same_turn(body.rotation, place[1])


def test_masses(path: Path) -> None:
    """Inertias are compared along the axes of the body."""
    theirs, stage, transforms = parsed(path), stage_of(path), PrimTransforms()
    if path.name == "usdPhysicsSpheresWithMaterial.usda":
        pytest.skip("densities are written as double, which usd-core does not read")
    for body in [each for each in stage.defined() if is_body(each)]:
        mass, moments, centre, axes = _computed(theirs["stage"], body, stage, transforms)
        scale = {each.path: transforms.pose(each).scale for each in body.below()}
        ours = mass_properties(body, list(shapes(body, transforms)), stage, scale)
        assert ours is not None
        assert ours.inertia is not None
        assert ours.mass == pytest.approx(mass, rel=SINGLE)
        assert ours.centre == pytest.approx(tuple(centre), rel=1e-5, abs=SINGLE)
        expected = _turned(turn(axes), [[moments[0], 0, 0], [0, moments[1], 0], [0, 0, moments[2]]])
        size = max(abs(each) for row in expected for each in row)
        for row, other in zip(_turned(ours.axes, ours.inertia), expected, strict=True):
            assert row == pytest.approx(other, rel=1e-5, abs=1e-5 * size)


def _turned(quaternion: Quaternion, tensor: Any) -> list[list[float]]:
    rows = turning(quaternion)
    span = range(3)
    return [
        [sum(rows[i][k] * tensor[k][m] * rows[j][m] for k in span for m in span) for j in span]
        for i in span
    ]


def _computed(stage: Any, body: StagePrim, ours: Stage, transforms: PrimTransforms) -> Any:
    """Return what UsdPhysics computes of *body*, from volumes that the test tells it."""
    known = {each.prim.path: each for each in shapes(body, transforms)}

    def told(prim: Any) -> Any:
        return _information(known[str(prim.GetPath())])

    api = UsdPhysics.RigidBodyAPI(stage.GetPrimAtPath(body.path))
    return api.ComputeMassProperties(told)


def _information(shape: Shape) -> Any:
    from pxr import Gf  # noqa: PLC0415  not installed with kinlint

    made = UsdPhysics.RigidBodyAPI.MassInformation()
    made.volume = shape.volume
    made.inertia = Gf.Matrix3f(0)
    made.inertia.SetDiagonal(Gf.Vec3f(*shape.moments))
    made.centerOfMass = Gf.Vec3f(0)
    made.localPos = Gf.Vec3f(*shape.place[0])
    x, y, z, w = shape.place[1]
    made.localRot = Gf.Quatf(w, x, y, z)
    return made


def test_joints_are_turned_away_from_the_root(path: Path) -> None:
    """Each body is the child of one joint at most; joints that close loops are not counted."""
    found = assemblies(list(joints(stage_of(path), PrimTransforms())))

    for each in found:
        children = [j.child.body for j in each.joints if not j.closes_loop]
        assert len(children) == len(set(children))
        assert (
            each.root is None
            or each.root not in [j.child.body for j in each.joints if j.parent.body is not None]
            or any(j.closes_loop for j in each.joints)
        )
