"""Schema of a format: its elements, their attributes and children.

The tables are Turtle files, `shapes/formats/*.ttl`; each is loaded once in a process. Where a file
of elements is generated, the other one adds to it, and corrects it.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache

from kinlint import resources
from kinlint.file_format import Format
from kinlint.formats.xml.element_types import (
    Address,
    Angles,
    ElementType,
    Lifetime,
    Reference,
    Schema,
    Slot,
)
from kinlint.formats.xml.value_reading import Form
from kinlint.light_dataclasses import replace
from kinlint.terms import Term, iri
from kinlint.vocabulary import ATTRIBUTE, EXTENSION, FMT, KINLINT, SRC

KINDS = ("text", "number", "integer", "boolean", "vectors")
VECTOR = "vector"
KIND_OF_TYPE = {
    "bool": "boolean", "int": "integer", "int64": "integer", "uint": "integer", "uint64": "integer",
    "double": "number", "float": "number", "half": "number", "timecode": "number",
    "asset": "text", "opaque": "text", "pathExpression": "text", "rel": "text", "string": "text",
    "token": "text", "quatd": "vector4", "quatf": "vector4", "matrix4d": "vector16",
}  # fmt: skip
"""Kinds of the values of USD, by their type; those of others follow from their size."""
SIZED = re.compile(r"(?:color|double|float|int|normal|point|texCoord|vector)([234])[dfh]?")
ARRAY = "-array"
"""End of the names of the types of arrays."""
BOUNDS = {"least": ("-inf",), "greatest": ("inf",)}
"""Properties of the range of a number, with those that do not limit it."""
TEXT = iri(f"{SRC}text")
MANNERS = {
    "refersByUri": "uri",
    "refersBySid": "sid",
    "refersToParameter": "parameter",
    "refersByPath": "path",
}
"""Ways of addressing other elements, by the properties that declare them."""


@cache
def schema(form: str) -> Schema:
    """Return the schema of the format called *form*."""
    return _Tables(form).schema()


@cache
def embedded(node: str) -> ElementType:
    """Return the type *node* as it counts in a file of another format.

    Its values are checked. Nothing else is: whoever reads it there knows more children, may read
    any version, and has defaults for what is missing.
    """
    return _Tables(node.rpartition("#")[0].removeprefix(KINLINT)).embedded(node)


def kinds(form: Format) -> frozenset[str]:
    """Return the tags of the elements of *form* that are known by name, if it has elements."""
    return schema(form.lifted_as).kinds if form.is_tree else frozenset()


class _Tables:
    """The statements of one schema file, by subject and property."""

    def __init__(self, form: str) -> None:
        import pyoxigraph as ox  # noqa: PLC0415  a native module

        self.namespace = f"{KINLINT}{form}#"
        self.nodes: dict[str, dict[str, list[str]]] = {}
        folder = resources.data("shapes") / "formats"
        for path in (folder / f"{form}-elements.ttl", folder / f"{form}.ttl"):
            if not path.exists():
                continue
            base = path.absolute().as_uri()
            for quad in ox.parse(path=path, format=ox.RdfFormat.TURTLE, base_iri=base):
                entries = self.nodes.setdefault(quad.subject.value, {})
                name = quad.predicate.value.rpartition("#")[2]
                entries.setdefault(name, []).append(quad.object.value)

    def schema(self) -> Schema:
        """Return the schema, its types linked with each other."""
        found = {
            node: self._type(entries) for node, entries in self.nodes.items() if "tag" in entries
        }
        roots: dict[str, ElementType] = {}
        types: dict[str, list[ElementType]] = {}
        parents: dict[str, list[ElementType]] = {}
        default, names, flags = None, "", set[str]()
        for node, type_ in found.items():
            entries = self.nodes[node]
            types.setdefault(type_.tag, []).append(type_)
            for child in (*entries.get("once", ()), *entries.get("many", ())):
                type_.children[found[child].tag] = found[child]
                parents.setdefault(found[child].tag, []).append(type_)
            once, many, requires, expects = (
                dict.fromkeys(found[child].tag for child in entries.get(word, ()))
                for word in ("once", "many", "requires", "expects")
            )
            type_.embeds = dict(map(self._embedding, entries.get("embeds", ())))
            type_.once = frozenset(once.keys() - many.keys())
            type_.requires = tuple(requires)
            type_.expects = tuple(each for each in expects if each not in requires)
            type_.references = dict(self._references(entries, type_))
            type_.addresses = dict(self._addresses(entries))
            if f"{FMT}Root" in entries.get("type", ()):
                roots[type_.tag] = type_
                names = next(iter(entries.get("names", ())), names)
                default = next(iter(entries.get("defaultVersion", ())), default)
                flags |= {each for each in ("nested", "unset") if "true" in entries.get(each, ())}
        _link(list(found.values()))
        return Schema(
            self.namespace, roots, types, parents, names, default,
            nested="nested" in flags, unset="unset" in flags,
        )  # fmt: skip

    def embedded(self, node: str) -> ElementType:
        """Return the type *node* and those below it, open, and with properties of extensions."""
        entries = self.nodes[node]
        type_ = self._type(entries)
        below = [
            self.embedded(each)
            for each in (*entries.get("once", ()), *entries.get("many", ()))
            if "true" not in self.nodes[each].get("open", ())
        ]
        return replace(
            type_,
            predicate=iri(EXTENSION + type_.tag),
            children={each.tag: each for each in below},
            required=(),
            open=True,
            lifetime=None,
            lifetimes={},
            dated=False,
            checked=bool(type_.choices or type_.usual),
        )

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

    def _addresses(self, entries: dict[str, list[str]]) -> Iterator[tuple[Term, Address]]:
        """Yield what an element with *entries* refers to by address, by property."""
        for word, manner in MANNERS.items():
            for predicate, name, *targets in map(self._list, entries.get(word, ())):
                tags = tuple(each.rpartition("#")[2] for each in targets)
                yield _place(name), Address(iri(predicate), manner, tags)

    def _type(self, entries: dict[str, list[str]]) -> ElementType:
        tag = entries["tag"][0]
        infinite = "true" in entries.get("infinite", ())
        least, greatest = (float(entries.get(word, limit)[0]) for word, limit in BOUNDS.items())
        kinds: dict[str, list[str]] = {}
        for word, names in entries.items():
            if kind := _kind(word):
                for name in _instances(names, entries):
                    kinds.setdefault(name, []).append(kind)
        content = [each.removeprefix(FMT) for each in entries.get("content", ())]
        since, until = (next(iter(entries.get(name, ())), None) for name in ("since", "until"))
        choices, usual = (
            {name: tuple(words) for name, *words in map(self._list, entries.get(property_, ()))}
            for property_ in ("choice", "usual")
        )
        lifetimes = _lifetimes(entries.get("introduced", ()), entries.get("removed", ()))
        return ElementType(
            tag,
            iri(self.namespace + tag),
            {
                name: Slot.from_iri(ATTRIBUTE + name, Form(tuple(each), infinite))
                for name, each in kinds.items()
            },
            required=tuple(entries.get("required", ())),
            content=Slot.from_iri(f"{SRC}text", Form(tuple(content), infinite, least, greatest))
            if content
            else None,
            files=frozenset(map(_place, entries.get("file", ()))),
            scope=tuple(each.rpartition("#")[2] for each in entries.get("scope", ())),
            assumed=dict(each.split(" ", 1) for each in entries.get("assumes", ())),
            choices=choices,
            usual=usual,
            angles=_angles(map(self._list, entries.get("angles", ()))),
            kind=next(iter(entries.get("kind", ())), ""),
            transparent="true" in entries.get("transparent", ()),
            open="true" in entries.get("open", ()),
            data="true" in entries.get("data", ()),
            unstated="true" in entries.get("unstated", ()),
            display_only="true" in entries.get("displayOnly", ()),
            lifetime=Lifetime(since, until) if since or until else None,
            lifetimes=lifetimes,
            dated=bool(since or until or lifetimes),
            checked=bool(
                since or until or lifetimes or choices or usual or entries.get("required")
            ),
        )

    def _embedding(self, node: str) -> tuple[str, str]:
        """Return the tag of a type of another format, which ends its IRI, and the IRI."""
        return node.rpartition("#")[2], node

    def _list(self, head: str) -> Iterator[str]:
        """Yield the members of the RDF list *head*."""
        while head in self.nodes:
            (first,), (head,) = self.nodes[head]["first"], self.nodes[head]["rest"]
            yield first


def _kind(word: str) -> str | None:
    """Return the kind of the values of attributes that a type has by the property *word*."""
    if word in KINDS or (word.startswith(VECTOR) and word[len(VECTOR) :].isdecimal()):
        return word
    if word.endswith(ARRAY):
        return "text"
    sized = SIZED.fullmatch(word)
    return f"{VECTOR}{sized[1]}" if sized else KIND_OF_TYPE.get(word)


def _instances(names: Iterable[str], entries: Mapping[str, Sequence[str]]) -> Iterator[str]:
    """Yield the *names* of attributes, those with a * for each instance of a schema of USD."""
    for name in names:
        if "*" in name:
            yield from (name.replace("*", each) for each in entries.get("instances", ()))
        else:
            yield name


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


def _angles(said: Iterable[Iterable[str]]) -> dict[str, tuple[Angles, ...]]:
    """Return the angles of an element by attribute: `( "lower" "0" "type" "revolute" )`."""
    found: dict[str, tuple[Angles, ...]] = {}
    for name, first, *condition in said:
        attribute = condition[0] if condition else ""
        angles = Angles(int(first), attribute, tuple(condition[1:]))
        found[name] = (*found.get(name, ()), angles)
    return found


def _lifetimes(introduced: Iterable[str], removed: Iterable[str]) -> dict[str, Lifetime]:
    first = dict(each.split() for each in introduced)
    last = dict(each.split() for each in removed)
    return {name: Lifetime(first.get(name), last.get(name)) for name in {**first, **last}}
