"""Composes the opinions of layers about one prim, strongest first.

The order is that of OpenUSD: local opinions, then what a prim inherits, the variants that are
selected, references, payloads and what it specializes. Relocates and value clips are not composed.
"""

from __future__ import annotations

from collections.abc import Sequence

from kinlint.errors import SourceError
from kinlint.formats.usd.list_operations import changed
from kinlint.formats.usd.prim_paths import absolute_path, is_within, joined, parent
from kinlint.formats.usd.prim_sites import (
    ARCS,
    CLASSES,
    STRENGTH,
    Arc,
    Opinion,
    Site,
    Stack,
    arc_of,
    listed,
    selection,
    variant_sets,
    variants,
)
from kinlint.formats.usd.stage_layers import Layer, Layers
from kinlint.formats.usd.usda_syntax import Value

MOST_SITES = 20_000
SITES_EACH = 8
"""Greatest number of sites of all prims of a stage, and that for each prim that is written."""
MOST_DEEP = 60
"""Greatest number of arcs that lead from one to the next."""


class Composer:
    """Composes the prims of the stage of *layers*."""

    def __init__(self, layers: Layers) -> None:
        self.layers = layers
        self.count, self.most = 0, MOST_SITES
        self.cycles: list[tuple[Layer, Value]] = []
        """Arcs that lead back to where they come from."""
        self.absent: list[tuple[Layer, Value]] = []
        """Arcs to prims that no layer there has."""
        self._made: dict[tuple[Stack, str], Site] = {}
        self._active: list[tuple[Stack, str]] = []
        self._stacks: dict[Layer, Stack] = {}
        self.stack = self._stack_of(layers.root)

    def site(self, path: str) -> Site:
        """Return the site of the prim at *path* of the stage, with all arcs followed."""
        return self._whole(self.stack, path)

    def _stack(self, layer: Layer) -> Stack:
        """Return *layer* with its sublayers, strongest first, each once."""
        found: dict[Layer, None] = {}
        around: list[Layer] = []

        def add(at: Layer) -> None:
            found[at] = None
            around.append(at)
            for given in at.root.metadata:
                for item in listed(given.value) if given.name == "subLayers" else ():
                    below = self.layers.follow(item.text, at, item)
                    if below in around:
                        self.cycles.append((at, item))
                    elif below is not None and below not in found:
                        add(below)
            around.pop()

        add(layer)
        return tuple(found)

    def _stack_of(self, layer: Layer) -> Stack:
        if layer not in self._stacks:
            self._stacks[layer] = self._stack(layer)
        return self._stacks[layer]

    def _whole(self, stack: Stack, path: str) -> Site:
        key = stack, path
        if key not in self._made:
            site = self._bare(stack, path)
            self._choose_variants(site)
            self._made[key] = site
        return self._made[key]

    def _bare(self, stack: Stack, path: str) -> Site:
        """Return the site at *path* of *stack* without the variants of this very prim."""
        if path == "/":
            return Site("root", stack, "/", [Opinion(each, each.root) for each in stack])
        above = self._whole(stack, parent(path))
        site = self._descended(above, path.rpartition("/")[2], None)
        if site is None:
            return Site("root", stack, path, [])
        self._active.append((stack, path))
        for each in list(site.ordered()):
            self._add_arcs(each)
        self._active.pop()
        return site

    def _descended(self, site: Site, name: str, above: Site | None) -> Site | None:
        """Return the site of the prim *name* in *site*; None if nobody speaks of it."""
        opinions = [
            Opinion(layer, child) for layer, prim in site.opinions for child in prim.named(name)
        ]
        self._count_site(opinions)
        made = Site(
            site.kind, site.stack, joined(site.path, name), opinions, above,
            site.source, site.target, site.open, site.depth,
        )  # fmt: skip
        made.arcs = [
            below for each in site.arcs if (below := self._descended(each, name, made)) is not None
        ]
        return made if opinions or made.arcs or above is None else None

    def _count_site(self, opinions: Sequence[Opinion]) -> None:
        self.count += 1
        if self.count > self.most:
            written = (len(each.nodes) for each in self.layers.all())
            self.most = MOST_SITES + SITES_EACH * sum(written)
        if self.count > self.most:
            root = self.layers.root
            at = root.document.source.position(opinions[0].prim.span.start if opinions else 0)
            cause = f"references make more than {self.most} places of what is written"
            raise SourceError(root.document.source.name, cause, *at)

    def _add_arcs(self, site: Site) -> None:
        """Add the sites that the arcs of *site* lead to."""
        written: dict[str, list[Arc]] = {}
        places: dict[tuple[str, Arc], Opinion] = {}
        items: dict[tuple[str, Arc], Value] = {}
        for opinion in reversed(site.opinions):
            for given in opinion.prim.metadata:
                kind = ARCS.get(given.name) or CLASSES.get(given.name)
                if kind is None:
                    continue
                arcs = []
                for item in listed(given.value):
                    arc = arc_of(item, site.path)
                    arcs.append(arc)
                    places[kind, arc], items[kind, arc] = opinion, item
                written[kind] = changed(written.get(kind, []), given.operation, arcs)
        for kind in STRENGTH:
            for arc in written.get(kind, ()):
                self._add_arc(site, kind, arc, places[kind, arc].layer, items[kind, arc])

    def _add_arc(self, site: Site, kind: str, arc: Arc, layer: Layer, item: Value) -> None:
        stack, path = site.stack, arc.path
        if arc.asset:
            target = self.layers.follow(arc.asset, layer, item)
            if target is None:
                return
            stack = self._stack_of(target)
        if not path:
            name = next((n for each in stack if (n := each.root.text("defaultPrim"))), "")
            if not name:
                return
            path = absolute_path(name, "/")
        around = is_within(site.path, path) and stack == site.stack
        if len(self._active) > MOST_DEEP:
            source = layer.document.source
            cause = f"more than {MOST_DEEP} arcs lead from one to the next"
            raise SourceError(source.name, cause, *source.position(item.span.start))
        if (stack, path) in self._active or around:
            self.cycles.append((layer, item))
            return
        is_class = kind in CLASSES.values()
        if not self._graft(site, kind, stack, path, is_open=is_class or not arc.asset):
            self.absent.append((layer, item))

    def _graft(self, site: Site, kind: str, stack: Stack, path: str, *, is_open: bool) -> bool:
        """Add what is at *path* of *stack* to *site*, and what it inherits to the sites above.

        Return whether there is anything.
        """
        if any(e.kind == kind and e.stack == stack and e.path == path for e in site.arcs):
            return True
        found = self._copy(self._bare(stack, path), site)
        there = any(each.opinions for each in found.ordered())
        if kind != "inherit" and not there:
            return False
        found.kind, found.source, found.target, found.open = kind, path, site.path, is_open
        found.depth = site.path.count("/")
        site.arcs.append(found)
        for each in list(found.ordered()):
            if each.kind == "inherit" and each.above is not None:
                self._imply(each.above, each.path, each.stack)
        return there

    def _imply(self, site: Site, path: str, stack: Stack) -> None:
        """Add the class at *path* of *stack*, which *site* inherits, to all sites above.

        Each may say more of the class, by the path that this has there.
        """
        at = site
        while at.above is not None:
            above = at.above
            if at.kind != "variant" and is_within(path, at.source):
                path = joined(at.target, path[len(at.source) + 1 :]).rstrip("/")
            there = above.stack == stack and at.kind in CLASSES.values()
            known = is_within(above.path, path) or (above.stack, path) in self._active
            if at.kind != "variant" and not there and not known:
                self._graft(above, "inherit", above.stack, path, is_open=True)
            at = above

    def _copy(self, site: Site, above: Site | None) -> Site:
        self._count_site(site.opinions)
        made = Site(
            site.kind, site.stack, site.path, site.opinions, above,
            site.source, site.target, site.open, site.depth,
        )  # fmt: skip
        made.arcs = [self._copy(each, made) for each in site.arcs]
        return made

    def _choose_variants(self, root: Site) -> None:
        """Add the variants that are selected to all sites of a prim."""
        done: set[tuple[int, str]] = set()
        sites = list(root.ordered())
        while sites:
            site = sites.pop(0)
            for name in variant_sets(site):
                if (id(site), name) in done:
                    continue
                done.add((id(site), name))
                chosen = selection(root, name)
                opinions = variants(site, name, chosen) if chosen else []
                if opinions:
                    made = Site("variant", site.stack, site.path, opinions, site)
                    made.depth = site.path.count("/")
                    site.arcs.append(made)
                    self._active.append((site.stack, site.path))
                    self._add_arcs(made)
                    self._active.pop()
                    sites = list(root.ordered())
                    break
