"""Statements about the indices of meshes in COLLADA."""

from __future__ import annotations

from kinlint.formats.collada.collada_elements import ColladaElement
from kinlint.formats.derived_statements import DerivedStatements

PRIMITIVES = ("triangles", "lines")


def state_meshes(root: ColladaElement, said: DerivedStatements) -> None:
    """State how many indices each corner has: one for each offset of the inputs."""
    for each in root.below():
        if each.tag not in PRIMITIVES:
            continue
        offsets = [
            int(text) for one in each.all("input") if (text := one.text("offset")).isdecimal()
        ]
        if offsets:
            said.number(each.node, "indicesEach", max(offsets) + 1)
