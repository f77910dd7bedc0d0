"""The elements that a document states, as its format layer has them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import lru_cache

from kinlint.formats.records import ELEMENTS
from kinlint.formats.xml.editing.spelling import is_number
from kinlint.formats.xml.span_lookup import AT, COMPONENT, TEXT, TEXT_ITSELF
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import Term, Triple, is_literal
from kinlint.vocabulary import EXTENSION

KEPT = 10_000
"""Maximum number of cached properties; no file has as many."""

SPACES = tuple(f"<{space}" for space in (*ELEMENTS, EXTENSION))


@lru_cache(KEPT)
def tag_of(predicate: Term) -> str | None:
    """Return the tag of the elements that *predicate* leads to; None if it leads to none."""
    for space in SPACES:
        if predicate.startswith(space):
            return predicate[len(space) : -1]
    return None


def slot_of(predicate: Term, value: Term) -> tuple[str, int] | None:
    """Return the attribute that *predicate* tells, and which number of it, 0 for all.

    Text is the attribute without a name. None if it tells neither.
    """
    component, whole = _slots(predicate)
    return component if component is not None and is_number(value) else whole


@lru_cache(KEPT)
def _slots(predicate: Term) -> tuple[tuple[str, int] | None, tuple[str, int] | None]:
    """Return the slot of *predicate* for a number, if that differs, and for other values."""
    if predicate == TEXT_ITSELF:
        return None, ("", 0)
    if predicate.startswith(f"<{TEXT}-"):
        return None, ("", int(predicate[len(TEXT) + 2 : -1]))
    if not predicate.startswith(AT):
        return None, None
    name = predicate[len(AT) : -1]
    part = COMPONENT.fullmatch(name)
    return (part[1], int(part[2])) if part else None, (name, 0)


@dataclass
class StatedElement:
    """An element: where it stands, and the terms of its values by slot and number of component."""

    parent: Term
    """Node of the element around it."""
    predicate: Term
    """Property that leads to it, named by its tag."""
    slots: dict[str, dict[int, Term]] = field(default_factory=dict)
    """Values by slot, and in that by number of component."""
    children: list[Term] = field(default_factory=list)
    """Nodes of its child elements."""

    @property
    def tag(self) -> str:
        """Return its tag."""
        return tag_of(self.predicate) or ""


def elements(statements: Iterable[Triple]) -> Mapping[Term, StatedElement]:
    """Return the elements in *statements*, by the nodes that stand for them."""
    found: dict[Term, StatedElement] = {}
    for subject, predicate, value in statements:
        if is_literal(value):
            if (holder := found.get(subject)) and (slot := slot_of(predicate, value)):
                holder.slots.setdefault(slot[0], {}).setdefault(slot[1], value)
        elif tag_of(predicate) is not None:
            found[value] = StatedElement(subject, predicate)
            if (holder := found.get(subject)) is not None:
                holder.children.append(value)
    return found
