"""States which numbers of a URDF have space around them that urdfdom does not take.

It takes blanks between the numbers of a vector, and space before a number, but no tab or line end
behind a number of a vector, and no space at all behind a single one.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator, Sequence

from kinlint.formats.source_layer import SourceLayer
from kinlint.formats.xml.span_lookup import ElementPlaces
from kinlint.terms import XSD, Term, Triple, literal
from kinlint.text import Span
from kinlint.vocabulary import ATTRIBUTE

SPACED = re.compile(
    r"""=\s*+(?:"(?=[^"]*(?:[\t\r\n]|\s"))([-+.\deE\s]*+)"|'(?=[^']*(?:[\t\r\n]|\s'))([-+.\deE\s]*+)')"""
)
"""A value of digits and space, of which some is at its end, or is more than blanks."""

DOUBLE = f"^^<{XSD}double>"


def state_spacing(
    layer: SourceLayer, places: ElementPlaces, nodes: Sequence[Term], statements: Sequence[Triple]
) -> None:
    """States each such value of an attribute that is a number, or several, by *statements*."""
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
    """The attributes with such values: the number of the element, the name, and the value."""
    starts: list[int] = []
    for match in SPACED.finditer(places.text):
        starts = starts or [places.offset(start) for start in places.starts]
        span = Span(*match.span(1 if match[1] is not None else 2))
        number = bisect_right(starts, span.start) - 1
        if number >= 0:
            attributes = places.tag(number).attributes.items()
            yield from ((number, key, span) for key, value in attributes if value == span)


def _reasons(written: str, *, vector: bool) -> Iterator[str]:
    """Why urdfdom does not take the space in *written*, if it does not."""
    if not written.strip():
        return
    if vector:
        parts = (part.lstrip() for part in written.split(" ") if part)
        if any(not part or len(part.split()) > 1 or part != part.rstrip() for part in parts):
            yield "a tab or line end behind a number"
    elif written != written.rstrip():
        yield "space behind the number"
