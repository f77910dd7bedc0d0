"""Statements about units and directions of a COLLADA document, as its assets say or leave open."""

from __future__ import annotations

from math import hypot

from kinlint.formats.collada.asset_units import metres
from kinlint.formats.collada.collada_elements import ColladaElement
from kinlint.formats.derived_statements import DerivedStatements

METRES = {
    "meter": 1.0, "metre": 1.0, "m": 1.0,
    "decimeter": 0.1, "decimetre": 0.1, "dm": 0.1,
    "centimeter": 0.01, "centimetre": 0.01, "cm": 0.01,
    "millimeter": 0.001, "millimetre": 0.001, "mm": 0.001,
    "micrometer": 1e-6, "micrometre": 1e-6, "micron": 1e-6,
    "kilometer": 1000.0, "kilometre": 1000.0, "km": 1000.0,
    "inch": 0.0254, "in": 0.0254,
    "foot": 0.3048, "feet": 0.3048, "ft": 0.3048,
    "yard": 0.9144, "yd": 0.9144,
    "mile": 1609.344, "mi": 1609.344,
}  # fmt: skip
"""Metres of units, by their names (NIST Handbook 44, appendix C)."""
UP = {"X_UP": 0, "Y_UP": 1, "Z_UP": 2}


def state_assets(root: ColladaElement, said: DerivedStatements) -> None:
    """State what the assets below *root* leave open, and units beside those that they differ from.

    Units are also stated in the metres that their names mean.
    """
    asset = root.first("asset")
    if asset is not None:
        unit = asset.first("unit")
        if unit is None or not unit.text("meter"):
            said.word((unit or asset).node, "implicit", "unit")
        if asset.first("up_axis") is None:
            said.word(asset.node, "implicit", "up_axis")
    for each in (one for one in root.below() if one.tag == "unit" and one.text("meter")):
        name = each.text("name").casefold()
        known = METRES.get(name) or METRES.get(name.removesuffix("s"))
        if known is not None:
            said.number(each.node, "metresByName", known)
        holder = each.parent and each.parent.parent
        if holder is not None and holder is not root and holder.parent is not None:
            said.number(each.node, "metresAround", metres(holder.parent))
    _state_gravity(root, said)


def _state_gravity(root: ColladaElement, said: DerivedStatements) -> None:
    """State the size of gravity as written, and in m/s² by the unit around.

    Also how far it points along the axis that points up, from -1 (down) to 1.
    """
    up = root.first("asset", "up_axis")
    for each in root.below():
        numbers = each.numbers() if each.tag == "gravity" else []
        length = hypot(*numbers)
        if not length or len(numbers) != len(UP):
            continue
        said.number(each.node, "gravity", length)
        said.number(each.node, "metricGravity", length * metres(each))
        if up is not None and up.text() in UP:
            said.number(each.node, "upward", numbers[UP[up.text()]] / length)
            said.word(each.node, "upAxis", up.text())
