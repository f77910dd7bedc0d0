"""Drives consumers of URDF that pip installs: each loads a file and tells what it made of it.

A process for each consumer imports it once and forks for each file, so that one that dies takes
nothing with it. Run as a program: the name of a consumer, then paths; prints JSON by path.
"""

from __future__ import annotations

import json
import logging
import math
import os
import sys
import tempfile
from collections.abc import Callable, Mapping
from importlib.metadata import version
from pathlib import Path
from typing import Any

Summary = dict[str, Any]
"""What a consumer made of a file.

`links` has by name the mass in kg, the number of shapes that collide, the place at the zero
configuration as 12 numbers of a transform to the base, the kinds of the shapes, with the scale of
meshes, and the diagonal of the inertia about the centre of mass in the axes of the link;
`joints` has by name the number of degrees of freedom, the limits of the first (None if it has
none), the greatest effort, and what it is coupled to; `floating` tells whether the base moves;
`loops` is the number of constraints between bodies, and `others` that of further robots.
"""


INFINITE = 1e6
"""Number from which on engines do not mean a limit."""


def link(mass=0.0, shapes=0, place=None, kinds=(), inertia=None):
    """Return a link; *kinds* are words, and of meshes the three factors of the scale."""
    return {
        "mass": mass,
        "shapes": shapes,
        "place": place,
        "kinds": [kind if isinstance(kind, str) else list(map(float, kind)) for kind in kinds],
        "inertia": None if inertia is None else list(map(float, inertia)),
    }


def turned(moments, rotation):
    """Return the diagonal of a tensor of principal *moments* whose axes are those of *rotation*."""
    import numpy as np

    matrix = np.array(rotation, dtype=float).reshape(3, 3)
    return np.diag(matrix @ np.diag(moments) @ matrix.T)


def joint(freedom, limits=None, effort=None, coupled=0, dynamics=(), axis=None):  # noqa: PLR0913, PLR0917
    """Return a joint; *dynamics* are greatest speed, damping and friction."""
    speed, damping, friction = (*dynamics, None, None, None)[:3]
    ends = [finite(each) for each in limits] if limits is not None else [None, None]
    return {
        "freedom": int(freedom),
        "limits": None if ends == [None, None] else ends,
        "effort": finite(effort),
        "coupled": bool(coupled),
        "speed": finite(speed),
        "damping": finite(damping) or 0.0,
        "friction": finite(friction) or 0.0,
        "axis": None if axis is None else [float(each) for each in axis],
    }


def finite(number):
    """Return *number*; None for none, and for what engines take for infinite."""
    value = math.nan if number is None else float(number)
    return value if math.isfinite(value) and abs(value) < INFINITE else None


def numbers(rotation, position):
    return [float(each) for row in rotation for each in row] + [float(each) for each in position]


def scale(points):
    """Return the signed size of a mesh, by that of the tetrahedron of the fixtures."""
    return [max((point[at] for point in points), key=abs) / (at + 1) for at in range(3)]


def mujoco(path: str) -> Summary:
    import mujoco as mj
    import numpy as np

    model = mj.MjModel.from_xml_path(path)
    data = mj.MjData(model)
    mj.mj_forward(model, data)
    freedoms = {mj.mjtJoint.mjJNT_FREE: 6, mj.mjtJoint.mjJNT_BALL: 3}
    coupled = set(model.eq_obj1id[model.eq_type == mj.mjtEq.mjEQ_JOINT].tolist())
    first = model.jnt_dofadr
    joints = {}
    for number in range(model.njnt):
        one = model.jnt(number)
        limited = model.jnt_limited[number]
        forced = model.jnt_actfrclimited[number]
        joints[one.name] = joint(
            freedoms.get(mj.mjtJoint(one.type[0]), 1),
            one.range if limited else None,
            model.jnt_actfrcrange[number][1] if forced else None,
            number in coupled,
            (None, model.dof_damping[first[number]], model.dof_frictionloss[first[number]]),
            one.axis,
        )
    links = {}
    for number in range(1, model.nbody):
        body = model.body(number)
        solid = (model.geom_bodyid == number) & (model.geom_contype > 0)
        place = numbers(data.xmat[number].reshape(3, 3), data.xpos[number])
        kinds = []
        for at in solid.nonzero()[0]:
            kind = mj.mjtGeom(model.geom_type[at]).name.removeprefix("mjGEOM_").lower()
            mesh = model.geom_dataid[at] if kind == "mesh" else -1
            kinds.append(kind if mesh < 0 else model.mesh_scale[mesh])
        axes = np.zeros(9)
        mj.mju_quat2Mat(axes, body.iquat)
        inertia = turned(body.inertia, axes)
        links[body.name] = link(float(body.mass[0]), int(solid.sum()), place, kinds, inertia)
    # What is welded to the world has no joint: only a free joint of the root lets it move.
    loops = int(np.isin(model.eq_type, (mj.mjtEq.mjEQ_CONNECT, mj.mjtEq.mjEQ_WELD)).sum())
    return {"links": links, "joints": joints, "floating": "base" in links, "loops": loops}


