"""The element that a misspelt tag stands for, by its letters and by its attributes."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from kinlint.formats.xml.element_types import ElementType
from kinlint.suggestion import distance


def element_meant(
    tag: str, like: str | None, attributes: Collection[str], types: Mapping[str, ElementType]
) -> str | None:
    """Return which of *types* the element *tag* with *attributes* is; *like* is nearest by letters.

    Where *like* does not take all attributes, but one other type does that begins with the same
    letter and shares half of the others, it is that one.
    """
    known = types.get(like) if like else None
    if known is None or known.open or _takes(known, attributes):
        return like
    most = (len(tag) + 1) // 2
    others = [
        name
        for name, each in types.items()
        if name[:1] == tag[:1] and _takes(each, attributes) and distance(tag, name, most) <= most
    ]
    return others[0] if len(others) == 1 else like


def _takes(type_: ElementType, attributes: Collection[str]) -> bool:
    return bool(attributes) and all(name in type_.attributes for name in attributes)
