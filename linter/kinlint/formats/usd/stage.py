"""The composed prims of a stage, with the values that are in force."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.errors import SourceError
from kinlint.formats.usd.list_operations import changed
from kinlint.formats.usd.prim_composition import Composer
from kinlint.formats.usd.prim_paths import absolute_path, joined
from kinlint.formats.usd.prim_schemas import base_types, expanded, prim_schemas
from kinlint.formats.usd.prim_sites import Opinion, Site
from kinlint.formats.usd.stage_layers import Layer
from kinlint.formats.usd.usda_scanner import MOST
from kinlint.formats.usd.usda_syntax import Prim, Property, Value
from kinlint.light_dataclasses import dataclass, field

DEFINING = ("def", "class")


@dataclass(frozen=True, slots=True)
class Told:
    """Opinion about a property."""

    layer: Layer
    """Its layer."""
    prim: Prim
    """The opinions about the prim that it is one of."""
    property: Property
    """The statement."""


@dataclass(eq=False)
class StagePrim:
    """Prim of a stage."""

    path: str
    """Its path."""
    parent: StagePrim | None
    """Prim around it; None for the root."""
    site: Site
    """Sites with opinions about it."""
    opinions: list[tuple[Site, Opinion]] = field(default_factory=list)
    """Opinions, strongest first, with their sites."""
    children: list[StagePrim] = field(default_factory=list)
    """Prims in it."""
    applied: tuple[str, ...] = ()
    """Schemas that are applied, with instances."""
    type_name: str = ""
    """Its type; empty if it has none."""
    specifier: str = "over"
    """"def", "class", or "over" if nothing defines it."""

    @property
    def name(self) -> str:
        """Its name."""
        return self.path.rpartition("/")[2]

    def is_a(self, *types: str) -> bool:
        """Tell whether its type is one of *types*, or extends one."""
        return not set(types).isdisjoint(base_types(self.type_name))

    def has(self, schema: str) -> bool:
        """Tell whether *schema* is applied to it."""
        return schema in self.applied

    def metadata(self, name: str) -> str:
        """Return the text of the strongest metadata *name*; empty if there is none."""
        return next((text for _, (_, prim) in self.opinions if (text := prim.text(name))), "")

    def told(self, name: str) -> Told | None:
        """Return the strongest opinion with a value of the attribute *name*."""
        for _, (layer, prim) in self.opinions:
            for each in reversed(prim.properties):
                if each.name == name and not each.suffix and each.value is not None:
                    return Told(layer, prim, each)
        return None

    def value(self, name: str) -> Value | None:
        """Return the value of the attribute *name* that is in force; None if there is none."""
        told = self.told(name)
        if told is None or told.property.value is None or told.property.value.text == "None":
            return None
        return told.property.value

    def word(self, name: str) -> str:
        """Return the text of the attribute *name*; empty if it has no value."""
        value = self.value(name)
        return value.text if value is not None else ""

    def words(self, name: str) -> list[str]:
        """Return the texts in the array *name*."""
        value = self.value(name)
        return [each.text for each in value.scalars()] if value is not None else []

    def numbers(self, name: str, count: int = 1) -> list[float] | None:
        """Return the numbers of the attribute *name*; None unless it has *count* of them."""
        value = self.value(name)
        if value is None:
            return None
        scalars = list(value.scalars())
        if len(scalars) != count or any(each.kind != "number" for each in scalars):
            return None
        return [float(each.text) for each in scalars]

    def number(self, name: str) -> float | None:
        """Return the number of the attribute *name*; None if it has none."""
        found = self.numbers(name)
        return found[0] if found else None

    def flag(self, name: str, *, default: bool) -> bool:
        """Return whether the attribute *name* is true; *default* if it has no value."""
        text = self.word(name)
        if not text:
            return default
        return text.lower() in ("true", "yes") or (text[:1].isdigit() and float(text) != 0)

    def targets(self, name: str) -> list[str]:
        """Return the paths that the relationship *name* leads to, in the stage."""
        found: list[str] = []
        for site, (_, prim) in reversed(self.opinions):
            for each in prim.properties:
                if each.name == name and each.is_relationship and each.value is not None:
                    items = each.value.items if each.value.kind == "list" else [each.value]
                    paths = (absolute_path(e.text, site.path) for e in items if e.kind == "path")
                    mapped = (site.outer(path) for path in paths if path)
                    found = changed(found, each.operation, [path for path in mapped if path])
        return found

    def below(self) -> Iterator[StagePrim]:
        """Yield this prim and all below it, each before what is in it."""
        pending = [self]
        while pending:
            at = pending.pop()
            yield at
            pending += at.children[::-1]

    def around(self) -> Iterator[StagePrim]:
        """Yield the prims around it, the nearest first, not the root."""
        at = self.parent
        while at is not None and at.parent is not None:
            yield at
            at = at.parent


class Stage:
    """The stage that *composer* composes.

    Prims that are not active are left out, with all below them. Raises SourceError for too many.
    """

    def __init__(self, composer: Composer) -> None:
        self.composer = composer
        self.root = StagePrim("/", None, composer.site("/"))
        self.prims: dict[str, StagePrim] = {"/": self.root}
        """Prims by their paths."""
        pending = [self.root]
        while pending:
            if len(self.prims) > MOST["prims"]:
                source = composer.layers.root.document.source
                raise SourceError(source.name, f"a stage of more than {MOST['prims']} prims", 1, 1)
            at = pending.pop()
            at.children = list(self._children(at))
            pending += at.children[::-1]

    def _children(self, above: StagePrim) -> Iterator[StagePrim]:
        names: dict[str, None] = {}
        sites = list(above.site.ordered())
        for site in reversed(sites):
            for _, prim in site.opinions:
                names |= dict.fromkeys(each.name for each in prim.children)
        for name in names:
            path = joined(above.path, name)
            made = _made(path, above, self.composer.site(path))
            if made.metadata("active") not in ("false", "0"):
                self.prims[path] = made
                yield made

    def metadata(self, name: str) -> str:
        """Return the metadata *name* of the stage: that of the root layer alone."""
        return self.composer.layers.root.root.text(name)

    def number(self, name: str, default: float) -> float:
        """Return the number *name* in the metadata of the stage."""
        try:
            return float(self.metadata(name))
        except ValueError:
            return default

    def defined(self) -> Iterator[StagePrim]:
        """Yield the prims that are defined and no classes, each before what is in it."""
        pending = self.root.children[::-1]
        while pending:
            at = pending.pop()
            if at.specifier == "def":
                yield at
                pending += at.children[::-1]


def _made(path: str, above: StagePrim, site: Site) -> StagePrim:
    found = [(each, opinion) for each in site.ordered() for opinion in each.opinions]
    prim = StagePrim(path, above, site, found)
    own = [o.prim.specifier for each, o in found if not each.by_class]
    every = [o.prim.specifier for _, o in found]
    prim.specifier = next(
        (e for e in (*own, *sorted(every, reverse=True)) if e in DEFINING), "over"
    )
    prim.type_name = next((t for _, (_, each) in found if (t := each.type_name)), "")
    applied: list[str] = []
    for _, (_, each) in reversed(found):
        for given in each.metadata:
            if given.name == "apiSchemas":
                value = given.value
                items = value.items if value.kind == "list" else [value]
                texts = [item.text for item in items if item.kind == "string"]
                applied = changed(applied, given.operation, texts)
    known = prim_schemas()
    built_in = [name for base in base_types(prim.type_name) for name in known[base].includes]
    prim.applied = expanded((*applied, *built_in))
    return prim
