"""What is lifted from MJCF moves and weighs as MuJoCo computes it."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from functools import cached_property
from pathlib import Path
from typing import Any

import pytest
from data import locate_data
from lifted import triples
from robot import Joint, Motion, Robot

from kinlint.addresses import element_of, lifted
from kinlint.formats.source_layer import src
from kinlint.terms import Term, Triple, iri
from kinlint.vocabulary import KIN

pytestmark = [pytest.mark.external, pytest.mark.xdist_group("MuJoCo")]
numpy = pytest.importorskip("numpy", reason="MuJoCo comes with numpy")
mujoco = pytest.importorskip("mujoco", reason="compares with MuJoCo, PyPI's mujoco")

TOLERANCE = 1e-9
CONFIGURATIONS = 3
FEWEST = 40
"""Of the models in the data, this many at least are compared."""
SINGLE = ("mjJNT_HINGE", "mjJNT_SLIDE")


class Model(Robot):
    """A lifted model, whose bodies and joints may have no names: nodes stand for them."""

    def __init__(self, said: tuple[Triple, ...]) -> None:
        super().__init__(said)
        self.said = said

    @cached_property
    def order(self) -> list[Term]:
        """The bodies in the order of MuJoCo, the world first."""
        inside = [(s, o) for s, p, o in self.said if p == src("inBody")]
        worlds = dict.fromkeys(o for _, o in inside if all(o != s for s, _ in inside))
        return [lifted(each) for each in (*worlds, *(s for s, _ in inside))]

    def key(self, node: Term) -> str:
        return node

    @cached_property
    def joints(self) -> dict[str, Joint]:
        """The joints of the tree; those that close loops are left out."""
        loops = {s for s, p, _ in self.said if p == src("firstBody")}
        return {k: j for k, j in super().joints.items() if element_of(k) not in loops}

    def is_unknown(self, body: Term) -> bool:
        """Whether the inertia of *body* depends on a mesh."""
        return (element_of(body), src("inertiaUnknown")) in {(s, p) for s, p, _ in self.said}

    def moving(self) -> Iterator[Term]:
        """Yield the joints in the order of MuJoCo."""
        above = {self.value(j.node, f"{KIN}child-body"): j for j in self.joints.values()}
        for body in self.order[1:]:
            chain, at = [], body
            while at is body or "/stage/" in at:
                chain.append(above[at])
                at = self.value(above[at].node, f"{KIN}parent-body")
            fixed = iri(f"{KIN}FixedJoint")
            yield from (each.node for each in reversed(chain) if fixed not in each.kinds)


def frame(body: Term, name: str = "frame") -> Term:
    return f"{body[:-1]}/{name}>"


def compared(path: Path, model: Any) -> float:
    """The largest difference between what is lifted from *path* and the *model* of MuJoCo."""
    with pytest.MonkeyPatch.context() as context:
        context.chdir(path.parent)
        ours, worst = Model(triples(Path(path.name))), 0.0
    data = mujoco.MjData(model)
    joints = list(ours.moving())
    assert len(ours.order) == model.nbody
    assert len(joints) == model.njnt
    numbers = random.Random(path.name)  # noqa: S311
    for _ in range(CONFIGURATIONS):
        data.qpos[:] = model.qpos0
        positions = {}
        for number, node in enumerate(joints):
            at = model.jnt_qposadr[number]
            if mujoco.mjtJoint(model.jnt_type[number]).name in SINGLE:
                positions[node] = [numbers.uniform(-2.0, 2.0)]
                data.qpos[at] += positions[node][0]
        mujoco.mj_kinematics(model, data)
        where = ours.places(frame(ours.order[0]), positions)
        for number, body in enumerate(ours.order):
            place = where[frame(body)]
            there = Motion(
                tuple(tuple(map(float, row)) for row in data.xmat[number].reshape(3, 3)),
                tuple(map(float, data.xpos[number])),
            )
            worst = max(worst, _apart(place, there))
    for number, body in enumerate(ours.order[1:], 1):
        worst = max(worst, _weighs_unlike(ours, body, model, number))
    return worst


def _apart(one: Motion, other: Motion) -> float:
    pairs = [*zip(one.shift, other.shift, strict=True)]
    for mine, theirs in zip(one.turn, other.turn, strict=True):
        pairs += zip(mine, theirs, strict=True)
    return max(abs(a - b) for a, b in pairs)


def _weighs_unlike(ours: Model, body: Term, model: Any, number: int) -> float:
    """How much mass, centre of mass and inertia of a body differ, relative to their size."""
    found = ours.inertias.get(body)
    if found is None:
        return 0.0 if ours.is_unknown(body) else float(model.body_mass[number])
    turn = numpy.zeros(9)
    mujoco.mju_quat2Mat(turn, model.body_iquat[number])
    turn = turn.reshape(3, 3)
    tensor = (turn * model.body_inertia[number]) @ turn.T
    worst = abs(found.mass - model.body_mass[number]) / max(1.0, found.mass)
    if found.mass:
        size = max(1.0, float(abs(tensor).max()))
        away = math.dist(found.centre, model.body_ipos[number])
        worst = max(worst, away, float(abs(numpy.array(found.tensor) - tensor).max()) / size)
    return float(worst)


def test_real_models_move_and_weigh_as_in_mujoco() -> None:
    """Those that load without the meshes that they name."""
    number, differing, unloaded = 0, [], []
    for path in sorted(locate_data("robots", "mjcf").rglob("*.xml")):
        try:
            model = mujoco.MjModel.from_xml_path(str(path))
        except ValueError:
            unloaded.append(path)
            continue
        if model.nbody > 1:
            number += 1
            if not compared(path, model) <= TOLERANCE:
                differing.append(path)
    assert differing == []
    assert number >= FEWEST, f"{len(unloaded)} are not loaded"
