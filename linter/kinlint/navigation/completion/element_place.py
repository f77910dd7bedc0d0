"""Types that an element being typed can have, and what is allowed in it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.formats.xml.element_types import ElementType, Schema
from kinlint.formats.xml.unfinished_text import TextElement

PREFIXED = ":"
"""Part of the tags of elements that are not of the format itself, such as those of xacro."""
MACRO = "xacro:macro"


def types_of(element: TextElement, table: Schema) -> Sequence[ElementType]:
    """Return the types in *table* that *element* may be of, by the elements around it.

    Elements with a prefix count as if their content stood in their place. Below an unknown one, all
    types with the tag are meant.
    """
    way = [each for each in (*reversed(list(element.ancestors)), element) if _is_own(each)]
    found: Sequence[ElementType] = ()
    for step, each in enumerate(way):
        roots = [table.roots[each.tag]] if each.tag in table.roots and not step else []
        inner = [outer.children[each.tag] for outer in found if each.tag in outer.children]
        found = roots or inner or table.types.get(each.tag, ())
    return found if _is_own(element) else holders(element, table)


def holders(element: TextElement | None, table: Schema) -> Sequence[ElementType]:
    """Return the types of what is written in *element* belongs to: its own, or those around."""
    while element is not None and not _is_own(element):
        element = element.parent
    return () if element is None else types_of(element, table)


def is_in_macro(element: TextElement | None) -> bool:
    """Tell whether the innermost element around is a macro, which may be called anywhere."""
    while element is not None and not _is_own(element):
        if element.tag == MACRO:
            return True
        element = element.parent
    return False


def siblings(parent: TextElement | None) -> Iterator[TextElement]:
    """Yield the elements in *parent* and in those with a prefix around it."""
    while parent is not None:
        yield from parent.children
        if _is_own(parent):
            return
        parent = parent.parent


def _is_own(element: TextElement) -> bool:
    return PREFIXED not in element.tag
