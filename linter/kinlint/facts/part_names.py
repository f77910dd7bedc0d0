"""Names of the parts of robots, as short as still tells them apart."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import Protocol
from urllib.parse import unquote

from kinlint.addresses import is_address, split, steps, unordered
from kinlint.document import Document
from kinlint.term_format import TermFormatter
from kinlint.terms import Term, iri_value, is_blank
from kinlint.text import Location

WORLD, MODEL = "world", "model"
NAMELESS = "(anonymous)"


class PartPlaces(Protocol):
    """Places of parts in texts; a locator of findings knows them."""

    @property
    def documents(self) -> Sequence[Document]:
        """Documents of the run."""

    @property
    def kinds(self) -> frozenset[str]:
        """Tags of elements that are spoken of by name alone."""

    def node(self, node: Term) -> Location | None:
        """Return the place where *node* is described."""

    def whole(self, node: Term) -> Location | None:
        """Return all of the description of *node*."""

    def display(self, location: Location) -> TermFormatter:
        """Return the formatter of terms with the prefixes of the file of *location*."""


class PartNames:
    """Names of nodes, as the file that describes each abbreviates them."""

    def __init__(self, locator: PartPlaces) -> None:
        self.locator = locator

    def names(self, nodes: Sequence[Term]) -> Mapping[Term, str]:
        """Return the names of *nodes*, less a prefix that all of them share."""
        found = {node: self._name(node) for node in nodes}
        written = [name for node, name in found.items() if not (is_address(node) or is_blank(node))]
        prefixes = {name.partition(":")[0] for name in written if ":" in name}
        if len(prefixes) != 1 or "/" in (prefix := prefixes.pop()):
            return found
        return {node: name.removeprefix(f"{prefix}:") or name for node, name in found.items()}

    def _name(self, node: Term) -> str:
        if is_blank(node):
            return NAMELESS
        if is_address(node):
            return element_name(node, self.locator.kinds)
        location = self.locator.node(node)
        if location is None:
            return self._unplaced(node)
        return self.locator.display(location).term(node)

    def _unplaced(self, node: Term) -> str:
        """Return the name of a node without a place, by the first file that abbreviates it."""
        displays = (TermFormatter(document.prefixes) for document in self.locator.documents)
        names = (display.iri(node[1:-1]) for display in displays)
        return next((name for name in names if name != node[1:-1]), node[1:-1])


def element_name(node: Term, kinds: Collection[str]) -> str:
    """Return the name in the address of a lifted element, with the models that it is in.

    But for the outermost, as SDF writes it: `tool::hand`.
    """
    path = [*steps(split(iri_value(node))[1], kinds)]
    named = [at for at, (_, name) in enumerate(path) if name]
    last = named[-1] if named else 0
    if path[last][0] == WORLD:
        return WORLD
    inner = [unordered(name) for tag, name in path[:last] if tag == MODEL and name][1:]
    own = "/".join(unordered(name or tag) for tag, name in path[last:])
    return unquote("::".join((*inner, own))) or NAMELESS
