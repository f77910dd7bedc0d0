"""Elements and values around a place of a text."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

from kinlint.document import Document
from kinlint.navigation.text_names import Paths
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

    def __init__(self, documents: Sequence[Document], paths: Paths) -> None:
        self._documents, self._paths = documents, paths

    def at(self, name: str, offset: int) -> Sequence[Around]:
        """Return the innermost element at *offset* of the text called *name*, or a value's owner.

        It is several where a macro writes it several times.
        """
        there = [
            each for each in self._by_text.get(self._paths[name], ()) if _holds(each.span, offset)
        ]
        least = min((each.span.end - each.span.start for each in there), default=0)
        return [each for each in there if each.span.end - each.span.start == least]

    @cached_property
    def _by_text(self) -> Mapping[Path, Sequence[Around]]:
        found: dict[Path, list[Around]] = {}
        for document in self._documents:
            for span, node in _elements(document) if document.format.is_tree else _values(document):
                place = document.location(span)
                found.setdefault(self._paths[place.source.name], []).append(
                    Around(place.span, node)
                )
        return found


def _elements(document: Document) -> Iterator[tuple[Span, Term]]:
    for node, spans in document.map.nodes.items():
        if not is_blank(node) and node != document.graph:
            yield spans.whole, node


def _values(document: Document) -> Iterator[tuple[Span, Term]]:
    cells = _Cells(document)
    for (subject, predicate, value), span in document.map.triples.items():
        if is_literal(value) and not predicate.startswith(OWN) and subject != document.graph:
            yield span, cells.owner(subject)


class _Cells:
    """The cells of lists, which stand for nothing but what has the list."""

    def __init__(self, document: Document) -> None:
        nodes = document.map.nodes
        self._before: dict[Term, Term] = {}
        for subject, _, value in document.statements:
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
