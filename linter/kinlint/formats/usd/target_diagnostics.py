"""Targets of relationships and connections that lead nowhere, as statements without judgement.

A layer tells that a prim is not there only if nothing else can make it: no layer is weaker, none
is stronger, and nothing is referred to or inherited from above the place.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from kinlint.formats.source_layer import SourceLayer
from kinlint.formats.usd.layer_opinions import Opinions, specs
from kinlint.formats.usd.prim_paths import absolute_path, ancestors
from kinlint.formats.usd.usda_syntax import Prim, Value
from kinlint.suggestion import nearest
from kinlint.terms import Term, literal

MOST_COMPARED = 2_000
"""Most prims whose paths are compared with one that leads nowhere."""
MOST_EXPLAINED = 200
"""Most paths of a layer for which another one is suggested."""


def state_dangling(
    root: Prim, node_of: Mapping[Prim, Term], opinions: Mapping[str, Opinions], layer: SourceLayer
) -> None:
    """State the targets in the layer *root*, whose prims have the nodes *node_of*."""
    layered = any(each.name == "subLayers" for each in root.metadata)
    if layered or any(each.specifier == "over" for each in root.children):
        return
    missing = 0
    for path, prim in specs(root):
        for name, item in _targets(prim):
            target, dot, way = absolute_path(item.text, path).partition(".")
            if _is_missing(target, opinions):
                missing += 1
                words = {"property": name, "written": item.text}
                if missing <= MOST_EXPLAINED and (near := _resembling(target, opinions)):
                    words["resembles"] = f"{near}{dot}{way}"
                said = ((key, literal(text)) for key, text in words.items() if text)
                layer.add_node("DanglingTarget", item.content, ("node", node_of[prim]), *said)


def _targets(prim: Prim) -> Iterator[tuple[str, Value]]:
    """Yield the paths in relationships and connections of *prim*, with the names of these."""
    for each in prim.properties:
        leads = each.is_relationship or each.suffix == "connect"
        if leads and each.value is not None:
            for item in each.value.scalars():
                if item.kind == "path":
                    yield each.name, item


def _is_missing(path: str, opinions: Mapping[str, Opinions]) -> bool:
    """Tell whether there can be no prim at *path*."""
    if not path:
        return True
    if path in opinions or path == "/":
        return False
    around = next((each for each in ancestors(path) if each in opinions), None)
    return around is None or opinions[around].whole


def _resembling(path: str, opinions: Mapping[str, Opinions]) -> str:
    """Return the path of the prim that *path* is most like: one of the same name, or a slip."""
    if len(opinions) > MOST_COMPARED or not path:
        return ""
    name = path.rpartition("/")[2]
    same = [each for each in opinions if each.rpartition("/")[2] == name]
    if len(same) == 1:
        return same[0]
    beside = [each for each in opinions if each.rpartition("/")[0] == path.rpartition("/")[0]]
    return nearest(path, beside) or ""
