"""Opinions of one layer about its prims, gathered from all places of the layer."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.formats.usd.usda_syntax import Prim
from kinlint.light_dataclasses import dataclass

ARCS = frozenset({"references", "payload", "payloads", "inherits", "specializes"})
"""Metadata by which other prims contribute to one."""


@dataclass(frozen=True, slots=True)
class Opinions:
    """Opinions of one layer about a prim."""

    type_name: str
    """Type of the prim; "" if the layer does not say."""
    applied: tuple[str, ...]
    """Schemas that the layer applies to it, with their instances, in variants too."""
    whole: bool
    """True if nothing outside of the layer contributes to the prim."""


def specs(root: Prim) -> Iterator[tuple[str, Prim]]:
    """Yield the prims and variants in *root* with the paths of the prims that they speak of."""
    pending = [(f"/{each.name}", each) for each in reversed(root.children)]
    while pending:
        path, prim = pending.pop()
        yield path, prim
        pending += [(f"{path}/{each.name}", each) for each in reversed(prim.children)]
        pending += [(path, each) for given in prim.variant_sets for each in given.variants]


def opinions_of(root: Prim) -> dict[str, Opinions]:
    """Return the opinions of the layer *root* about each prim, by its path."""
    types: dict[str, str] = {}
    applied: dict[str, dict[str, None]] = {}
    defined, opened = set[str](), set[str]()
    layered = any(each.name == "subLayers" for each in root.metadata)
    for path, prim in specs(root):
        above = path.rpartition("/")[0]
        if prim.type_name:
            types.setdefault(path, prim.type_name)
        if prim.specifier in ("def", "class"):
            defined.add(path)
        if above in opened or any(each.name in ARCS for each in prim.metadata):
            opened.add(path)
        applied.setdefault(path, {}).update(dict.fromkeys(_applied(prim)))
    return {
        path: Opinions(
            types.get(path, ""),
            tuple(schemas),
            whole=path in defined and path not in opened and not layered,
        )
        for path, schemas in applied.items()
    }


def _applied(prim: Prim) -> Iterator[str]:
    """Yield the schemas that *prim* applies, with their instances."""
    for each in prim.metadata:
        if each.name == "apiSchemas" and each.operation != "delete":
            yield from (item.text for item in each.value.scalars() if item.kind == "string")
