"""The observer of how things are written, on their way into the graph."""

from __future__ import annotations

from typing import Any, NamedTuple, Protocol

from kinlint.formats.jsonld.traced_values import Iri, Origin
from kinlint.terms import Term
from kinlint.text import Span


class Slot(NamedTuple):
    """A property of a node: its term, how it is written, and where its values stand."""

    prop: Term | None
    """Property; None if the key means none."""
    key: str
    """Key, as it is written."""
    stands: Span
    """The place of its values."""


class ExpansionObserver(Protocol):
    """Observer of IRIs, and of how nodes and values are written, on the way into the graph."""

    def seen(self, written: Iri, role: str, node: Term | None, slot: Slot | None = None) -> None:
        """Observe that *written* names a node, a property, a datatype or a value."""
        ...

    def note_repeated(self, node: Term, slot: Slot, value: Term, span: Span) -> None:
        """Note that the *value* at *span* of a property without order repeats another."""
        ...

    def nested(self, node: Term, slot: Slot, span: Span, depth: int, outermost: Term) -> None:
        """Note that a node is described within *depth* others, first of all in *outermost*."""
        ...

    def type(self, written: Iri, node: Term | None, origin: Origin | None) -> None:
        """Observe that *written* names the type of a node."""
        ...

    def graph(self, written: Iri) -> None:
        """Observe that *written* names a graph."""
        ...

    def value(self, item: dict[str, Any], node: Term | None, span: Span) -> None:
        """Note that the expanded value *item* at *span* cannot be a value in RDF."""
        ...
