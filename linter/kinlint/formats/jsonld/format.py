"""The record of JSON-LD (https://www.w3.org/TR/json-ld11/)."""

from __future__ import annotations

from kinlint.file_format import Format, Shape

JSONLD = Format(
    name="jsonld",
    title="JSON-LD",
    suffixes=(".jsonld",),
    shape=Shape.GRAPH,
    reader="kinlint.formats.jsonld.reader",
    editor="kinlint.formats.jsonld.editing.editor",
    fence="json",
    convertible=True,
)
FORMATS = (JSONLD,)
