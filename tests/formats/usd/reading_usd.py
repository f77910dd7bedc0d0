"""Layers of USD for tests, and what is stated of them."""

from __future__ import annotations

from collections.abc import Iterator

from support.linting import document

from kinlint.document import Document
from kinlint.terms import Triple, literal_value

HEAD = '#usda 1.0\n(\n    metersPerUnit = 1\n    kilogramsPerUnit = 1\n    upAxis = "Z"\n)\n'


def read(content: str, head: str = HEAD) -> Document:
    """Return the layer with *content* behind *head*."""
    return document(f"{head}{content}", "arm.usda")


def said(read_: Document, property_: str) -> Iterator[tuple[str, str, str]]:
    """Yield the paths of elements with the values of *property_* and the texts at their places."""
    for triple in read_.statements:
        if triple[1].endswith((f"#{property_}>", f"/{property_}>")):
            yield _path(triple[0]), _told(triple), _written(read_, triple)


def values(read_: Document, property_: str) -> dict[str, str]:
    """Return the last value of *property_*, by the paths of elements."""
    return {path: value for path, value, _ in said(read_, property_)}


def _told(triple: Triple) -> str:
    value = triple[2]
    return literal_value(value) if value.startswith('"') else _path(value)


def _path(node: str) -> str:
    return node[1:-1].partition("#")[2]


def _written(read_: Document, triple: Triple) -> str:
    span = read_.map.triples[triple]
    return read_.source[span]
