"""Types of the values of attributes that are numbers or truth values."""

from __future__ import annotations

from functools import cache

from kinlint.light_dataclasses import dataclass

TRUTHS = {"true": "true", "yes": "true", "false": "false", "no": "false"}
"""Words that OpenUSD reads as truth values, in upper or lower case."""

_WIDE = frozenset(
    {"double", "float", "half", "int", "int64", "uint", "uint64", "uchar", "timecode"}
)
_SHORT = {"h": "half", "f": "float", "d": "double", "i": "int"}
MATRICES = {"matrix2d": 2, "matrix3d": 3, "matrix4d": 4, "frame4d": 4}
"""Rows of the types that are matrices."""
_COUNTS = {
    "point3": 3, "normal3": 3, "vector3": 3, "color3": 3, "color4": 4, "texCoord2": 2,
    "texCoord3": 3, "quat": 4,
}  # fmt: skip
"""Components of the types of which the last letter tells the precision."""


@dataclass(frozen=True, slots=True)
class ValueType:
    """Type of the values of an attribute."""

    scalar: str
    """Type of the components of numbers, "bool", or "" for words."""
    count: int
    """Number of components; 1 for what is no tuple."""
    array: bool
    """True for an array of such values."""


@cache
def value_type(name: str) -> ValueType | None:
    """Return the type called *name*; None if its values are words or it is not known."""
    base = name.removesuffix("[]")
    array = base != name
    if base == "bool" or base in _WIDE:
        return ValueType(base, 1, array)
    if base in MATRICES:
        return ValueType("double", MATRICES[base] ** 2, array)
    stem, end = base[:-1], base[-1:]
    if end in "234" and stem in _WIDE:
        return ValueType(stem, int(end), array)
    count = _COUNTS.get(stem)
    return ValueType(_SHORT[end], count, array) if count and end in _SHORT else None