def drake(path: str) -> Summary:
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import AddMultibodyPlantSceneGraph
    from pydrake.multibody.tree import BodyIndex
    from pydrake.systems.framework import DiagramBuilder

    builder = DiagramBuilder()
    plant, graph = AddMultibodyPlantSceneGraph(builder, 0.001)
    Parser(plant).AddModels(path)
    plant.Finalize()
    count = plant.num_constraints()
    efforts = {
        plant.get_joint_actuator(number).joint().name(): plant.get_joint_actuator(
            number
        ).effort_limit()
        for number in plant.GetJointActuatorIndices()
    }
    context = plant.CreateDefaultContext()
    joints, links, floating = {}, {}, False
    for number in plant.GetJointIndices():
        one = plant.get_joint(number)
        limits, speed = None, ()
        if one.num_velocities() == 1:
            speed = one.velocity_upper_limits()[0], one.default_damping_vector()[0]
        if one.num_positions():
            limits = one.position_lower_limits()[0], one.position_upper_limits()[0]
        if one.parent_body() is plant.world_body() and one.num_velocities() == 6:
            floating = True
        joints[one.name()] = joint(
            one.num_velocities(),
            limits,
            efforts.get(one.name()),
            bool(count),
            speed,
            one.revolute_axis() if hasattr(one, "revolute_axis") else None,
        )
    for number in range(1, plant.num_bodies()):
        body = plant.get_body(BodyIndex(number))
        pose = plant.EvalBodyPoseInWorld(context, body)
        shapes = len(plant.GetCollisionGeometriesForBody(body))
        place = numbers(pose.rotation().matrix(), pose.translation())
        kinds = []
        for each in plant.GetCollisionGeometriesForBody(body):
            form = graph.model_inspector().GetShape(each)
            mesh = type(form).__name__ in {"Mesh", "Convex"}
            kinds.append(form.scale3() if mesh else type(form).__name__.lower())
        whole = body.default_spatial_inertia()
        inertia = whole.Shift(whole.get_com()).CalcRotationalInertia().get_moments()
        links[body.name()] = link(body.default_mass(), shapes, place, kinds, inertia)
    return {"links": links, "joints": joints, "floating": floating, "loops": count}


def pinocchio(path: str) -> Summary:
    import pinocchio as pin

    kind = pin.GeometryType.COLLISION
    if path.endswith(".xml"):
        model = pin.buildModelFromMJCF(path)
        shapes = pin.buildGeomFromMJCF(model, path, kind)
    else:
        model = pin.buildModelFromUrdf(path)
        shapes = pin.buildGeomFromUrdf(model, path, kind, package_dirs=[str(Path(path).parent)])
    data = model.createData()
    pin.forwardKinematics(model, data, pin.neutral(model))
    pin.updateFramePlacements(model, data)
    joints, links = {}, {}
    for frame in model.frames:
        if frame.type == pin.FrameType.FIXED_JOINT:
            joints[frame.name] = joint(0)
    for number in range(1, model.njoints):
        one = model.joints[number]
        limits = None
        if one.nq == 1:
            limits = model.lowerPositionLimit[one.idx_q], model.upperPositionLimit[one.idx_q]
        effort = model.upperEffortLimit[one.idx_v] if one.nv else None
        at, dynamics = one.idx_v, ()
        if one.nv == 1:
            dynamics = model.upperVelocityLimit[at], model.damping[at], model.friction[at]
        kind = one.shortname()
        axis = [float(letter in kind.removeprefix("JointModel")) for letter in "XYZ"]
        joints[model.names[number]] = joint(one.nv, limits, effort, "Mimic" in kind, dynamics, axis)
    for index, frame in enumerate(model.frames):
        if frame.type == pin.FrameType.BODY:
            place = data.oMf[index]
            own = [each for each in shapes.geometryObjects if each.parentFrame == index]
            forms = [type(each.geometry).__name__ for each in own]
            kinds = [
                each.meshScale if form.startswith(("BVH", "Convex")) else form.lower()
                for each, form in zip(own, forms, strict=True)
            ]
            links[frame.name] = link(
                float(frame.inertia.mass),
                len(own),
                numbers(place.rotation, place.translation),
                kinds,
                model.inertias[frame.parentJoint].inertia.diagonal(),
            )
    fixed = [each.name for each in model.frames if each.type == pin.FrameType.FIXED_JOINT]
    return {
        "links": links,
        "joints": joints,
        "floating": any(each.nv == 6 and model.parents[each.id] == 0 for each in model.joints),
        "mass": float(sum(each.mass for each in model.inertias)),
        "frames": fixed,
    }


