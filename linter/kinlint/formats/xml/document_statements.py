"""Statements about a whole XML file: namespaces, syntax errors, spacing of numbers."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice

from kinlint.addresses import namespaces
from kinlint.formats.source_layer import SourceLayer, src
from kinlint.formats.xml.elements import Elements
from kinlint.formats.xml.expat_parsing import ExpatResult
from kinlint.formats.xml.span_lookup import ElementPlaces
from kinlint.terms import XSD, Term, Triple, literal
from kinlint.text import SourceText, Span
from kinlint.vocabulary import ATTRIBUTE, KINLINT

MOST_SCOPES = 50


def describe(
    layer: SourceLayer,
    scopes: Iterable[tuple[str, Iterable[str]]],
    root: Term,
    places: ElementPlaces,
) -> None:
    """State the root and the namespaces of what is named in *scopes*, the first ones at least."""
    place = places.tag(0).name
    layer.triples[root, src("describedIn"), layer.document] = place
    for scope, tags in islice(scopes, MOST_SCOPES):
        for space in namespaces(scope, tags):
            layer.triples[layer.document, src("ownNamespace"), literal(space)] = place


def state_flaws(
    layer: SourceLayer, source: SourceText, parsed: ExpatResult, nodes: Sequence[Term]
) -> None:
    """State where *source* is not well-formed; if it cannot be read, only the fatal error."""
    whole = ("node", layer.document)
    if parsed.fatal is not None:
        span, reason, _ = parsed.fatal
        unread = ("unread", literal("true", f"{XSD}boolean"))
        layer.add_node("MalformedText", span, whole, ("reason", literal(reason)), unread)
        return
    for span, reason in source.misread:
        layer.add_node("MalformedText", span, whole, ("reason", literal(reason)))
    if not parsed.text.flaws:
        return
    starts = [parsed.offset(start) for start in parsed.elements.starts]
    for span, reason, attribute in parsed.text.flaws:
        number = bisect_right(starts, span.start) - 1
        node = ("node", nodes[number]) if number >= 0 else whole
        if attribute is None:
            layer.add_node("MalformedText", span, node, ("reason", literal(reason)))
        else:
            tag = _tag(source, Span(starts[number], span.start))
            said = ("attribute", literal(attribute)), ("tag", literal(tag))
            layer.add_node("RepeatedAttribute", span, node, *said)


def _tag(source: SourceText, span: Span) -> str:
    words = source[span].lstrip("<").split(maxsplit=1)
    return words[0] if words else ""


SPACED = re.compile(
    r"""=\s*+(?:"(?=[^"]*(?:[\t\r\n]|\s"))([-+.\deE\s]*+)"|'(?=[^']*(?:[\t\r\n]|\s'))([-+.\deE\s]*+)')"""
)
"""A value of digits and space, of which some is at its end, or is more than blanks."""

DOUBLE = f"^^<{XSD}double>"


def state_spacing(
    layer: SourceLayer, places: ElementPlaces, nodes: Sequence[Term], statements: Sequence[Triple]
) -> None:
    """State each value of an attribute with such space that is a number, or several."""
    spaced = list(_spaced(places))
    if not spaced:
        return
    wanted = {nodes[number] for number, _, _ in spaced}
    numeric = {(s, p) for s, p, o in statements if s in wanted and o.endswith(DOUBLE)}
    for number, key, span in spaced:
        stem = f"<{ATTRIBUTE}{key}"
        vector = (nodes[number], f"{stem}-1>") in numeric
        if not vector and (nodes[number], f"{stem}>") not in numeric:
            continue
        tag = places.text[slice(*places.tag(number).name)]
        for reason in _reasons(places.text[slice(*span)], vector=vector):
            details = ("attribute", key), ("tag", tag), ("reason", reason)
            terms = ((name, literal(each)) for name, each in details)
            layer.add_node("UnreadSpace", span, ("node", nodes[number]), *terms)


def _spaced(places: ElementPlaces) -> Iterator[tuple[int, str, Span]]:
    """Yield the attributes with such values: the number of the element, the name, and the value."""
    starts: list[int] = []
    for match in SPACED.finditer(places.text):
        starts = starts or [places.offset(start) for start in places.starts]
        span = Span(*match.span(1 if match[1] is not None else 2))
        number = bisect_right(starts, span.start) - 1
        if number >= 0:
            attributes = places.tag(number).attributes.items()
            yield from ((number, key, span) for key, value in attributes if value == span)


MATERIAL = f"<{KINLINT}urdf#material>"
LOOKS = frozenset({f"<{KINLINT}urdf#color>", f"<{KINLINT}urdf#texture>"})
NAME = f"<{ATTRIBUTE}name>"
NAMELESS = literal("")


def state_early_uses(layer: SourceLayer, places: ElementPlaces, elements: Elements) -> None:
    """State each material that is used before the one in which it is defined, in a visual.

    Those of the robot are read first, wherever they are, and one without a name is no other's.
    """
    index, root = elements.index, next(iter(elements.index), "")
    holders = {o: s for s, p, o in elements.statements if p == MATERIAL}
    if not holders:
        return
    names = (each for each in elements.statements if each[1] == NAME and each[2] != NAMELESS)
    named = {node: name for node, _, name in names if node in holders}
    defined: dict[Term, int] = {}
    for node, prop, _ in elements.statements:
        if prop in LOOKS and (name := named.get(node)) is not None:
            number = -1 if holders[node] == root else index[node]
            defined[name] = min(number, defined.get(name, number))
    for node, name in named.items():
        if holders[node] != root and index[node] < defined.get(name, -1):
            span = places.tag(index[node]).name
            layer.add_node("EarlyUse", span, ("node", node), ("written", name))


def _reasons(written: str, *, vector: bool) -> Iterator[str]:
    """Yield the reason why urdfdom does not take the space in *written*, if it does not."""
    if not written.strip():
        return
    if vector:
        parts = (part.lstrip() for part in written.split(" ") if part)
        if any(not part or len(part.split()) > 1 or part != part.rstrip() for part in parts):
            yield "a tab or line end behind a number"
    elif written != written.rstrip():
        yield "space behind the number"
