"""Elements and values around a place of a text."""

from __future__ import annotations

from collections import ChainMap
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import chain
from pathlib import Path
from typing import NamedTuple

from kinlint.document import Document, NodeSpans
from kinlint.formats.xml.span_lookup import ElementSpans
from kinlint.navigation.document_excerpt import Excerpt, whole
from kinlint.navigation.index import Index
from kinlint.terms import Term, is_blank, is_literal
from kinlint.text import Span
from kinlint.vocabulary import SRC

OWN = f"<{SRC}"


class Around(NamedTuple):
    """A node that `span` of a text is about."""

    span: Span
    """Place."""
    node: Term
    """Node that the place is about."""


class Surroundings:
    """The nodes that the texts of *documents* are about, place by place."""

    def __init__(self, documents: Sequence[Document], index: Index) -> None:
        self._documents, self._index, self._paths = documents, index, index.paths

    def at(self, name: str, offset: int) -> Sequence[Around]:
        """Return the innermost element at *offset* of the text called *name*, or a value's owner.

        It is several where a macro writes it several times.
        """
        there = [each for each in self._near(name, offset) if _holds(each.span, offset)]
        least = min((each.span.end - each.span.start for each in there), default=0)
        return [each for each in there if each.span.end - each.span.start == least]

    def _near(self, name: str, offset: int) -> Iterable[Around]:
        """Return what the text called *name* is about, at least at *offset*."""
        if (excerpt := self._index.excerpt_at(name, offset)) is not None:
            return map(Around._make, values(excerpt))
        if len(self._documents) == 1 and not self._documents[0].pieces:
            (only,) = self._documents
            maps = _maps(only.map.nodes)
            here = self._paths[only.source.name] == self._paths[name]
            if here and any(isinstance(each, ElementSpans) for each in maps):
                around = chain.from_iterable(_around(each, offset) for each in maps)
                return (Around(*each) for each in around if _is_about(only, each[1]))
        return self._by_text.get(self._paths[name], ())

    @cached_property
    def _by_text(self) -> Mapping[Path, Sequence[Around]]:
        found: dict[Path, list[Around]] = {}
        for document in self._documents:
            about = _elements(document) if document.format.is_tree else values(whole(document))
            for span, node in about:
                place = document.location(span)
                found.setdefault(self._paths[place.source.name], []).append(
                    Around(place.span, node)
                )
        return found


def _maps(nodes: Mapping[Term, NodeSpans]) -> Sequence[Mapping[Term, NodeSpans]]:
    """Return the mappings that *nodes* are made of, those of elements among them."""
    return nodes.maps if isinstance(nodes, ChainMap) else (nodes,)


def _around(nodes: Mapping[Term, NodeSpans], offset: int) -> Iterable[tuple[Span, Term]]:
    if isinstance(nodes, ElementSpans):
        return nodes.around(offset)
    return ((spans.whole, node) for node, spans in nodes.items() if _holds(spans.whole, offset))


def _elements(document: Document) -> Iterator[tuple[Span, Term]]:
    for node, spans in document.map.nodes.items():
        if _is_about(document, node):
            yield spans.whole, node


def _is_about(document: Document, node: Term) -> bool:
    """Tell whether a place of *document* may be about *node*."""
    return not is_blank(node) and node != document.graph


def values(excerpt: Excerpt) -> Iterator[tuple[Span, Term]]:
    """Yield the places of literals in *excerpt*, each with the node that has it."""
    cells = _Cells(excerpt)
    for (subject, predicate, value), span in excerpt.triples.items():
        own = predicate.startswith(OWN) or subject == excerpt.document.graph
        if is_literal(value) and not own:
            yield span, cells.owner(subject)


class _Cells:
    """The cells of lists, which stand for nothing but what has the list."""

    def __init__(self, excerpt: Excerpt) -> None:
        nodes = excerpt.document.map.nodes
        self._before: dict[Term, Term] = {}
        for subject, _, value in excerpt.triples:
            if is_blank(value) and value not in nodes:
                self._before.setdefault(value, subject)

    def owner(self, node: Term) -> Term:
        """Return the node with the list that *node* is a cell of, or *node* itself."""
        passed: dict[Term, None] = {}
        while node in self._before and node not in passed:
            passed[node] = None
            node = self._before[node]
        self._before.update(dict.fromkeys(passed, node))
        return node


def _holds(span: Span, offset: int) -> bool:
    return span.start <= offset <= span.end