def pybullet(path: str) -> Summary:
    import pybullet as bullet

    bullet.connect(bullet.DIRECT)
    if path.endswith(".urdf"):
        body = bullet.loadURDF(path)
    else:
        load = bullet.loadSDF if path.endswith(".sdf") else bullet.loadMJCF
        body = max(load(path), key=bullet.getNumJoints)
    loops, others = bullet.getNumConstraints(), bullet.getNumBodies() - 1
    joints, links = {}, {}

    def add(name, number, position, orientation):
        rotation = bullet.getMatrixFromQuaternion(orientation)
        rows = [rotation[0:3], rotation[3:6], rotation[6:9]]
        shapes = bullet.getCollisionShapeData(body, number)
        dynamics = bullet.getDynamicsInfo(body, number)
        names = {bullet.GEOM_BOX: "box", bullet.GEOM_SPHERE: "sphere"}
        names |= {bullet.GEOM_CYLINDER: "cylinder", bullet.GEOM_CAPSULE: "capsule"}
        kinds = [names.get(each[2], each[3]) for each in shapes]
        axes = bullet.getMatrixFromQuaternion(dynamics[4])
        inertia = turned(dynamics[2], axes)
        links[name] = link(dynamics[0], len(shapes), numbers(rows, position), kinds, inertia)

    base = bullet.getBodyInfo(body)[0].decode()
    add(base, -1, *bullet.getBasePositionAndOrientation(body))
    freedoms = {bullet.JOINT_FIXED: 0, bullet.JOINT_PLANAR: 3, bullet.JOINT_SPHERICAL: 3}
    for number in range(bullet.getNumJoints(body)):
        info = bullet.getJointInfo(body, number)
        free = freedoms.get(info[2], 1)
        limits = info[8:10] if free and info[8] <= info[9] else None
        name = info[1].decode()
        dynamics = info[11], info[6], info[7]
        joints[name] = joint(free, limits, info[10], 0, dynamics, info[13])
        state = bullet.getLinkState(body, number, computeForwardKinematics=True)
        add(info[12].decode(), number, state[4], state[5])
    floating = bullet.getDynamicsInfo(body, -1)[0] > 0
    told = {"floating": floating, "loops": loops, "others": others}
    return {"links": links, "joints": joints, **told}


def yourdfpy(path: str) -> Summary:
    import numpy as np
    from yourdfpy import URDF

    robot = URDF.load(
        path, load_meshes=False, load_collision_meshes=False, build_collision_scene_graph=False
    )
    joints, links = {}, {}
    for name, one in robot.joint_map.items():
        free = {"fixed": 0, "floating": 6, "planar": 2}.get(one.type, 1)
        limit = one.limit
        limits = None
        if limit is not None and limit.lower is not None and limit.upper is not None:
            limits = limit.lower, limit.upper
        held = name in robot.actuated_joint_names or one.mimic is not None
        joints[name] = joint(
            free if held or not free else 0,
            limits if one.type != "continuous" else None,
            None if limit is None else limit.effort,
            one.mimic is not None,
            (
                getattr(limit, "velocity", None),
                getattr(one.dynamics, "damping", None),
                getattr(one.dynamics, "friction", None),
            ),
            one.axis,
        )
    for name, one in robot.link_map.items():
        pose = robot.get_transform(name, robot.base_link)
        mass = one.inertial.mass if one.inertial is not None else 0.0
        shapes = sum(
            shape.geometry is not None and any(vars(shape.geometry).values())
            for shape in one.collisions
        )
        kinds = [
            word if word != "mesh" else part.scale if part.scale is not None else (1, 1, 1)
            for shape in one.collisions
            for word, part in vars(shape.geometry).items()
            if part is not None
        ]
        place = numbers(pose[:3, :3], pose[:3, 3])
        inertia = None
        if one.inertial is not None and one.inertial.inertia is not None:
            about = np.eye(3) if one.inertial.origin is None else one.inertial.origin[:3, :3]
            inertia = np.diag(about @ one.inertial.inertia @ about.T)
        links[name] = link(mass or 0.0, shapes, place, kinds, inertia)
    return {"links": links, "joints": joints, "floating": False}


