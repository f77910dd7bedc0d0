"""Schema of a format: its elements, their attributes and children.

The tables are Turtle files, `shapes/formats/*.ttl`; each is loaded once in a process.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from functools import cache

from kinlint import resources
from kinlint.file_format import Format
from kinlint.formats.xml.value_reading import Form, ValueReader, value_reader
from kinlint.terms import Term, iri
from kinlint.vocabulary import ATTRIBUTE, FMT, KINLINT, SRC

KINDS = ("text", "number", "integer", "boolean", "vectors")
VECTOR = "vector"
TEXT = iri(f"{SRC}text")
Version = tuple[int, ...]


@dataclass(eq=False, slots=True)
class Slot:
    """A place for a value: an attribute, or the text of an element."""

    predicate: Term
    reading: ValueReader
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
    until: str | None = None


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


@dataclass(eq=False, slots=True)
class ElementType:
    """Type of an element below certain others."""

    tag: str
    """Its tag; empty if any."""
    predicate: Term
    """Property from the parent to the element."""
    attributes: dict[str, Slot] = field(default_factory=dict)
    children: dict[str, ElementType] = field(default_factory=dict)
    once: frozenset[str] = frozenset()
    """Tags of children that may occur once."""
    required: tuple[str, ...] = ()
    """Attributes that must be given."""
    requires: tuple[str, ...] = ()
    """Tags of children that must occur."""
    content: Slot | None = None
    """Slot of its text, if the format defines one."""
    choices: dict[str, tuple[str, ...]] = field(default_factory=dict)
    """Words that attributes can be, or its text ("")."""
    references: dict[Term, Reference] = field(default_factory=dict)
    """References by name, by property."""
    files: frozenset[Term] = frozenset()
    """Properties that name files."""
    leads: dict[Term, ElementType] = field(default_factory=dict)
    """Children with references below them, by their properties."""
    scope: tuple[str, ...] = ()
    """Tags of the elements that it knows by name."""
    open: bool = False
    """True if it takes any child and attribute."""
    display_only: bool = False
    """True if it and what is in it only matter for display."""
    lifetime: Lifetime | None = None
    lifetimes: dict[str, Lifetime] = field(default_factory=dict)
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
    parents: dict[str, list[str]]
    """Tags of the possible parents of a tag."""
    names: str = ""
    """Attribute by which elements have names."""
    version: str | None = None
    """Version of a file without one."""

    @property
    def flat(self) -> bool:
        """Tell whether all names are known in the whole file."""
        return all(each is self.roots.get(each.tag) for each in self._scopes)

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


@cache
def schema(form: str) -> Schema:
    """Return the schema of the format called *form*."""
    return _Tables(form).schema()


def kinds(form: Format) -> frozenset[str]:
    """Return the tags of the elements of *form* that are known by name, if it has elements."""
    return schema(form.lifted_as).kinds if form.is_tree else frozenset()


class _Tables:
    """The statements of one schema file, by subject and property."""

    def __init__(self, form: str) -> None:
        import pyoxigraph as ox  # noqa: PLC0415  a native module

        self.namespace = f"{KINLINT}{form}#"
        self.nodes: dict[str, dict[str, list[str]]] = {}
        path = resources.data("shapes") / "formats" / f"{form}.ttl"
        base = path.absolute().as_uri()
        for quad in ox.parse(path=path, format=ox.RdfFormat.TURTLE, base_iri=base):
            entries = self.nodes.setdefault(quad.subject.value, {})
            name = quad.predicate.value.rpartition("#")[2]
            entries.setdefault(name, []).append(quad.object.value)
        self.infinite = any(
            "true" in entries.get("infinite", ()) for entries in self.nodes.values()
        )

    def schema(self) -> Schema:
        """Return the schema, its types linked with each other."""
        found = {
            node: self._type(entries) for node, entries in self.nodes.items() if "tag" in entries
        }
        roots: dict[str, ElementType] = {}
        types: dict[str, list[ElementType]] = {}
        parents: dict[str, list[str]] = {}
        default, names = None, ""
        for node, type_ in found.items():
            entries = self.nodes[node]
            types.setdefault(type_.tag, []).append(type_)
            for child in (*entries.get("once", ()), *entries.get("many", ())):
                type_.children[found[child].tag] = found[child]
                parents.setdefault(found[child].tag, []).append(type_.tag)
            type_.once = frozenset(found[child].tag for child in entries.get("once", ()))
            type_.requires = tuple(found[child].tag for child in entries.get("requires", ()))
            type_.references = dict(self._references(entries, type_))
            if f"{FMT}Root" in entries.get("type", ()):
                roots[type_.tag] = type_
                names = next(iter(entries.get("names", ())), names)
                default = next(iter(entries.get("defaultVersion", ())), default)
        _link(list(found.values()))
        return Schema(self.namespace, roots, types, parents, names, default)

    def _references(
        self, entries: dict[str, list[str]], type_: ElementType
    ) -> Iterator[tuple[Term, Reference]]:
        """Yield what an element of *type_* with *entries* refers to, by property."""
        for word in ("refersTo", "mayReferTo", "refersInside"):
            for predicate, name, *targets in map(self._list, entries.get(word, ())):
                ends = (each.rpartition("#") for each in targets)
                yield (
                    _place(name),
                    Reference(
                        iri(predicate),
                        tuple((f"{space}#", tag) for space, _, tag in ends),
                        optional=word == "mayReferTo",
                        required=not name or name in type_.required,
                        inside=word == "refersInside",
                    ),
                )

    def _type(self, entries: dict[str, list[str]]) -> ElementType:
        tag = entries["tag"][0]
        infinite = self.infinite
        kinds: dict[str, list[str]] = {}
        for kind, names in entries.items():
            if kind in KINDS or (kind.startswith(VECTOR) and kind[len(VECTOR) :].isdecimal()):
                for name in names:
                    kinds.setdefault(name, []).append(kind)
        content = [each.removeprefix(FMT) for each in entries.get("content", ())]
        since, until = (next(iter(entries.get(name, ())), None) for name in ("since", "until"))
        choices = {name: words for name, *words in map(self._list, entries.get("choice", ()))}
        lifetimes = _lifetimes(entries.get("introduced", ()), entries.get("removed", ()))
        return ElementType(
            tag,
            iri(self.namespace + tag),
            {
                name: Slot.from_iri(ATTRIBUTE + name, Form(tuple(each), infinite))
                for name, each in kinds.items()
            },
            required=tuple(entries.get("required", ())),
            content=Slot.from_iri(f"{SRC}text", Form(tuple(content), infinite))
            if content
            else None,
            files=frozenset(map(_place, entries.get("file", ()))),
            scope=tuple(each.rpartition("#")[2] for each in entries.get("scope", ())),
            choices={name: tuple(words) for name, words in choices.items()},
            open="true" in entries.get("open", ()),
            display_only="true" in entries.get("displayOnly", ()),
            lifetime=Lifetime(since, until) if since or until else None,
            lifetimes=lifetimes,
            dated=bool(since or until or lifetimes),
            checked=bool(since or until or lifetimes or choices or entries.get("required")),
        )

    def _list(self, head: str) -> Iterator[str]:
        """Yield the members of the RDF list *head*."""
        while head in self.nodes:
            (first,), (head,) = self.nodes[head]["first"], self.nodes[head]["rest"]
            yield first


def _place(name: str) -> Term:
    """Return the property of the attribute *name*, or that of the text."""
    return iri(ATTRIBUTE + name) if name else TEXT


def _link(types: Sequence[ElementType]) -> None:
    """Have each of *types* lead to those below which elements refer to others, or name files."""
    leading = {id(each) for each in types if each.references or each.files}
    count = -1
    while count < len(leading):
        count = len(leading)
        leading |= {
            id(each)
            for each in types
            if any(id(child) in leading for child in each.children.values())
        }
    for each in types:
        each.leads = {c.predicate: c for c in each.children.values() if id(c) in leading}


def _lifetimes(introduced: Iterable[str], removed: Iterable[str]) -> dict[str, Lifetime]:
    first = dict(each.split() for each in introduced)
    last = dict(each.split() for each in removed)
    return {name: Lifetime(first.get(name), last.get(name)) for name in {**first, **last}}
