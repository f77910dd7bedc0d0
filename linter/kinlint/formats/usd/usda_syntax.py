"""The syntax tree of a text layer: prims, properties, metadata and values with their spans."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.light_dataclasses import dataclass, field
from kinlint.text import Span


@dataclass(eq=False, slots=True)
class Value:
    """Value as it is written."""

    kind: str
    """Kind of the value: "number", "string", "asset", "path", "name", "tuple", "list", "bulk" for a
    long list of numbers, "dictionary" or "samples"."""
    text: str
    """Content of a scalar without its delimiters, escapes resolved; of others, nothing."""
    span: Span
    """Place, with delimiters."""
    items: list[Value] = field(default_factory=list)
    """Members of a tuple or a list; of a reference, the asset and the path."""
    fields: list[Field] = field(default_factory=list)
    """Entries of a dictionary, and the layer offset of a reference."""

    @property
    def content(self) -> Span:
        """Place of the text of a scalar without its delimiters."""
        start, end = self.span
        if self.kind in ("asset", "path", "string"):
            width = 3 if end - start - len(self.text) >= TRIPLE else 1
            return Span(start + width, end - width)
        return self.span

    def scalars(self) -> Iterator[Value]:
        """Yield the scalars in a tuple or a list at any depth, or the value itself."""
        if self.kind not in ("tuple", "list"):
            yield self
            return
        for each in self.items:
            yield from each.scalars()


TRIPLE = 6
"""Characters of delimiters that come three and three."""


@dataclass(eq=False, slots=True)
class Field:
    """Metadata of a layer, prim or property, or an entry of a dictionary."""

    name: str
    """Name."""
    name_span: Span
    """Place of the name."""
    value: Value
    """Value."""
    operation: str = ""
    """Operation on a list: "prepend", "append", "delete", "add" or "reorder"; empty if explicit."""
    type_name: str = ""
    """Type of an entry of a dictionary; empty for others."""


@dataclass(eq=False, slots=True)
class Property:
    """Attribute, relationship or connection, in one statement."""

    name: str
    """Name with its namespaces, without the suffix."""
    name_span: Span
    """Place of the name."""
    span: Span
    """Place of the statement."""
    type_name: str
    """Type of the values, with "[]" if they are arrays; "rel" for a relationship."""
    type_span: Span
    """Place of the type."""
    suffix: str = ""
    """"connect", "timeSamples", "spline" or nothing."""
    custom: bool = False
    """True if it is declared as custom."""
    variability: str = ""
    """"uniform", "config", "varying" or nothing."""
    operation: str = ""
    """Operation on the list of targets; empty if it is explicit."""
    value: Value | None = None
    """Value; None if none is written."""
    metadata: list[Field] = field(default_factory=list)
    """Metadata."""

    @property
    def is_relationship(self) -> bool:
        """Tell whether it is a relationship."""
        return self.type_name == "rel"


@dataclass(eq=False, slots=True)
class Variant:
    """Set of variants, each a prim in which the name of the variant is that of the prim."""

    name: str
    """Name of the set."""
    name_span: Span
    """Place of the name."""
    span: Span
    """Place of the statement."""
    variants: list[Prim] = field(default_factory=list)
    """Variants in their order."""


@dataclass(eq=False, slots=True)
class Prim:
    """Opinions of one layer about one prim; the layer itself is one without a name."""

    specifier: str
    """"def", "over" or "class"; "variant" for a variant, empty for the layer."""
    name: str
    """Name."""
    name_span: Span
    """Place of the name with its quotes."""
    span: Span
    """Place of the whole."""
    type_name: str = ""
    """Type; empty if none is written."""
    type_span: Span | None = None
    """Place of the type."""
    metadata: list[Field] = field(default_factory=list)
    """Metadata."""
    properties: list[Property] = field(default_factory=list)
    """Properties in their order."""
    variant_sets: list[Variant] = field(default_factory=list)
    """Sets of variants."""
    children: list[Prim] = field(default_factory=list)
    """Prims in it."""
    _by_name: dict[str, list[Prim]] = field(default_factory=dict)

    def named(self, name: str) -> list[Prim]:
        """Return the prims in it that are called *name*; once asked, they are all there."""
        if self.children and not self._by_name:
            for each in self.children:
                self._by_name.setdefault(each.name, []).append(each)
        return self._by_name.get(name, [])

    def field(self, name: str) -> Field | None:
        """Return the last metadata called *name* that is no operation on a list, if any."""
        found = [each for each in self.metadata if each.name == name and not each.operation]
        return found[-1] if found else None

    def text(self, name: str) -> str:
        """Return the text of the metadata called *name*; empty if there is none."""
        found = self.field(name)
        return found.value.text if found is not None else ""
