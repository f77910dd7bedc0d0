"""States of a whole XML file what it describes, and where it is not well-formed."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterable, Sequence
from itertools import islice

from kinlint.addresses import namespaces
from kinlint.formats.source_layer import SourceLayer, src
from kinlint.formats.xml.expat_parsing import ExpatResult
from kinlint.formats.xml.span_lookup import ElementPlaces
from kinlint.terms import XSD, Term, literal
from kinlint.text import SourceText, Span

MOST_SCOPES = 50


def describe(
    layer: SourceLayer,
    scopes: Iterable[tuple[str, Iterable[str]]],
    root: Term,
    places: ElementPlaces,
) -> None:
    """States the root and the namespaces of what is named in *scopes*, the first ones at least."""
    place = places.tag(0).name
    layer.triples[root, src("describedIn"), layer.document] = place
    for scope, tags in islice(scopes, MOST_SCOPES):
        for space in namespaces(scope, tags):
            layer.triples[layer.document, src("ownNamespace"), literal(space)] = place


def state_flaws(
    layer: SourceLayer, source: SourceText, parsed: ExpatResult, nodes: Sequence[Term]
) -> None:
    """States where *source* is not well-formed; of one that nobody can read, only what stops."""
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
