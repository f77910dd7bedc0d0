"""Macros, properties and arguments of xacro: where they are defined, and where they are used.

An expansion has none of them any more, so they are read from the files as they are written.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

from kinlint.document import Document
from kinlint.formats.xacro.definitions import OWN
from kinlint.formats.xacro.dom import Element, Text, VisitRecord
from kinlint.formats.xacro.expansion_limits import LimitExceeded, Limits
from kinlint.formats.xacro.xacro_parser import Malformed, parse
from kinlint.navigation.occurrence import CLASS, Entity, Occurrence, Role
from kinlint.text import Location, SourceText, Span

PREFIX = "xacro:"
DEFINED_BY = {"xacro:macro": "macro", "xacro:property": "property", "xacro:arg": "argument"}
"""The elements that define something by their name, and what kind of thing that is."""
_EVALUATED = re.compile(r"\$\{(?P<expression>[^}]*)\}|\$\((?P<substitution>[^)]*)\)")
_WORD = re.compile(r"[^\W\d]\w*")
_QUOTED = re.compile(r"'[^']*'|\"[^\"]*\"|&quot;.*?&quot;|&apos;.*?&apos;")
_ARGUMENT = re.compile(r"\s*arg\s+(\S+)\s*")
_PARAMETER = re.compile(r"(?:^|(?<=\s))[*]{0,2}([^\W\d]\w*)(?=\s|:|=|$)")


class Named(NamedTuple):
    """A name in a file of macros."""

    kind: str
    """Kind of the named thing."""
    name: str
    """The name."""
    location: Location
    """Its place."""
    within: Element | None = None
    """The macro whose parameter it is, if it is one."""


def xacro_names(document: Document) -> Iterator[Occurrence]:
    """Yield every definition in the files that *document* is made of, and every use of one."""
    roots = [root for each in document.sources if (root := _root(each)) is not None]
    entities: dict[tuple[str, str, Element | None], Entity] = {}
    for root in roots:
        for named in _definitions(root):
            key = named.kind, named.name, named.within
            entity = entities.setdefault(key, _entity(named))
            yield Occurrence(named.location, entity, Role.DESCRIPTION)
    for root in roots:
        for named in _uses(root):
            used = _found(named, entities)
            if used is not None:
                yield Occurrence(named.location, used, Role.REFERENCE)


def label(entity: Entity) -> tuple[str, str] | None:
    """Return the kind and the name of what xacro defines, or of a default class of MJCF.

    None for any other entity.
    """
    kind, colon, rest = entity.partition(":")
    known = colon and kind in (*DEFINED_BY.values(), "parameter", CLASS)
    return (kind, rest.partition("@")[0]) if known else None


def _entity(named: Named) -> Entity:
    place = named.location
    return f"{named.kind}:{named.name}@{place.source.name}:{place.span.start}"


def _found(
    named: Named, entities: Mapping[tuple[str, str, Element | None], Entity]
) -> Entity | None:
    """Return the entity that is used.

    A name in an expression is a parameter of a macro, or a property.
    """
    kind, name, _, within = named
    if kind != "property":
        return entities.get((kind, name, None))
    while within is not None:
        if (parameter := entities.get(("parameter", name, within))) is not None:
            return parameter
        within = within.parentNode
    return entities.get((kind, name, None))


def _root(source: SourceText) -> Element | None:
    if "xacro" not in source.text:
        return None
    try:
        return parse(source, VisitRecord(Limits())).root
    except (Malformed, LimitExceeded):
        return None


def _definitions(root: Element) -> Iterator[Named]:
    source = root.origin.source
    for element in root.everything:
        kind = DEFINED_BY.get(element.tagName)
        spans = element.origin.attributes.get("name")
        if kind is None or spans is None:
            continue
        name = element.getAttribute("name").removeprefix(PREFIX)
        yield Named(kind, name, Location(source, spans.value))
        parameters = element.origin.attributes.get("params") if kind == "macro" else None
        if parameters is not None:
            for match in _PARAMETER.finditer(source[parameters.value]):
                at = parameters.value.start
                span = Span(at + match.start(1), at + match.end(1))
                yield Named("parameter", match[1], Location(source, span), element)


def _uses(root: Element) -> Iterator[Named]:
    source = root.origin.source
    for element in root.everything:
        tag = element.tagName
        if tag.startswith(PREFIX) and tag not in OWN and tag != "xacro:call":
            name = tag.removeprefix(PREFIX).rpartition(".")[2]
            start, end = element.origin.tag
            yield Named("macro", name, Location(source, Span(start + len(PREFIX), end)))
        if tag == "xacro:insert_block" and (block := element.origin.attributes.get("name")):
            yield Named("property", source[block.value], Location(source, block.value), element)
        yield from _evaluated(element, source)


def _evaluated(element: Element, source: SourceText) -> Iterator[Named]:
    """Yield the names in what is evaluated of *element* itself: its attributes and texts."""
    own = [each.value for each in element.origin.attributes.values()]
    own += [each.origin.span for each in element.children if isinstance(each, Text)]
    for span in own:
        for match in _EVALUATED.finditer(source.text, *span):
            if (argument := match["substitution"]) is None:
                yield from _in_expression(match.span("expression"), element, source)
            elif named := _ARGUMENT.fullmatch(argument):
                start = match.start("substitution") + named.start(1)
                place = Location(source, Span(start, start + len(named[1])))
                yield Named("argument", named[1], place)


def _in_expression(span: Iterable[int], element: Element, source: SourceText) -> Iterator[Named]:
    start, end = span
    text = _QUOTED.sub(lambda quoted: " " * len(quoted[0]), source.text[start:end])
    for word in _WORD.finditer(text):
        place = Location(source, Span(start + word.start(), start + word.end()))
        yield Named("property", word[0], place, element)
