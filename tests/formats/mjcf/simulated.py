"""What is stated of an MJCF model, as numbers, and what MuJoCo makes of the same file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

import mujoco
import numpy as np

from kinlint.document import Document
from kinlint.formats.decoding import decode
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.formats.source_layer import src
from kinlint.terms import is_iri, literal_value
from kinlint.vocabulary import ATTRIBUTE, INHERITED, SRC

COMPONENTS = ("x", "y", "z", "qw", "qx", "qy", "qz")
MOMENTS = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")


@dataclass
class StatedModel:
    """The statements about the compiled model of a document."""

    document: Document
    said: dict[str, dict[str, str]] = field(default_factory=dict)
    """Values of properties, without their namespaces, by node; those of attributes begin with @."""

    def __post_init__(self) -> None:
        for subject, predicate, value in self.document.statements:
            for space, mark in ((SRC, ""), (ATTRIBUTE, "@"), (INHERITED, "@")):
                if predicate.startswith(f"<{space}"):
                    name = mark + predicate[len(space) + 1 : -1]
                    text = (
                        value if is_iri(value) or value.startswith("_:") else literal_value(value)
                    )
                    self.said.setdefault(subject, {}).setdefault(name, text)

    @property
    def bodies(self) -> list[str]:
        """The nodes of all bodies, the world first, in the order of their definition."""
        worlds = [n for n, said in self.said.items() if said.get("name") == "world"]
        return worlds + [s for s, p, _ in self.document.statements if p == src("inBody")]

    def pose(self, node: str, stem: str) -> np.ndarray:
        """The transform with *stem* that is stated of *node*."""
        if f"{stem}-x" not in self.said[node]:
            return np.eye(4)
        x, y, z, *quaternion = (float(self.said[node][f"{stem}-{c}"]) for c in COMPONENTS)
        rotation = np.zeros(9)
        mujoco.mju_quat2Mat(rotation, np.array(quaternion))
        found = np.eye(4)
        found[:3, :3], found[:3, 3] = rotation.reshape(3, 3), (x, y, z)
        return found

    def joint_of(self, body: str) -> str:
        """The joint, or the weld, right above *body*, which may be a stage."""
        return self._above[body]

    @property
    def _above(self) -> Mapping[str, str]:
        return {said["childBody"]: node for node, said in self.said.items() if "childBody" in said}

    def places(self, positions: Mapping[str, np.ndarray]) -> dict[str, np.ndarray]:
        """Transforms of all bodies in the world for the *positions* of joints, by node."""
        above = self._above
        world = self.bodies[0]
        found = {world: np.eye(4)}

        def place(body: str) -> np.ndarray:
            chain = []
            while body not in found:
                chain.append(body)
                body = self.said[above[body]]["parentBody"]
            for each in reversed(chain):
                joint = above[each]
                parent = found[self.said[joint]["parentBody"]]
                moved = self._motion(joint, positions.get(joint))
                child = np.linalg.inv(self.pose(joint, "child"))
                found[each] = parent @ self.pose(joint, "parent") @ moved @ child
            return found[chain[0]] if chain else found[body]

        for each in self.bodies:
            place(each)
        return found

    def _motion(self, joint: str, q: np.ndarray | None) -> np.ndarray:
        said, found = self.said[joint], np.eye(4)
        if q is None:
            return found
        reference = float(said.get("@ref", 0.0))
        if said["type"] == "slide":
            axis = np.array([float(said[c]) for c in "xyz"])
            found[:3, 3] = axis * (q[0] - reference)
        elif said["type"] in ("hinge", "ball"):
            quaternion = np.zeros(4)
            if said["type"] == "hinge":
                axis = np.array([float(said[c]) for c in "xyz"])
                if said["rangeUnit"].endswith("DEG>"):
                    reference = np.radians(reference)
                mujoco.mju_axisAngle2Quat(quaternion, axis, q[0] - reference)
            else:
                quaternion[:] = q / np.linalg.norm(q)
            rotation = np.zeros(9)
            mujoco.mju_quat2Mat(rotation, quaternion)
            found[:3, :3] = rotation.reshape(3, 3)
        return found

    def inertia(self, body: str) -> tuple[float, np.ndarray, np.ndarray] | None:
        """Mass, centre of mass and inertia in the axes of *body*; None if nothing is stated."""
        said = self.said[body]
        if "centre-x" not in said:
            return None
        if "inertial" in said:
            written = self.said[said["inertial"]]
            mass = float(written["@mass"])
            name = said["momentsIn"]
            count = 6 if name == "fullinertia" else 3
            values = [float(written.get(f"@{name}-{n + 1}", 0)) for n in range(count)]
        else:
            mass = float(said["mass"])
            values = [float(said[each]) for each in MOMENTS]
        xx, yy, zz, xy, xz, yz = [*values, 0.0, 0.0, 0.0][:6]
        tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        place = self.pose(body, "centre")
        rotation = place[:3, :3]
        return mass, place[:3, 3], rotation @ tensor @ rotation.T


def stated(path: Path) -> StatedModel:
    """What is stated of the file at *path*."""
    return StatedModel(read(decode(str(path), path.read_bytes()), ReadOptions()))


def differences(path: Path, model: mujoco.MjModel, seed: int = 1) -> dict[str, float]:
    """The largest differences between what is stated of a file and the *model* of MuJoCo."""
    own = stated(path)
    bodies = own.bodies
    if len(bodies) != model.nbody:
        return {"bodies": abs(len(bodies) - model.nbody)}
    joints = [own.joint_of(body) for body in bodies[1:]]
    data = mujoco.MjData(model)
    rng = np.random.default_rng(seed)
    worst = {"place": 0.0, "mass": 0.0, "centre": 0.0, "inertia": 0.0}
    order = _joint_order(own)
    assert len(order) == model.njnt, (len(order), model.njnt, joints)
    for _ in range(3):
        data.qpos[:] = model.qpos0 + rng.uniform(-1, 1, model.nq)
        mujoco.mj_normalizeQuat(model, data.qpos)
        mujoco.mj_kinematics(model, data)
        sizes = {0: 7, 1: 4, 2: 1, 3: 1}
        q = {
            node: data.qpos[model.jnt_qposadr[n] :][: sizes[model.jnt_type[n]]]
            for n, node in enumerate(order)
        }
        places = own.places({node: each for node, each in q.items() if len(each) < 7})
        free = {own.said[node]["childBody"]: each for node, each in q.items() if len(each) == 7}
        if free:
            places = _moved(own, places, free)
        for number, body in enumerate(bodies):
            expected = np.eye(4)
            expected[:3, :3] = data.xmat[number].reshape(3, 3)
            expected[:3, 3] = data.xpos[number]
            worst["place"] = max(worst["place"], np.abs(places[body] - expected).max())
    for number, body in enumerate(bodies[1:], 1):
        found = own.inertia(body)
        rotation = np.zeros(9)
        mujoco.mju_quat2Mat(rotation, model.body_iquat[number])
        rotation = rotation.reshape(3, 3)
        tensor = rotation @ np.diag(model.body_inertia[number]) @ rotation.T
        if found is None:
            if model.body_mass[number] and own.said[body].get("inertiaUnknown") != "true":
                worst["mass"] = max(worst["mass"], model.body_mass[number])
            continue
        mass, centre, own_tensor = found
        scale = max(1.0, mass)
        worst["mass"] = max(worst["mass"], abs(mass - model.body_mass[number]) / scale)
        if mass:
            worst["centre"] = max(worst["centre"], np.abs(centre - model.body_ipos[number]).max())
            worst["inertia"] = max(
                worst["inertia"], np.abs(own_tensor - tensor).max() / max(1.0, tensor.max())
            )
    return worst


def _joint_order(own: StatedModel) -> list[str]:
    """Nodes of the joints, by body and then by their order in it."""
    above = own._above
    order = []
    for body in own.bodies[1:]:
        chain, at = [], body
        while True:
            joint = above[at]
            if own.said[joint]["type"] != "fixed":
                chain.append(joint)
            at = own.said[joint]["parentBody"]
            if "stageOf" not in own.said.get(at, {}):
                break
        order += reversed(chain)
    return order


def _moved(own, places, free):
    """The places of bodies with free joints, and of what is on them, where those are put."""
    found = {}
    for body in places:
        at = body
        while at not in free and at in own._above:
            at = own.said[own._above[at]]["parentBody"]
        if at not in free:
            found[body] = places[body]
            continue
        q = free[at]
        rotation = np.zeros(9)
        mujoco.mju_quat2Mat(rotation, q[3:])
        target = np.eye(4)
        target[:3, :3], target[:3, 3] = rotation.reshape(3, 3), q[:3]
        found[body] = target @ np.linalg.inv(places[at]) @ places[body]
    return found
