"""What the parts of robots are called: by their files, and as short as still tells them apart."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from urllib.parse import unquote

from kinlint.findings.locator import Locator
from kinlint.kinematics.mechanics import ELEMENT
from kinlint.term_format import Display
from kinlint.terms import Term, is_blank

REPEATED = re.compile(r";[0-9]+$")
WORLD = "world"
MODELS = frozenset({WORLD, "model"})
NAMELESS = "(anonymous)"


class Names:
    """Names of nodes, as the file that describes each abbreviates."""

    def __init__(self, locator: Locator) -> None:
        self.locator = locator

    def of(self, nodes: Sequence[Term]) -> Mapping[Term, str]:
        """The names of *nodes*, less the prefix that all of them that have one share."""
        found = {node: self._name(node) for node in nodes}
        written = [name for node, name in found.items() if not node.startswith((ELEMENT, "_:"))]
        prefixes = {name.partition(":")[0] for name in written if ":" in name}
        if len(prefixes) != 1 or "/" in (prefix := prefixes.pop()):
            return found
        return {node: name.removeprefix(f"{prefix}:") or name for node, name in found.items()}

    def _name(self, node: Term) -> str:
        if is_blank(node):
            return NAMELESS
        if node.startswith(ELEMENT):
            return element_name(node)
        location = self.locator.node(node)
        if location is None:
            return self._unplaced(node)
        return self.locator.display(location).term(node)

    def _unplaced(self, node: Term) -> str:
        """The name of what no file describes, by the first file that abbreviates it."""
        displays = (Display(document.prefixes) for document in self.locator.documents)
        names = (display.iri(node[1:-1]) for display in displays)
        return next((name for name in names if name != node[1:-1]), node[1:-1])


def element_name(node: Term) -> str:
    """The name in the address of what was made of an element, with the models that it is in.

    But for the outermost, as SDF writes it: `tool::hand`.
    """
    steps = node[:-1].partition("#")[2].removeprefix("/").split("/")
    words = [REPEATED.sub("", unquote(step)) for step in steps]
    models = 0
    while len(words) > 2 * models + 2 and words[2 * models] in MODELS:
        models += 1
    inner = [words[2 * at + 1] for at in range(models) if words[2 * at] == "model"][1:]
    own = words[2 * models :]
    if own[0] == WORLD:
        return WORLD
    last = "/".join(own[1:] if len(own) > 1 else own)
    return "::".join((*inner, last)) or NAMELESS
