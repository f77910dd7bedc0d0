"""Stages compose as usd-core composes them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from usd_stages import LAYERS, random_layers, written

from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode
from kinlint.formats.usd.prim_composition import Composer
from kinlint.formats.usd.reader import read_layer
from kinlint.formats.usd.stage import Stage, StagePrim
from kinlint.formats.usd.stage_layers import Layers

Usd = pytest.importorskip("pxr.Usd")


def stage_of(path: Path) -> Stage:
    """Return the stage of the layer at *path*."""
    root = read_layer(decode(str(path), path.read_bytes()))
    return Stage(Composer(Layers(root, ReadOptions(), read_layer)))


def composed(path: Path) -> dict[str, Any]:
    """Return what kinlint makes of the stage at *path*."""
    prims = {path: prim for path, prim in stage_of(path).prims.items() if path != "/"}
    return {path: (prim.type_name, prim.specifier, *_said(prim)) for path, prim in prims.items()}


def _said(prim: StagePrim) -> Iterator[Any]:
    properties = {each.name: each for _, (_, p) in prim.opinions for each in p.properties}
    for name, each in sorted(properties.items()):
        if each.is_relationship:
            yield name, prim.targets(name)
        elif (number := prim.number(name)) is not None:
            yield name, pytest.approx(number)


def expected(path: Path) -> dict[str, Any]:
    """Return what usd-core makes of the same stage."""
    from pxr import Sdf  # noqa: PLC0415  not installed with kinlint

    stage = Usd.Stage.Open(str(path))
    words = {Sdf.SpecifierDef: "def", Sdf.SpecifierOver: "over", Sdf.SpecifierClass: "class"}
    found = {}
    for prim in Usd.PrimRange.AllPrims(stage.GetPseudoRoot()):
        if prim.IsPseudoRoot():
            continue
        said = []
        for name in sorted(prim.GetAuthoredPropertyNames()):
            if relationship := prim.GetRelationship(name):
                said.append((name, [str(each) for each in relationship.GetTargets()]))
            elif isinstance(value := prim.GetAttribute(name).Get(), float | int):
                said.append((name, value))
        word = words[prim.GetSpecifier()]
        found[str(prim.GetPath())] = (str(prim.GetTypeName()), word, *said)
    return found


def test_all_arcs(tmp_path: Path) -> None:
    root = written(tmp_path, LAYERS)

    assert composed(root) == expected(root)


@pytest.mark.parametrize("seed", range(30))
def test_layers_that_refer_to_each_other(seed: int, tmp_path: Path) -> None:
    root = written(tmp_path, random_layers(seed))

    assert composed(root) == expected(root)
