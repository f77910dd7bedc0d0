"""The layers of a stage: the root layer, and those that its arcs lead to, each read once."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

from kinlint.document import Document
from kinlint.errors import SourceError
from kinlint.files.bounded_read import Unreadable, contents
from kinlint.files.environment import kind
from kinlint.files.pathglob import absolute
from kinlint.files.pathname import shown
from kinlint.files.project_reach import ProjectReach
from kinlint.formats.dependencies.included_text import included_text
from kinlint.formats.options import ReadOptions
from kinlint.formats.usd.format import NEEDED, USD
from kinlint.formats.usd.usda_scanner import MalformedLayer
from kinlint.formats.usd.usda_syntax import Prim, Value
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.terms import Term
from kinlint.text import SourceText

LARGEST = 1 << 26
MOST_LAYERS = 500
"""Limits of the layers of a stage: the bytes of one, and their number."""


@dataclass(eq=False)
class Layer:
    """Layer of a stage."""

    path: Path
    """Path of its file, absolute."""
    root: Prim
    """The layer as it is written."""
    document: Document
    """Its statements."""
    nodes: dict[Prim, Term]
    """Nodes of its prims in its own document."""
    items: dict[Value, Term]
    """Nodes of the items of its lists."""
    include: Term | None = None
    """The element of the stage that first leads to it; None for the root layer."""

    def node(self, prim: Prim) -> Term:
        """Return the node of *prim* in the stage."""
        return self._outer(self.nodes[prim])

    def item(self, value: Value) -> Term:
        """Return the node of an item of a list in the stage."""
        return self._outer(self.items[value])

    def _outer(self, node: Term) -> Term:
        if self.include is None:
            return node
        return f"{self.include[:-1]}/stage{node.partition('#')[2]}"


@dataclass
class Unread:
    """Layer that an arc leads to and that is not read."""

    item: Term
    """Node of the arc."""
    written: str
    """The asset path."""
    reason: str
    """Clause that says why it is not read."""


@dataclass(eq=False)
class Layers:
    """The layers of a stage."""

    root: Layer
    """The root layer."""
    options: ReadOptions
    """The options of the run."""
    parsed: Callable[[SourceText], Layer]
    """Function that reads a text as a layer."""
    unread: list[Unread] = field(default_factory=list)
    """Layers that are not read."""
    found: dict[Path, Layer] = field(default_factory=dict)
    """Other layers, in the order in which they are met."""
    _missed: set[Path] = field(default_factory=set)

    def all(self) -> Iterator[Layer]:
        """Yield all layers, the root layer first."""
        yield self.root
        yield from self.found.values()

    def follow(self, asset: str, at: Layer, item: Value) -> Layer | None:
        """Return the layer that *asset*, an *item* in the layer *at*, leads to.

        None, which is kept with the reason, if it is not read.
        """
        reason = _unsupported(asset)
        if not reason:
            path = absolute(at.path.parent / asset.replace("[", "/").replace("]", ""))
            if path == self.root.path:
                return self.root
            known = self.found.get(path)
            if known is not None:
                return known
            read = self._read(path, at.item(item))
            if isinstance(read, Layer):
                return read
            reason = read
        self.unread.append(Unread(at.item(item), asset, reason))
        return None

    def _read(self, path: Path, include: Term) -> Layer | str:
        """Return the layer at *path*, or why it is not read."""
        package = next((each for each in path.parents if each.suffix.lower() == ".usdz"), None)
        if kind(package or path) != "file":
            return "there is no such file"
        if len(self.found) >= MOST_LAYERS:
            return f"the stage has more than {MOST_LAYERS} layers"
        try:
            layer = self.parsed(replace(self._text(path, package), format=USD))
        except SourceError as error:
            verb = "is" if error.cause == NEEDED else "cannot be read:"
            return f"{path.name} {verb} {error.cause}"
        except MalformedLayer as error:
            return f"{path.name} cannot be read: {error.reason}"
        except Unreadable as error:
            return str(error)
        layer.include = include
        if package is not None:
            layer.path = path
        self.found[path] = layer
        return layer

    def _text(self, path: Path, package: Path | None) -> SourceText:
        """Return the text of the layer at *path*, which may be in a *package*."""
        reach = ProjectReach(self.root.path, self.options.packages_of(str(self.root.path)))
        if package is None:
            return included_text(path, reach, shown(path), self.options, LARGEST)
        from kinlint.formats.usd.binary_layers import member  # noqa: PLC0415  few are packages

        reach.require(package)
        data = contents(package, reach.near, LARGEST)
        found = member(shown(package), data, path.relative_to(package).as_posix())
        if found is None:
            raise Unreadable("there is no such file in the package")
        return found


def _unsupported(asset: str) -> str:
    """Return why *asset* leads to no file beside the layer; empty if it may."""
    if not asset.strip():
        return "the path is empty"
    if "://" in asset or asset.partition(":")[0] in ("omniverse", "anon", "package"):
        return "only a resolver of its own finds it"
    return ""
