"""A file as triples that remember where they were written."""

from __future__ import annotations

from abc import abstractmethod
from bisect import bisect_right
from collections import defaultdict
from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import NamedTuple

from kinlint.file_format import Format
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import Term, Triple, iri, is_iri
from kinlint.text import Location, SourceText, Span
from kinlint.vocabulary import SRC

FROM = iri(f"{SRC}from")
"""Property from a lifted node to the elements that it was made of."""

ABOUT, NAME = (iri(f"{SRC}node"), iri(f"{SRC}subject")), iri(f"{SRC}name")


class NodeSpans(NamedTuple):
    """Place of a node: its whole description, and its identifier if it has one."""

    whole: Span
    """Span of the description."""
    identifier: Span | None = None
    """Span of the name in it; None for nodes without one."""

    @property
    def best(self) -> Span:
        """The smallest span that names the node."""
        return self.identifier or Span(self.whole.start, min(self.whole.start + 1, self.whole.end))


class OrderedNodes(Mapping[Term, NodeSpans]):
    """Places of the nodes of a text that can be compared with those of the text after an edit."""

    @abstractmethod
    def in_same_order(self, others: Mapping[Term, NodeSpans]) -> bool:
        """Tell whether *others* are the same nodes, and described in the same order.

        Blank nodes that only say what is lost of the text need not be compared.
        """


@dataclass(frozen=True)
class SourceMap:
    """Places of triples and nodes in the text."""

    triples: Mapping[Triple, Span] = field(default_factory=dict)
    """Span of the value of each triple."""
    nodes: Mapping[Term, NodeSpans] = field(default_factory=dict)
    """Spans of the nodes that the text describes, in its order."""


@dataclass(frozen=True)
class Document:
    """Statements of one file, or of several texts that were put together.

    Of several texts, spans count through all of them.
    """

    source: SourceText
    """Text of the file; of several, the first."""
    graph: Term
    """IRI token under which a store keeps the statements."""
    statements: Sequence[Triple] = field(repr=False)
    """Asserted triples and those of the source layer, in the order of the text, each once.

    They may repeat what another file says.
    """
    map: SourceMap = field(repr=False)
    """Places of the statements and of what they describe."""
    prefixes: Mapping[str, str] = field(default_factory=dict, repr=False)
    """The file's own abbreviations, for messages."""
    format: Format = field(kw_only=True)
    """Format it is read as; a xacro file that expands to SDF or SRDF is read as that."""
    pieces: Sequence[tuple[int, SourceText]] = field(default=(), repr=False)
    """Offset at which each of several texts begins, *source* first."""

    def location(self, span: Span) -> Location:
        """Return the place of *span* in the text that it is a span of."""
        if not self.pieces:
            return Location(self.source, span)
        index = bisect_right(self.pieces, span.start, key=lambda piece: piece[0]) - 1
        start, source = self.pieces[index]
        return Location(source, Span(span.start - start, span.end - start))

    @property
    def sources(self) -> tuple[SourceText, ...]:
        """The texts that the document is made of."""
        return tuple(source for _, source in self.pieces) or (self.source,)

    @cached_property
    def about(self) -> Mapping[Term, Term]:
        """The domain node, or the graph, that each statement of the source layer speaks of."""
        named = {s: o for s, _, o in self.saying(NAME) if is_iri(o)}
        return {**named, **{s: o for s, _, o in self.saying(*ABOUT)}}

    def saying(self, *properties: Term) -> Sequence[Triple]:
        """Return the statements that have one of *properties*, in their order."""
        found = [each for name in properties if (each := self._by_property.get(name))]
        if len(found) < 2:  # noqa: PLR2004  nothing to be put in order
            return found[0] if found else ()
        return [each for each in self.statements if each[1] in properties]

    @cached_property
    def _by_property(self) -> Mapping[Term, Sequence[Triple]]:
        found: dict[Term, list[Triple]] = defaultdict(list)
        for each in self.statements:
            found[each[1]].append(each)
        return dict(found)


def homes(documents: Sequence[Document]) -> Mapping[str, Document]:
    """*documents* by the names of their texts; a text of its own counts before a part."""
    parts = {text.name: each for each in reversed(documents) for text in each.sources}
    return {**parts, **{each.source.name: each for each in documents}}
