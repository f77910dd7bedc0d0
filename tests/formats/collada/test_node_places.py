"""Poses of visual nodes are those that pycollada, which shares no code with kinlint, works out."""

from __future__ import annotations

import io
from pathlib import Path
from unittest import mock

import pytest
from data import locate_data

from kinlint.formats.collada.addressing import Addressing
from kinlint.formats.collada.asset_units import METRE
from kinlint.formats.collada.collada_elements import ColladaElement, tree
from kinlint.formats.collada.transforms import world_place
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode, read
from kinlint.formats.rigid_transform import Transform, rotated

pytestmark = [pytest.mark.oracle, pytest.mark.filterwarnings("ignore")]
CLOSE = 1e-9
SCENES = [
    "<translate>1 -2 3</translate><rotate>0 0 1 90</rotate><rotate>0.6 0 -0.8 37</rotate>",
    "<rotate>0 0 1 -120</rotate><translate>0.1 0.2 -0.3</translate><scale>1 1 1</scale>",
    "<matrix>0 -1 0 4 1 0 0 5 0 0 1 6 0 0 0 1</matrix><rotate>0 1 0 180</rotate>",
    "<matrix>-1 0 0 1 0 -1 0 0 0 0 1 0 0 0 0 1</matrix><translate>1e3 0 -1e-3</translate>",
    "<rotate>1 0 0 720.5</rotate><rotate>0 0 0 90</rotate>",
]
"""Transforms of nodes; pycollada takes axes as they are, and so they are of length 1."""


def columns(place: Transform) -> list[float]:
    """The first three rows of the matrix of *place*."""
    x, y, z = (rotated(place[1], axis) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
    return [v for at in range(3) for v in (x[at], y[at], z[at], place[0][at])]


def ours(text: bytes) -> dict[str, list[float]]:
    """The poses of the nodes of *text* that have an id, in the units of the document."""
    document = read(decode("scene.dae", text), ReadOptions())
    root = tree(document.graph, document.statements)
    assert root is not None
    found = {}
    for id_, node in Addressing(root).ids.items():
        place = world_place(node, METRE) if node.tag == "node" and in_scene(node) else None
        if place is not None:
            found[id_] = columns(place)
    return found


def in_scene(node: ColladaElement) -> bool:
    return any(each.tag == "visual_scene" for each in node.ancestors())


def theirs(text: bytes) -> dict[str, list[float]]:
    """The same by pycollada."""
    collada = pytest.importorskip("collada")
    numpy = pytest.importorskip("numpy")
    found: dict[str, list[float]] = {}

    def descend(node: object, above: object) -> None:
        if isinstance(node, collada.scene.Node):
            matrix = above @ node.matrix
            found[node.id] = [float(v) for v in matrix[:3].flatten()]
            for child in node.children:
                descend(child, matrix)

    # It computes in single precision, unless there is no other than double.
    with mock.patch.object(numpy, "float32", numpy.float64):
        # What is broken in meshes and materials does not matter for the nodes of a scene.
        mesh = collada.Collada(io.BytesIO(text), ignore=[collada.common.DaeError])
        for scene in mesh.scenes:
            for node in scene.nodes:
                descend(node, numpy.identity(4))
    return found


def compared(text: bytes) -> int:
    """Hold the poses of both against each other; return how many there are."""
    own, other = ours(text), theirs(text)
    shared = sorted(id_ for id_ in own if id_ in other)
    for id_ in shared:
        scale = max(1.0, *(abs(v) for v in other[id_]))
        assert own[id_] == pytest.approx(other[id_], abs=CLOSE * scale, nan_ok=False), id_
    return len(shared)


@pytest.mark.parametrize("inner", SCENES[:4])
@pytest.mark.parametrize("outer", SCENES[:2])
def test_transforms_are_composed_in_order(outer: str, inner: str) -> None:
    text = (
        '<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset>'
        "<created>2026-01-01T00:00:00</created><modified>2026-01-01T00:00:00</modified></asset>"
        f'<library_visual_scenes><visual_scene id="s"><node id="a">{outer}<node id="b">{inner}'
        "</node></node></visual_scene></library_visual_scenes>"
        '<scene><instance_visual_scene url="#s"/></scene></COLLADA>'
    )
    assert compared(text.encode()) == 2


@pytest.mark.corpus
def test_nodes_of_public_robots_are_where_pycollada_has_them() -> None:
    robots = sorted(locate_data("robots", "collada").rglob("*.dae"))
    clean = sorted(locate_data("defects", "collada").glob("clean*.dae"))
    counts = {path.name: _count(path) for path in (*robots, *clean)}
    assert sum(counts.values()) > 40
    assert sum(1 for count in counts.values() if count) >= 12


def _count(path: Path) -> int:
    try:
        return compared(path.read_bytes())
    except Exception as error:  # pycollada raises errors of its own and of lxml
        if isinstance(error, AssertionError):
            raise
        return 0
