"""A file as triples that remember where they were written."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import NamedTuple

from kinlint.terms import Term, Triple, iri, is_iri
from kinlint.text import SourceText, Span
from kinlint.vocabulary import SRC

ABOUT, NAME = frozenset({iri(f"{SRC}node"), iri(f"{SRC}subject")}), iri(f"{SRC}name")


class NodeSpans(NamedTuple):
    """Where a node is written: its whole description, and its identifier if it has one."""

    whole: Span
    identifier: Span | None = None

    @property
    def best(self) -> Span:
        """The smallest span that names the node."""
        return self.identifier or Span(self.whole.start, min(self.whole.start + 1, self.whole.end))


@dataclass(frozen=True)
class SourceMap:
    """The way back from triples and nodes to the text."""

    triples: Mapping[Triple, Span] = field(default_factory=dict)
    nodes: Mapping[Term, NodeSpans] = field(default_factory=dict)


@dataclass(frozen=True)
class Document:
    """What one file says.

    `statements` holds the asserted triples and those of the source layer, in the order of the
    text, each once. `graph` is the IRI token under which a store keeps them. `prefixes` are the
    file's own abbreviations, for messages. `statements` may repeat what another file says.
    """

    source: SourceText
    graph: Term
    statements: Sequence[Triple] = field(repr=False)
    map: SourceMap = field(repr=False)
    prefixes: Mapping[str, str] = field(default_factory=dict, repr=False)

    @cached_property
    def about(self) -> Mapping[Term, Term]:
        """The domain node, or the graph, that each statement of the source layer speaks of."""
        named = {s: o for s, p, o in self.statements if p == NAME and is_iri(o)}
        return {**named, **{s: o for s, p, o in self.statements if p in ABOUT}}
