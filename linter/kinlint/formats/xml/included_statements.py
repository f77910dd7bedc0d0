"""Puts the statements of an included file where the include stands, as if they were written there.

The nodes of the file move below that of the include, so that a file that is included twice is two
models, and its spans move behind the text of the file that includes it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any, Generic, TypeVar

from kinlint.document import Document, NodeSpans, SourceMap
from kinlint.light_dataclasses import dataclass
from kinlint.terms import XSD, Term, Triple, is_blank, is_iri, literal, literal_value
from kinlint.text import SourceText, Span
from kinlint.vocabulary import SRC

K = TypeVar("K")
V = TypeVar("V")

_OFFSET = f"<{SRC}offset>"


@dataclass(frozen=True)
class IncludedDocument:
    """Document that another includes."""

    document: Document
    """The document."""
    include: Term
    """Node of the `include`."""
    onto: Term
    """Node of the including document."""
    start: int
    """Offset of its text in the whole."""
    root: Term
    """Property that leads from the include to the root element of the document."""

    def outer_name(self, term: Term) -> Term:
        """Return the name in the whole document of *term* of the included file."""
        if term.startswith(self._own):
            return f"{self._moved}{term[len(self._own) :]}"
        if is_blank(term):
            return f"{term}n{self.start}"
        return self.onto if term == self.document.graph else term

    def inner_name(self, term: Term) -> Term | None:
        """Return the name in the included file of *term* of the whole; None if it is not in it."""
        if term == self.onto:
            return self.document.graph
        if term.startswith(self._moved) and term[len(self._moved)] in "/;>":
            return f"{self._own}{term[len(self._moved) :]}"
        if is_blank(term):
            tail = f"n{self.start}"
            return term.removesuffix(tail) if term.endswith(tail) else None
        return term if not is_iri(term) or not term.startswith(self.onto[:-1]) else None

    @property
    def _own(self) -> str:
        return f"{self.document.graph[:-1]}#"

    @property
    def _moved(self) -> str:
        return f"{self.include[:-1]}/{self.root[:-1].rpartition('#')[2]}"

    @property
    def _top(self) -> Term:
        return f"{self._own}>"

    def statements(self) -> Iterator[Triple]:
        """Yield the statements of the included file, without those about the file itself."""
        for subject, predicate, value in self.document.statements:
            if subject == self.document.graph:
                if value == self._top:
                    yield self.include, self.root, self.outer_name(value)
            elif predicate == _OFFSET:
                moved = literal(str(int(literal_value(value)) + self.start), f"{XSD}integer")
                yield self.outer_name(subject), predicate, moved
            else:
                yield self.outer_name(subject), predicate, self.outer_name(value)

    def inner_triple(self, triple: Triple) -> Triple | None:
        """Return *triple* with the names of the included file."""
        subject, predicate, value = triple
        if predicate == self.root and subject == self.include:
            return (self.document.graph, self._read_as, self._top)
        own = self.inner_name(subject)
        if own is None or subject == value:
            return None
        if predicate == _OFFSET:
            offset = int(literal_value(value)) - self.start
            return own, predicate, literal(str(offset), f"{XSD}integer")
        inside = self.inner_name(value)
        return None if inside is None else (own, predicate, inside)

    @cached_property
    def _read_as(self) -> Term:
        """The property that leads from the document to its root element."""
        found = (p for s, p, o in self.document.statements if o == self._top)
        return next(found, self.root)

    def outer_span(self, span: Span) -> Span:
        """Return *span* of the included file as a span of the whole."""
        return Span(span.start + self.start, span.end + self.start)


class _Joined(Mapping[K, V], Generic[K, V]):
    """Mapping of a document together with those of the documents that are grafted onto it."""

    def __init__(self, base: Mapping[K, V], grafts: Sequence[IncludedDocument]) -> None:
        self.base, self.grafts = base, grafts

    def __getitem__(self, key: K) -> V:
        if key in self.base:
            return self.base[key]
        for graft in reversed(self.grafts):
            found = self._in(graft, key)
            if found is not None:
                return found
        raise KeyError(key)

    def __len__(self) -> int:
        return sum(1 for _ in self)

    def _in(self, graft: IncludedDocument, key: K) -> V | None:
        raise NotImplementedError

    def __contains__(self, key: Any) -> bool:
        return self.get(key) is not None


class _Triples(_Joined[Triple, Span]):
    def _in(self, graft: IncludedDocument, key: Triple) -> Span | None:
        own = graft.inner_triple(key)
        span = graft.document.map.triples.get(own) if own else None
        return graft.outer_span(span) if span else None

    def __iter__(self) -> Iterator[Triple]:
        yield from self.base
        for graft in self.grafts:
            yield from graft.statements()


class _Nodes(_Joined[Term, NodeSpans]):
    def _in(self, graft: IncludedDocument, key: Term) -> NodeSpans | None:
        own = graft.inner_name(key)
        spans = graft.document.map.nodes.get(own) if own else None
        if spans is None:
            return None
        name = graft.outer_span(spans.identifier) if spans.identifier else None
        return NodeSpans(graft.outer_span(spans.whole), name)

    def __iter__(self) -> Iterator[Term]:
        yield from self.base
        for graft in self.grafts:
            own = graft.document.graph
            yield from (graft.outer_name(each) for each in graft.document.map.nodes if each != own)


def text_length(document: Document) -> int:
    """Return the upper limit of the spans of *document*."""
    if not document.pieces:
        return len(document.source.text)
    start, last = document.pieces[-1]
    return start + len(last.text)


def with_includes(
    document: Document, included: Iterable[tuple[Term, Document]], root: Term
) -> Document:
    """Return *document* with each of the documents *included* at the node of its include.

    The property *root* leads from that to the root element of the document.
    """
    grafts: list[IncludedDocument] = []
    pieces: list[tuple[int, SourceText]] = list(document.pieces or [(0, document.source)])
    end = text_length(document) + 1
    for include, each in included:
        grafts.append(IncludedDocument(each, include, document.graph, end, root))
        own = each.pieces or [(0, each.source)]
        pieces += [(end + start, text) for start, text in own]
        end += text_length(each) + 1
    if not grafts:
        return document
    statements = [*document.statements]
    for graft in grafts:
        statements += graft.statements()
    places = SourceMap(_Triples(document.map.triples, grafts), _Nodes(document.map.nodes, grafts))
    return Document(
        document.source, document.graph, statements, places, document.prefixes, pieces,
        format=document.format,
    )  # fmt: skip
