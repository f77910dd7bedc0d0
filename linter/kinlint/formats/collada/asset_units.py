"""Units of a COLLADA document: those of the nearest asset, and the tool that decides on angles."""

from __future__ import annotations

from math import isfinite

from kinlint.formats.collada.collada_elements import ColladaElement

METRE = 1.0
RADIAN_TOOLS = frozenset({"OpenRAVE Collada Writer", "URDF Collada Writer"})
"""Authoring tools whose speeds and joint values are in radians."""


def metres(element: ColladaElement) -> float:
    """Return the metres of a length unit at *element*: as the nearest asset with a unit says."""
    for around in (element, *element.ancestors()):
        unit = around.first("asset", "unit")
        if unit is not None:
            return _number(unit.text("meter"))
    return METRE


def _number(written: str) -> float:
    try:
        value = float(written)
    except ValueError:
        return METRE
    return value if isfinite(value) and value > 0 else METRE


def speeds_in_radians(root: ColladaElement) -> bool:
    """Tell whether the tool that wrote the document gives speeds in radians.

    OpenRAVE reads them so, by the name of the tool.
    """
    tool = root.first("asset", "contributor", "authoring_tool")
    return tool is not None and tool.text() in RADIAN_TOOLS
