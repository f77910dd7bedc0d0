"""References by name between elements, according to the schema of their format."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from functools import cache
from typing import NamedTuple

from kinlint.addresses import child, root_of
from kinlint.document import Document
from kinlint.file_format import Format
from kinlint.formats.records import FORMATS
from kinlint.formats.source_layer import src
from kinlint.formats.xml.element_types import ElementType, Reference, Schema
from kinlint.formats.xml.schema import schema
from kinlint.terms import Term, Triple, iri_value, is_literal, literal, literal_value

ROOTS = {each.namespace: each.roots for each in FORMATS}


class NameUse(NamedTuple):
    """Reference of an element by name."""

    element: Term
    """Element that refers."""
    place: Term
    """Property with the name."""
    value: Term
    """The name."""
    reference: Reference
    """Reference, as the schema declares it."""

    @property
    def text(self) -> str:
        """The name; empty if nothing is named: by no name, or by one that xacro has to expand."""
        text = literal_value(self.value)
        return "" if "$" in text else text

    @property
    def is_reference(self) -> bool:
        """Tell whether the element refers to something."""
        return bool(self.text) or (self.reference.required and literal_value(self.value) == "")


def typed(statements: Iterable[Triple], table: Schema) -> Iterator[tuple[Triple, ElementType]]:
    """Yield *statements* that may refer to other elements or to files, with the element's type.

    Elements are stated before what is in them.
    """
    roots = {each.predicate: each for each in table.roots.values()}
    types: dict[Term, ElementType] = {}
    around: dict[Term, ElementType] = {}
    telling = _telling(table)
    for triple in statements:
        subject, predicate, value = triple
        if predicate not in telling:
            continue
        type_ = types.get(subject)
        inner = type_ and type_.leads.get(predicate)
        if inner or (inner := roots.get(predicate)):
            types[value] = around.get(subject, inner)
            if inner.transparent and type_:
                around[value] = type_
        elif type_ and is_literal(value):
            yield triple, type_


@cache
def _telling(table: Schema) -> frozenset[Term]:
    """Return the properties that lead to elements that refer to others or to files, or that do."""
    every = [each for same in table.types.values() for each in same]
    inner = (each.predicate for each in (*table.roots.values(), *every))
    return frozenset(inner).union(*(each.references for each in every), _file_places(table))


@cache
def _file_places(table: Schema) -> frozenset[Term]:
    """Return the properties whose values name files, at least of some elements."""
    return frozenset().union(*(each.files for same in table.types.values() for each in same))


def names(statements: Iterable[Triple], table: Schema) -> Iterator[NameUse]:
    """Yield the names by which elements refer to others, in *statements* that put parents first."""
    for (element, place, value), type_ in typed(statements, table):
        if (reference := type_.references.get(place)) is not None:
            yield NameUse(element, place, value, reference)


def file_names(document: Document) -> Iterator[Triple]:
    """Yield the statements of *document* whose value names a file, such as one of a mesh."""
    if not document.format.is_tree:
        return
    table = schema(document.format.lifted_as)
    if document.saying(*_file_places(table)):
        for triple, type_ in typed(document.statements, table):
            if triple[1] in type_.files:
                yield triple


def names_in(document: Document) -> Iterator[NameUse]:
    """Yield the names by which elements of *document*, a tree, refer to others."""
    yield from names(document.statements, schema(document.format.lifted_as))


def properties(form: Format) -> frozenset[Term]:
    """Return the properties, of `ref:`, that lead from elements of the format *form* to others."""
    types = schema(form.lifted_as).types.values()
    each_type = (type_ for same in types for type_ in same)
    return frozenset(each.predicate for type_ in each_type for each in type_.references.values())


def resolve_references(
    found: Iterable[NameUse],
    table: Schema,
    known: Collection[Term],
    joined: tuple[Term, Collection[Term]] | None = None,
) -> Iterator[tuple[Triple, Triple]]:
    """Yield what leads from the elements of the names *found* to what they name, there or not.

    With each statement comes the one that has the name, and so its place.

    Names are of what stands right below a root: of the file itself, whose nodes are *known*, or of
    the one that it is *joined* to, with its nodes. What may be of another file is left out without
    that, and what cannot be with it.
    """
    for each in found:
        reference = each.reference
        foreign = any(space != table.namespace for space, _ in reference.targets)
        if not each.is_reference or foreign != (joined is not None):
            continue
        target, tag, nodes = None, "", known
        for space, tag in reference.targets:
            own = space == table.namespace
            home, nodes = (each.element, known) if own or joined is None else joined
            target = _target(root_of(home), space, tag, each.text)
            if target in nodes:
                break
            if reference.optional:
                target = None
        if target is not None:
            source = each.element, each.place, each.value
            yield (each.element, reference.predicate, target), source
            if target not in nodes:
                yield from ((gap, source) for gap in _dangling(each, tag, target))


def gap_of(name: NameUse) -> Term:
    """Return the node that stands for what *name* does not lead to."""
    return f"{name.element[:-1]};{iri_value(name.reference.predicate).rpartition('#')[2]}>"


def _dangling(name: NameUse, tag: str, target: Term) -> Iterator[Triple]:
    """Yield that there is no *target* with *tag*, which an element refers to by *name*."""
    gap = gap_of(name)
    yield name.element, src("dangling"), gap
    yield gap, src("property"), name.place
    yield gap, src("written"), name.value
    yield gap, src("tag"), literal(tag)
    yield gap, src("target"), target


def _target(root: Term, space: str, tag: str, name: str) -> Term:
    """Return the element with *tag* and *name* of a file whose root element is *root*."""
    if tag in ROOTS.get(space, ()):
        return root
    return child(root, tag, name) if name else f"{child(root, tag)[:-1]}/>"