def usd(path: str) -> Summary:
    import urdf_usd_converter
    from pxr import Gf, Usd, UsdGeom, UsdPhysics

    def said(prim, name):
        attribute = prim.GetAttribute(name)
        return attribute.Get() if attribute and attribute.HasAuthoredValue() else None

    def kind_of(prim):
        kind = prim.GetTypeName().lower()
        if kind in {"cube", "cylinder", "sphere", "capsule"}:
            return kind.replace("cube", "box")
        matrix, _ = cache.ComputeRelativeTransform(prim, prim.GetParent())
        return scale([matrix.Transform(Gf.Vec3d(each)) for each in said(prim, "points")])

    def bodies(prim):
        one = UsdPhysics.Joint(prim)
        return [*one.GetBody0Rel().GetTargets(), *one.GetBody1Rel().GetTargets()]

    with tempfile.TemporaryDirectory() as directory:
        asset = urdf_usd_converter.Converter().convert(path, directory)
        stage = Usd.Stage.Open(asset.path)
        cache = UsdGeom.XformCache()
        joints, links, fixed = {}, {}, False
        for prim in stage.Traverse(Usd.TraverseInstanceProxies()):
            name, kind = prim.GetName(), prim.GetTypeName()
            if prim.IsA(UsdPhysics.Joint):
                free = {"PhysicsFixedJoint": 0, "PhysicsJoint": 3}.get(kind, 1)
                turns = math.radians if kind == "PhysicsRevoluteJoint" else float
                range_ = [said(prim, f"physics:{side}Limit") for side in ("lower", "upper")]
                speed, damping = (said(prim, f"newton:{x}") for x in ("velocityLimit", "damping"))
                joints[name] = joint(
                    free,
                    None if None in range_ else list(map(turns, range_)),
                    said(prim, "urdf:limit:effort"),
                    any("Mimic" in each for each in prim.GetAppliedSchemas()),
                    (
                        None if speed is None else turns(speed),
                        None if damping is None else damping / turns(1),
                        said(prim, "newton:friction"),
                    ),
                    [float(said(prim, "physics:axis") == letter) for letter in "XYZ"],
                )
                ends = [stage.GetPrimAtPath(path) for path in bodies(prim)]
                rigid = sum(each.HasAPI(UsdPhysics.RigidBodyAPI) for each in ends)
                fixed = fixed or (not free and rigid == 1)
            elif prim.IsA(UsdGeom.Xform) and "/Geometry/" in str(prim.GetPath()):
                matrix = cache.GetLocalToWorldTransform(prim)
                rotation = matrix.ExtractRotationMatrix().GetTranspose()
                mass = said(prim, "physics:mass")
                solid = [
                    each for each in prim.GetChildren() if each.HasAPI(UsdPhysics.CollisionAPI)
                ]
                kinds = [kind_of(each) for each in solid]
                moments, axes = (
                    said(prim, f"physics:{x}") for x in ("diagonalInertia", "principalAxes")
                )
                inertia = None
                if moments is not None:
                    about = Gf.Matrix3d(Gf.Rotation(axes or Gf.Quatf(1))).GetTranspose()
                    inertia = turned(moments, [each for row in about for each in row])
                place = numbers(rotation, matrix.ExtractTranslation())
                # UsdPhysics: a mass of 0 is one that is not said.
                links[name] = link(mass or -1.0, len(solid), place, kinds, inertia)
        return {"links": links, "joints": joints, "floating": not fixed}


