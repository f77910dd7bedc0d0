"""Names in all texts of a workspace, found without an analysis."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

from kinlint.file_format import Format
from kinlint.formats.json_text.unfinished_json import UnfinishedJson
from kinlint.formats.recognition import with_format
from kinlint.formats.xml.schema import schema
from kinlint.formats.xml.unfinished_text import TextElement, UnfinishedText
from kinlint.navigation.completion.element_place import types_of
from kinlint.navigation.outline import Sort
from kinlint.navigation.xacro_names import DEFINED_BY
from kinlint.terms import iri
from kinlint.text import Location, SourceText, Span
from kinlint.vocabulary import ATTRIBUTE

SORTS = {
    "robot": Sort.ROBOT,
    "model": Sort.ROBOT,
    "link": Sort.LINK,
    "joint": Sort.JOINT,
    "frame": Sort.FRAME,
    "macro": Sort.MACRO,
    "property": Sort.PROPERTY,
    "argument": Sort.PROPERTY,
}
ID, TYPE = "@id", "@type"
_SUBJECT = re.compile(
    r"(?m)^(?!@|PREFIX|BASE)([^\s#;,.\[\]]+)[ \t\r\n]+(?:a|rdf:type)[ \t\r\n]+(\S+)"
)


class WorkspaceName(NamedTuple):
    """A thing that a text names."""

    name: str
    """Its name."""
    kind: str
    """Tag or class of it."""
    holder: str
    """Name of what it is in; empty if that has none."""
    location: Location
    """Place of the name."""

    @property
    def sort(self) -> Sort:
        """The sort of the thing."""
        return SORTS.get(self.kind.lower(), Sort.OTHER)

    def fits(self, query: str) -> bool:
        """Tell whether the letters of *query* are in the name in their order."""
        letters = iter(self.name.casefold())
        return all(letter in letters for letter in query.casefold())


def workspace_names(source: SourceText) -> Iterator[WorkspaceName]:
    """Yield what *source* describes by a name, in the order of the text."""
    source = with_format(source)
    form = source.format
    if form is None:
        return
    if form.fence == "xml":
        yield from _elements(source, form)
    elif form.fence == "json":
        yield from _nodes(source)
    elif form.fence == "turtle":
        for match in _SUBJECT.finditer(source.text):
            kind = match[2].rpartition(":")[2]
            yield WorkspaceName(match[1], kind, "", Location(source, Span(*match.span(1))))


def _elements(source: SourceText, form: Format) -> Iterator[WorkspaceName]:
    """Yield the elements that others refer to, and the definitions of xacro."""
    table = schema(form.lifted_as)
    known, naming = table.kinds | table.roots.keys(), iri(ATTRIBUTE + table.names)
    for each in UnfinishedText(source.text).elements:
        name = each.attributes.get(table.names, "")
        kind = DEFINED_BY.get(each.tag, each.tag)
        if not name or (each.tag not in known and each.tag not in DEFINED_BY):
            continue
        refers = each.tag not in table.roots and any(
            naming in one.references for one in types_of(each, table)
        )
        if refers and each.tag in known:
            continue
        at = source.text.find(name, _value(source, each, table.names))
        above = (one.attributes.get(table.names, "") for one in each.ancestors)
        holder = next(filter(None, above), "")
        yield WorkspaceName(name, kind, holder, Location(source, Span(at, at + len(name))))


def _value(source: SourceText, element: TextElement, name: str) -> int:
    """Return where the value of the attribute *name* of *element* begins."""
    match = re.compile(rf"\s{re.escape(name)}\s*=\s*[\"']").search(source.text, element.start)
    return match.end() if match else element.start


def _nodes(source: SourceText) -> Iterator[WorkspaceName]:
    """Yield the objects that have an identifier and a type."""
    for node in UnfinishedJson(source.text, -1).nodes:
        name, types = node.get(ID), node.get(TYPE)
        if isinstance(name, str) and types:
            kind = types[0] if isinstance(types, list) else types
            at = source.text.find(f'"{name}"', node.span.start)
            if at >= 0:
                span = Span(at + 1, at + 1 + len(name))
                yield WorkspaceName(name, str(kind), "", Location(source, span))
