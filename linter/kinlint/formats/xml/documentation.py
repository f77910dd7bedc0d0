"""Meaning of the elements and attributes of a format, as its specification has it, in a few words.

The tables are Turtle files, `shapes/formats/*-documentation.ttl`, each loaded when asked for.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

from kinlint import resources
from kinlint.light_dataclasses import dataclass
from kinlint.vocabulary import FMT, RDFS

ANY = "element"
"""Name of the node that speaks of the attributes of all elements."""


@dataclass(frozen=True)
class Documentation:
    """Meaning of elements and attributes."""

    elements: Mapping[str, str]
    """Meaning of elements by tag."""
    attributes: Mapping[tuple[str, str], str]
    """Meaning of attributes by the tag and the name; without a tag, those of any element."""

    def element(self, tag: str) -> str:
        """Return the meaning of elements with *tag*; empty if it is not known."""
        return self.elements.get(tag, "")

    def attribute(self, tag: str, name: str) -> str:
        """Return the meaning of the attribute *name* of elements with *tag*; empty if unknown."""
        return self.attributes.get((tag, name)) or self.attributes.get(("", name), "")


@cache
def documentation(form: str) -> Documentation:
    """Return the meaning of the elements of the format called *form*."""
    import pyoxigraph as ox  # noqa: PLC0415  a native module

    path = resources.data("shapes") / "formats" / f"{form}-documentation.ttl"
    elements: dict[str, str] = {}
    described: list[tuple[str, str]] = []
    lists: dict[str, dict[str, str]] = {}
    for quad in ox.parse(path=path, format=ox.RdfFormat.TURTLE):
        subject, name = str(quad.subject.value), quad.predicate.value
        if name == f"{RDFS}comment":
            elements[subject.rpartition("#")[2]] = quad.object.value
        elif name == f"{FMT}describes":
            tag = subject.rpartition("#")[2]
            described.append(("" if subject == f"{FMT}{ANY}" else tag, quad.object.value))
        else:
            lists.setdefault(subject, {})[name.rpartition("#")[2]] = quad.object.value
    attributes: dict[tuple[str, str], str] = {}
    for tag, head in described:
        attributes[tag, lists[head]["first"]] = lists[lists[head]["rest"]]["first"]
    return Documentation(elements, attributes)
