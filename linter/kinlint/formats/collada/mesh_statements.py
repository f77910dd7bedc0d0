"""Statements about the indices and materials of meshes in COLLADA.

The arrays themselves are bulk data, of which nothing else is stated.
"""

from __future__ import annotations

from collections.abc import Mapping

from kinlint.document import NodeSpans
from kinlint.formats.collada.addressing import Addressing
from kinlint.formats.collada.collada_elements import ColladaElement
from kinlint.formats.derived_statements import DerivedStatements
from kinlint.terms import Term

PRIMITIVES = ("triangles", "lines", "polylist")
TOO_LONG = 10
"""Digits of a count that is none."""
LONGEST = 8_000_000
"""Most characters of a list of indices that is looked into."""


def state_meshes(
    addressing: Addressing, text: str, places: Mapping[Term, NodeSpans], said: DerivedStatements
) -> None:
    """State what the primitives of a document take, of which the *text* has nodes at *places*.

    It is how many indices each corner has, one for each offset of the inputs, the greatest index
    of each input with the number of entries that it has, and how many corners polygons have.
    """
    for each in addressing.root.below():
        if each.tag not in PRIMITIVES:
            continue
        inputs = [
            (one, offset)
            for one in each.all("input")
            if (offset := _count(one, "offset")) is not None
        ]
        if not inputs:
            continue
        step = max(offset for _, offset in inputs) + 1
        said.number(each.node, "indicesEach", step)
        listed = each.first("p")
        indices = _integers(listed, text, places)
        for one, offset in inputs:
            entries = _entries(one, addressing)
            if listed is not None and entries is not None and (taken := indices[offset::step]):
                said.state(one.node, "indexList", listed.node)
                said.number(one.node, "greatestIndex", max(taken))
                said.number(one.node, "entries", entries)
        if corners := _integers(each.first("vcount"), text, places):
            said.number(each.node, "corners", sum(corners))


def state_materials(addressing: Addressing, said: DerivedStatements) -> None:
    """State the geometry of each primitive, and of what binds a material where one is drawn."""
    for each in addressing.root.below():
        if each.tag == "geometry":
            for primitive in each.below():
                if "material" in primitive.said:
                    said.state(primitive.node, "shownWith", each.node)
        elif each.tag == "instance_geometry":
            geometry = addressing.instanced(each)
            bound = each.first("bind_material", "technique_common")
            for material in bound.all("instance_material") if bound is not None else ():
                if geometry is not None:
                    said.state(material.node, "bindsFor", geometry.node)


def _entries(given: ColladaElement, addressing: Addressing) -> int | None:
    """Return how many entries the input *given* has; None if that is not said."""
    source = addressing.by_uri(given.text("source"))
    if isinstance(source, ColladaElement) and source.tag == "vertices":
        places = (each for each in source.all("input") if each.text("semantic") == "POSITION")
        place = next(places, None)
        source = addressing.by_uri(place.text("source")) if place is not None else None
    if not isinstance(source, ColladaElement):
        return None
    accessor = source.first("technique_common", "accessor")
    return _count(accessor, "count") if accessor is not None else None


def _count(element: ColladaElement, attribute: str) -> int | None:
    """Return the number that *attribute* is; None for none, or one of more than nine digits."""
    written = element.text(attribute)
    return int(written) if written.isdecimal() and len(written) < TOO_LONG else None


def _integers(
    element: ColladaElement | None, text: str, places: Mapping[Term, NodeSpans]
) -> list[int]:
    """Return the numbers in *element*; none if they are too many, or no integers."""
    if element is None or not element.words:
        return []
    start = text.find(">", places[element.node].whole.start) + 1
    end = text.find("<", start)
    if not 0 < start < end <= start + LONGEST:
        return []
    try:
        return [*map(int, text[start:end].split())]
    except ValueError:
        return []
