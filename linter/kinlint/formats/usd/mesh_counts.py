"""Numbers of corners, indices and points of meshes, as statements without judgement.

The arrays themselves are bulk data. What is given at times only is left out.
"""

from __future__ import annotations

from collections.abc import Mapping

from kinlint.formats.source_layer import SourceLayer, src
from kinlint.formats.usd.layer_opinions import specs
from kinlint.formats.usd.usda_syntax import Prim, Property
from kinlint.terms import XSD, Term, literal
from kinlint.text import Span

LONGEST = 8_000_000
"""Most characters of an array that is counted."""
COUNTS, INDICES, POINTS = "faceVertexCounts", "faceVertexIndices", "points"


def state_mesh_counts(
    text: str, root: Prim, node_of: Mapping[Prim, Term], layer: SourceLayer
) -> None:
    """State how many corners, indices and points the meshes in the layer *root* have."""
    for _, prim in specs(root):
        given = {each.name: each for each in prim.properties if not each.suffix}
        if prim.type_name == "Mesh" and COUNTS in given and INDICES in given:
            _state(text, node_of[prim], given, layer)


def _state(text: str, node: Term, given: Mapping[str, Property], layer: SourceLayer) -> None:
    corners, indices = (_integers(text, given[name]) for name in (COUNTS, INDICES))
    if corners is None or indices is None:
        return
    found = {"corners": sum(corners), "indices": len(indices)}
    if POINTS in given and indices:
        points = _tuples(text, given[POINTS])
        if points is not None:
            found |= {"points": points, "greatestIndex": max(indices)}
    place = given[INDICES].name_span
    for name, number in found.items():
        layer.triples[node, src(name), literal(str(number), f"{XSD}integer")] = place


def _written(given: Property) -> Span | None:
    value = given.value
    if value is None or value.kind not in ("list", "bulk"):
        return None
    return value.span if value.span.end - value.span.start <= LONGEST else None


def _integers(text: str, given: Property) -> list[int] | None:
    """Return the numbers of the array *given*; None if it is none of integers."""
    span = _written(given)
    if span is None:
        return None
    try:
        lines = text[span.start : span.end].strip("[] \t\r\n").split(",")
        return [int(each) for each in lines if each.strip()]
    except ValueError:
        return None


def _tuples(text: str, given: Property) -> int | None:
    """Return the number of tuples in the array *given*; None if it is no array."""
    span = _written(given)
    return None if span is None else text.count("(", span.start, span.end)
