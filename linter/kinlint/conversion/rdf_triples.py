"""A composed model as statements."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TypeAlias

import pyoxigraph as ox

from kinlint.conversion.composition import Composition
from kinlint.conversion.expanded_nodes import Node
from kinlint.terms import RDF, XSD

Value: TypeAlias = ox.NamedNode | ox.BlankNode | ox.Literal

TYPE, FIRST, REST, NIL = (ox.NamedNode(RDF + name) for name in ("type", "first", "rest", "nil"))


class Triples:
    """The statements of a model, node by node; lists have labels in their order."""

    def __init__(self, model: Composition) -> None:
        self.model = model
        self._labels = 0

    def __iter__(self) -> Iterator[ox.Triple]:
        self._labels = 0
        for node in self.model.nodes:
            subject = ox.NamedNode(node["@id"])
            for kind in node["@type"]:
                yield ox.Triple(subject, TYPE, ox.NamedNode(kind))
            lists: list[ox.Triple] = []
            for key, values in node.items():
                if key[0] != "@":
                    for value in values:
                        yield ox.Triple(subject, ox.NamedNode(key), self._value(value, lists))
            yield from lists

    def _value(self, value: Node, lists: list[ox.Triple]) -> Value:
        """Return *value* as a term; the triples of a list are added to *lists*."""
        return self._list(value["@list"], lists) if "@list" in value else _term(value)

    def _list(self, items: Sequence[Node], lists: list[ox.Triple]) -> Value:
        first = self._labels + 1
        self._labels += len(items)
        cells = [ox.BlankNode(f"l{number}") for number in range(first, self._labels + 1)]
        rests: list[Value] = [*cells, NIL]
        for item, cell, rest in zip(items, cells, rests[1:], strict=True):
            lists += ox.Triple(cell, FIRST, _term(item)), ox.Triple(cell, REST, rest)
        return rests[0]


def _term(value: Node) -> Value:
    if "@id" in value:
        return ox.NamedNode(value["@id"])
    said = value["@value"]
    if isinstance(said, str):
        return ox.Literal(said, datatype=ox.NamedNode(value.get("@type", f"{XSD}string")))
    kind = "double" if isinstance(said, float) else "integer"
    return ox.Literal(repr(said), datatype=ox.NamedNode(XSD + kind))
