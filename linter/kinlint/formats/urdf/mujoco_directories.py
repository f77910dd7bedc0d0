"""Finds where MuJoCo looks for the meshes of a URDF, as its <mujoco><compiler> says."""

from __future__ import annotations

from collections.abc import Mapping

from kinlint.document import Document
from kinlint.terms import Term, iri, literal_value
from kinlint.vocabulary import ATTRIBUTE
from kinlint.vocabulary import URDF as NAMESPACE

MUJOCO, COMPILER, GEOMETRY, MESH, COLLISION, VISUAL = (
    iri(f"{NAMESPACE}{tag}")
    for tag in ("mujoco", "compiler", "geometry", "mesh", "collision", "visual")
)
MESHDIR, ASSETDIR, STRIPPATH, DISCARDVISUAL = (
    iri(f"{ATTRIBUTE}{name}") for name in ("meshdir", "assetdir", "strippath", "discardvisual")
)


def mujoco_directories(document: Document) -> Mapping[Term, tuple[str, bool]]:
    """Return the directory of each mesh that MuJoCo reads, and if it goes by the last part alone.

    The directory is relative to that of the file. Without a <compiler>, none is returned; shapes
    that are only seen are read if `discardvisual` is false.
    """
    if "<compiler" not in document.source.text:
        return {}
    compilers = [value for _, predicate, value in document.statements if predicate == COMPILER]
    if not compilers:
        return {}
    below: dict[tuple[Term, Term], list[Term]] = {}
    for subject, predicate, value in document.statements:
        below.setdefault((subject, predicate), []).append(value)

    def setting(name: Term) -> str:
        found = [value for each in compilers for value in below.get((each, name), ())]
        return literal_value(found[-1]) if found else ""

    kinds = (COLLISION, VISUAL) if setting(DISCARDVISUAL) == "false" else (COLLISION,)
    shapes = [each for (_, p), found in below.items() if p in kinds for each in found]
    meshes = [
        mesh
        for shape in shapes
        for geometry in below.get((shape, GEOMETRY), ())
        for mesh in below.get((geometry, MESH), ())
    ]
    place = setting(MESHDIR) or setting(ASSETDIR), setting(STRIPPATH) == "true"
    return dict.fromkeys(meshes, place)
