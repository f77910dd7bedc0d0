"""Types of the elements of a format: their attributes, their children, and what refers to what."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.formats.xml.value_reading import Form, ValueReader, value_reader
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import Term, iri

Version = tuple[int, ...]


@dataclass(eq=False, slots=True)
class Slot:
    """A place for a value: an attribute, or the text of an element."""

    predicate: Term
    """Property of the values."""
    reading: ValueReader
    """Reader of the values."""
    _stem: str
    _components: list[Term] = field(default_factory=list)

    @classmethod
    def from_iri(cls, iri_: str, form: Form) -> Slot:
        """Return the slot whose property is *iri_*."""
        return cls(iri(iri_), value_reader(form), iri_)

    def components(self, count: int) -> list[Term]:
        """Return the properties of *count* components."""
        known = self._components
        while len(known) < count:
            known.append(f"<{self._stem}-{len(known) + 1}>")
        return known if len(known) == count else known[:count]


@dataclass(frozen=True, slots=True)
class Lifetime:
    """The first version of a format that has something, and the last, as far as known."""

    since: str | None = None
    """First version of the format that has it; None if unknown."""
    until: str | None = None
    """Last version of the format that has it; None if it is current."""


@dataclass(frozen=True, slots=True)
class Reference:
    """The value of an attribute or text of an element is the name of another element."""

    predicate: Term
    """The property, of `ref:`, that leads from the element to the one that is named."""
    targets: tuple[tuple[str, str], ...]
    """Possible targets, by the namespace of their format and their tag.

    The first that exists counts, or else the last. Those of another format are in the file that
    this one is joined to.
    """
    optional: bool
    """True if the name stands for itself where there is no such element."""
    required: bool
    """True if the value must be there. Elsewhere, nothing is named by an empty one."""
    inside: bool
    """True if the name belongs to the scope of the element itself and not to the enclosing one."""


@dataclass(frozen=True, slots=True)
class Address:
    """The value of an attribute or text of an element leads to another element, not by its name."""

    predicate: Term
    """The property, of `ref:`, that leads from the element to the other one."""
    manner: str
    """"uri", "sid" for a path of scoped identifiers, "parameter", or "path" of a prim."""
    targets: tuple[str, ...]
    """Tags of what it may lead to; none if that may be anything."""


@dataclass(frozen=True, slots=True)
class Angles:
    """Numbers of an attribute, or of the text of an element, that are angles in radians."""

    first: int
    """Number of others before them."""
    attribute: str = ""
    """Attribute of the element, or of the nearest one around that has it, on which that depends;
    empty if it is always so."""
    words: tuple[str, ...] = ()
    """Values of it with which it is so; "" stands for none."""


@dataclass(eq=False, slots=True)
class ElementType:
    """Type of an element below certain others."""

    tag: str
    """Its tag; empty if any."""
    predicate: Term
    """Property from the parent to the element."""
    attributes: dict[str, Slot] = field(default_factory=dict)
    """Slots of attributes, by name."""
    children: dict[str, ElementType] = field(default_factory=dict, repr=False)
    """Types of child elements, by tag."""
    embeds: dict[str, str] = field(default_factory=dict)
    """Children that another format describes, by tag: the IRIs of their types there."""
    once: frozenset[str] = frozenset()
    """Tags of children that may occur once."""
    required: tuple[str, ...] = ()
    """Attributes that must be given."""
    requires: tuple[str, ...] = ()
    """Tags of children without which readers refuse it."""
    expects: tuple[str, ...] = ()
    """Tags of children for which readers have a default, or without which they ignore it."""
    assumed: dict[str, str] = field(default_factory=dict)
    """Defaults of expected children, by tag."""
    content: Slot | None = None
    """Slot of its text, if the format defines one."""
    choices: dict[str, tuple[str, ...]] = field(default_factory=dict)
    """Words that attributes can be, or its text ("")."""
    usual: dict[str, tuple[str, ...]] = field(default_factory=dict)
    """Words that attributes usually are, while others are possible; those of its text are ""."""
    angles: dict[str, tuple[Angles, ...]] = field(default_factory=dict)
    """Angles in attributes, or in its text ("")."""
    references: dict[Term, Reference] = field(default_factory=dict)
    """References by name, by property."""
    addresses: dict[Term, Address] = field(default_factory=dict)
    """References by address, by property."""
    files: frozenset[Term] = frozenset()
    """Properties that name files."""
    leads: dict[Term, ElementType] = field(default_factory=dict, repr=False)
    """Children with references below them, by their properties."""
    scope: tuple[str, ...] = ()
    """Tags of the elements that it knows by name."""
    kind: str = ""
    """Name space of its name; all elements of a kind share one."""
    transparent: bool = False
    """True if what is in it counts as the content of the element around it."""
    open: bool = False
    """True if it takes any child and attribute."""
    data: bool = False
    """True if its text is bulk data, of which only the number of words is stated."""
    unstated: bool = False
    """True if it and what is in it is bulk data, of which nothing is stated."""
    display_only: bool = False
    """True if it and what is in it only matter for display."""
    lifetime: Lifetime | None = None
    """Versions of the format that have the element; None for all."""
    lifetimes: dict[str, Lifetime] = field(default_factory=dict)
    """Versions that have an attribute, by name; others are in all."""
    dated: bool = False
    """True if not every version of the format has it, or one of its attributes."""
    checked: bool = False
    """True if its attributes need checks."""


@dataclass(eq=False, slots=True)
class Schema:
    """Schema of a format."""

    namespace: str
    """Namespace of its elements."""
    roots: dict[str, ElementType]
    """Types of root elements, by tag."""
    types: dict[str, list[ElementType]]
    """All types with a tag."""
    parents: dict[str, list[ElementType]]
    """Types of the possible parents of a tag."""
    names: str = ""
    """Attribute by which elements have names."""
    version: str | None = None
    """Version of a file without one."""
    nested: bool = False
    """True if elements that are known by name stand at any depth."""
    unset: bool = False
    """True if an empty value is none."""

    @property
    def flat(self) -> bool:
        """Tell whether all names are known in the whole file."""
        return all(each is self.roots.get(each.tag) for each in self._scopes)

    def homes(self, tag: str, outer: ElementType) -> list[str]:
        """Return where an element with *tag* belongs that is in one of the type *outer*.

        These are the tags of its possible parents; of those with the tag of *outer*, paths.
        """
        found = [each for each in self.parents.get(tag, ()) if not each.open]
        return list(
            dict.fromkeys(self._path(each) if each.tag == outer.tag else each.tag for each in found)
        )

    def _path(self, type_: ElementType) -> str:
        """Return the tags that lead to *type_* and to no other type of the same tag."""
        tags = [type_.tag]
        while len(tags) <= len(self.types) and len(self.types[type_.tag]) > 1:
            above = [
                each for each in self.parents.get(type_.tag, ()) if type_ in each.children.values()
            ]
            if not above:
                break
            type_ = above[0]
            tags.insert(0, type_.tag)
        return "/".join(tags)

    @property
    def kinds(self) -> frozenset[str]:
        """The tags of what is known by name alone, where no other thing has it."""
        return frozenset(tag for each in self._scopes for tag in each.scope)

    @property
    def _scopes(self) -> Iterator[ElementType]:
        return (each for types in self.types.values() for each in types if each.scope)


ANY = ElementType("", "", open=True)
"""Type of elements that are not of the format itself, with everything below them."""


def version(text: str) -> Version | None:
    """Return the parts of a version number; None if *text* is none."""
    parts = text.strip().split(".")
    return tuple(int(part) for part in parts) if all(p.isdecimal() for p in parts) else None