def newton(path: str) -> Summary:
    import newton as nt
    import warp as wp

    builder = nt.ModelBuilder()
    readers = {".xml": builder.add_mjcf, ".usda": builder.add_usd}
    readers.get(Path(path).suffix, builder.add_urdf)(path)
    joints, links, floating = {}, {}, False
    for number, freedoms in enumerate(builder.joint_dof_dim):
        at = builder.joint_qd_start[number]
        free = sum(freedoms)
        name = builder.joint_label[number].rpartition("/")[2]
        if builder.joint_parent[number] == -1:
            floating = floating or free == 6
        if free != 1:
            joints[name] = joint(free)
            continue
        joints[name] = joint(
            free,
            (builder.joint_limit_lower[at], builder.joint_limit_upper[at]),
            builder.joint_effort_limit[at],
            builder.joint_mimic_joint[number] >= 0,
            (
                builder.joint_velocity_limit[at],
                builder.joint_damping[at],
                builder.joint_friction[at],
            ),
            builder.joint_axis[at],
        )
        joints[name]["stiffness"] = builder.joint_target_ke[at]
    for number, label in enumerate(builder.body_label):
        pose = builder.body_q[number]
        rotation = wp.quat_to_matrix(wp.quat(*pose[3:7]))
        place = numbers([[rotation[i, j] for j in range(3)] for i in range(3)], pose[0:3])
        mass = float(builder.body_mass[number])
        own = [at for at, body in enumerate(builder.shape_body) if body == number]
        forms = [nt.GeoType(builder.shape_type[at]).name.lower() for at in own]
        kinds = [
            scale(builder.shape_source[at].vertices * builder.shape_scale[at])
            if form in {"mesh", "convex_mesh"}
            else form
            for at, form in zip(own, forms, strict=True)
        ]
        tensor = builder.body_inertia[number]
        inertia = [tensor[at, at] for at in range(3)]
        links[label.rpartition("/")[2]] = link(mass, len(own), place, kinds, inertia)
    loops = builder._equality_constraint_count
    return {"links": links, "joints": joints, "floating": floating, "loops": loops}


DRIVERS: Mapping[str, Callable[[str], Summary]] = {
    "mujoco": mujoco,
    "drake": drake,
    "pinocchio": pinocchio,
    "pybullet": pybullet,
    "yourdfpy": yourdfpy,
    "usd": usd,
    "newton": newton,
}
"""Consumers, each with what loads a file with it."""

MODULES = {
    "mujoco": ("mujoco", "mujoco"),
    "drake": ("pydrake", "drake"),
    "pinocchio": ("pinocchio", "pin"),
    "pybullet": ("pybullet", "pybullet"),
    "yourdfpy": ("yourdfpy", "yourdfpy"),
    "usd": ("urdf_usd_converter", "urdf-usd-converter"),
    "newton": ("newton", "newton"),
}
"""The module of each consumer, and the package that brings it."""


def summary(driver: Callable[[str], Summary], path: str) -> Summary:
    """Return what *driver* makes of the file at *path*, in a process of its own."""
    with tempfile.TemporaryFile() as said, tempfile.TemporaryFile() as answer:
        child = os.fork()
        if not child:
            os.dup2(said.fileno(), 1)
            os.dup2(said.fileno(), 2)
            logging.basicConfig(level=logging.WARNING, stream=sys.stderr, force=True)
            try:
                made = driver(path)
            except BaseException as error:  # noqa: BLE001  whatever it raises, it refused the file
                made = {"refused": f"{type(error).__name__}: {error}"[:400]}
            answer.write(json.dumps(made).encode())
            answer.flush()
            sys.stdout.flush()
            sys.stderr.flush()
            os._exit(0)
        _, status = os.waitpid(child, 0)
        answer.seek(0)
        said.seek(0)
        told = said.read().decode(errors="replace")
        if status:
            return {"died": status, "told": told[-400:]}
        return {**json.loads(answer.read()), "told": told[:2000]}


if __name__ == "__main__":
    consumer, *paths = sys.argv[1:]
    __import__(MODULES[consumer][0])
    found = {each: summary(DRIVERS[consumer], each) for each in paths}
    sys.stdout.write(json.dumps({"version": version(MODULES[consumer][1]), "files": found}))
