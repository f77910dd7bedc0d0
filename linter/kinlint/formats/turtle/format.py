"""The record of Turtle (https://www.w3.org/TR/turtle/)."""

from __future__ import annotations

from kinlint.file_format import Format, Shape

TURTLE = Format(
    name="turtle",
    title="Turtle",
    suffixes=(".ttl",),
    shape=Shape.GRAPH,
    reader="kinlint.formats.turtle.reader",
    editor="kinlint.formats.turtle.editor",
    fence="turtle",
    convertible=True,
    searched=False,
    appendable=True,
)
FORMATS = (TURTLE,)
