"""Excerpts of single elements of the outermost graph of a large JSON-LD file.

To look at one of them takes a hundredth of the time that all of them take.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from collections.abc import Set as AbstractSet
from functools import cached_property

from kinlint.document import Document
from kinlint.formats.json_text.json_outline import WITHIN
from kinlint.formats.json_text.json_parser import element
from kinlint.formats.jsonld.incremental.document_assembly import (
    ShiftedNodeSpans,
    ShiftedTripleSpans,
)
from kinlint.formats.jsonld.incremental.part import shifted
from kinlint.navigation.document_excerpt import Excerpt
from kinlint.navigation.statement_index import StatementIndex
from kinlint.terms import Term

CONTEXT = '"@context"'
KEY = re.compile(r'("(?:[^"\\]|\\.)*+")\s*+:')


class ElementExcerpts:
    """Elements of *document*, whose *nodes* and *triples* are in parts: elements, then the hull."""

    def __init__(
        self, document: Document, nodes: ShiftedNodeSpans, triples: ShiftedTripleSpans
    ) -> None:
        self.document = document
        self._nodes, self._triples = nodes, triples
        self._made: dict[int, Excerpt] = {}

    @classmethod
    def from_document(cls, document: Document) -> ElementExcerpts | None:
        """Return the elements of *document*; None if it is not read in parts.

        Nor may an element have a context of its own, or the outermost context a term that is a key.
        """
        nodes, triples = document.map.nodes, document.map.triples
        if not isinstance(nodes, ShiftedNodeSpans) or not isinstance(triples, ShiftedTripleSpans):
            return None
        found = cls(document, nodes, triples)
        return found if not document.pieces and found._plain else None

    @property
    def _plain(self) -> bool:
        """Tell whether no key of an element means what a context in the text says."""
        text, arranged = self.document.source.text, self._nodes.arranged
        if len(arranged.parts) == 1 or text.count(CONTEXT) != 1 or "\\u0040" in text:
            return False
        start = arranged.parts[0].whole.start + arranged.shifts[0]
        hull = text[:start], text[arranged.end_of(len(arranged.parts) - 2) :]
        keys = {key for each in hull for key in KEY.findall(each)}
        return CONTEXT in hull[0] and all(key[1] == "@" or text.count(key) == 1 for key in keys)

    def at(self, offset: int) -> Excerpt | None:
        """Return the element at *offset*; None if there is none."""
        number = self._number(offset)
        return None if number is None else self._excerpt(number)

    def describing(self, node: Term) -> Iterator[Excerpt]:
        """Yield the elements that may describe *node*, in the order of the text."""
        first = self._nodes.part_of(node)
        if first < 0:
            return
        numbers, source = {first}, self.document.source
        if (name := self._nodes[node].identifier) is not None:
            written = re.compile(rf'"@id"\s*+:\s*+{re.escape(source[name])}')
            numbers |= {
                number
                for match in written.finditer(source.text)
                if (number := self._number(match.start())) is not None
            }
        for number in sorted(numbers):
            if number < len(self._nodes.arranged.parts) - 1:
                yield self._excerpt(number)

    def _number(self, offset: int) -> int | None:
        """Return the number of the element at *offset*."""
        arranged = self._nodes.arranged
        number = arranged.first_to(offset)
        if number >= len(arranged.parts) - 1:
            return None
        start = arranged.parts[number].whole.start + arranged.shifts[number]
        return number if start <= offset else None

    def _excerpt(self, number: int) -> Excerpt:
        if number not in self._made:
            arranged, document = self._nodes.arranged, self.document
            part, by = arranged.parts[number], arranged.shifts[number]
            nodes = {n: self._nodes[n] for n in part.nodes if self._nodes.part_of(n) == number}
            triples = {
                each: shifted(part.spans[each], by)
                for each in part.spans
                if self._triples.part_of(each) == number
            }
            names = {
                shifted(place.identifier, by): node
                for node, place in part.nodes.items()
                if place.identifier is not None
            }
            start = part.whole.start + by
            self._made[number] = Excerpt(
                document,
                nodes,
                triples,
                self._losses,
                lambda: element(document.source, start, first=True, depth=WITHIN).value,
                names,
            )
        return self._made[number]

    @cached_property
    def _losses(self) -> AbstractSet[Term]:
        return StatementIndex(self.document).losses
