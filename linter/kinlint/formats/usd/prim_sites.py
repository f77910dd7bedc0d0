"""Sites of prims: places in layers with opinions about a prim, and arcs between them."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from kinlint.formats.usd.list_operations import changed
from kinlint.formats.usd.prim_paths import absolute_path, is_within, joined
from kinlint.formats.usd.stage_layers import Layer
from kinlint.formats.usd.usda_syntax import Prim, Value
from kinlint.light_dataclasses import dataclass, field

STRENGTH = {"inherit": 0, "variant": 1, "reference": 2, "payload": 3, "specialize": 4}
"""Kinds of arcs, with the order of their strength."""
ARCS = {"references": "reference", "payload": "payload", "payloads": "payload"}
CLASSES = {"inherits": "inherit", "specializes": "specialize"}

Stack = tuple[Layer, ...]


class Opinion(NamedTuple):
    """The opinions of one layer about a prim."""

    layer: Layer
    """The layer."""
    prim: Prim
    """Syntax tree of what it says."""


class Arc(NamedTuple):
    """Arc as it is written: a reference, a payload, or a class."""

    asset: str
    """Asset path; empty if it leads to the same layers."""
    path: str
    """Path of a prim, absolute; empty for the default prim."""


@dataclass(eq=False, slots=True)
class Site:
    """A place in a stack of layers that has opinions about a prim of the stage."""

    kind: str
    """The arc that leads to it: a key of `STRENGTH`, or "root"."""
    stack: Stack
    """The layers, strongest first."""
    path: str
    """Path in them."""
    opinions: list[Opinion]
    """Opinions there, strongest first."""
    above: Site | None = None
    """The site with the arc."""
    source: str = "/"
    """Path that the arc leads to."""
    target: str = "/"
    """Path of the prim with the arc."""
    open: bool = True
    """True if paths outside of the source keep their meaning."""
    depth: int = 0
    """Depth of the prim with the arc; the deeper, the stronger."""
    arcs: list[Site] = field(default_factory=list)
    """Sites that arcs from here lead to."""

    def outer(self, path: str) -> str:
        """Return *path* of this site as a path of the stage; empty if it has none there."""
        site: Site | None = self
        while site is not None and site.above is not None:
            if site.kind != "variant":
                if is_within(path, site.source):
                    path = joined(site.target, path[len(site.source.rstrip("/")) + 1 :]).rstrip("/")
                elif not site.open:
                    return ""
            site = site.above
        return path or "/"

    @property
    def by_class(self) -> bool:
        """True if an arc on the way to it leads to a class."""
        at: Site | None = self
        while at is not None and at.kind not in CLASSES.values():
            at = at.above
        return at is not None

    def ordered(self) -> Iterator[Site]:
        """Yield this site and those below, strongest first."""
        if not self.arcs:
            yield self
            return
        late: list[Site] = []
        pending = [self]
        while pending:
            site = pending.pop()
            yield site
            arcs = sorted(site.arcs, key=lambda each: (STRENGTH[each.kind], -each.depth))
            late += (each for each in arcs if each.kind == "specialize")
            pending += [each for each in reversed(arcs) if each.kind != "specialize"]
            if not pending and late:
                pending.append(late.pop(0))


def listed(value: Value) -> list[Value]:
    """Return the arcs in *value*, which may be a list of them or one."""
    if value.kind == "list":
        return value.items
    return [value] if value.kind in ("asset", "path") else []


def arc_of(item: Value, around: str) -> Arc:
    """Return the arc that *item*, in a prim at *around*, says."""
    target = item if item.kind == "path" else next(iter(item.items), None)
    path = absolute_path(target.text, around) if target is not None and target.text else ""
    return Arc(item.text if item.kind == "asset" else "", path)


def variant_sets(site: Site) -> list[str]:
    """Return the names of the variant sets of *site*."""
    names: list[str] = []
    for _, prim in reversed(site.opinions):
        for given in prim.metadata:
            if given.name == "variantSets":
                value = given.value
                items = value.items if value.kind == "list" else [value]
                names = changed(names, given.operation, [each.text for each in items])
    return names


def selection(root: Site, name: str) -> str:
    """Return the variant of the set *name* that the strongest opinion selects."""
    for site in root.ordered():
        for _, prim in site.opinions:
            for given in prim.metadata:
                if given.name == "variants":
                    for entry in given.value.fields:
                        if entry.name == name:
                            return entry.value.text
    return ""


def variants(site: Site, name: str, chosen: str) -> list[Opinion]:
    """Return the opinions of the variant *chosen* of the set *name* at *site*."""
    return [
        Opinion(layer, variant)
        for layer, prim in site.opinions
        for given in prim.variant_sets
        if given.name == name
        for variant in given.variants
        if variant.name == chosen
    ]
