"""Finds the text that wrote an element."""

from __future__ import annotations

from bisect import bisect_right
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property
from typing import NamedTuple

from kinlint.document import Document
from kinlint.edits import Edit, NotExpressible
from kinlint.formats.xml.editing.element_layout import ElementLayout
from kinlint.formats.xml.editing.stated_elements import StatedElement, elements
from kinlint.formats.xml.span_lookup import AT, TEXT
from kinlint.terms import Term
from kinlint.text import SourceText, Span

SEVERAL = "the text stands for several elements"


class Site(NamedTuple):
    """Place of an element in a text."""

    layout: ElementLayout
    """Layout of the text."""
    number: int
    """Number of the element in the text."""
    begin: int
    """Offset of the text in the document."""
    tag: str
    """Tag that it shall have."""

    @property
    def whole(self) -> Span:
        """The element in the document."""
        start, end = self.layout.whole(self.number)
        return Span(start + self.begin, end + self.begin)

    def document_edits(self, edits: Iterable[Edit]) -> Iterator[Edit]:
        """Yield *edits* of the text as edits of the document."""
        for (start, end), text in edits:
            yield Edit(Span(start + self.begin, end + self.begin), text)


class Sites:
    """The texts of one document and the elements in them."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self._pieces = tuple(document.pieces) or ((0, document.source),)
        self._layouts: dict[int, ElementLayout] = {}

    @cached_property
    def elements(self) -> Mapping[Term, StatedElement]:
        """Return the elements that the document states."""
        return elements(self._document.statements)

    def __getitem__(self, node: Term) -> Site:
        """Return the place of *node*; raises NotExpressible if it has none or several."""
        self.check_uses([node])
        return self.shared_site(node)

    def check_uses(self, nodes: Iterable[Term]) -> None:
        """Raise Unsayable if a text that wrote one of *nodes* wrote others too."""
        places = Counter(self._place(self._start(node)) for node in nodes)
        if any(self._shared[place] > count for place, count in places.items()):
            raise NotExpressible(SEVERAL)

    def use_count(self, site: Site) -> int:
        """Return the number of elements that the text at *site* stands for, at least."""
        return self._shared[id(site.layout.source), site.layout.start(site.number)]

    def shared_site(self, node: Term) -> Site:
        """Return the place of *node*, one of several; raises NotExpressible if it has none."""
        element, start = self.elements.get(node), self._start(node)
        if element is None:
            raise NotExpressible("the element is not written there")
        begin, source = self._piece(start)
        layout = self.layout(source)
        number = layout.number(start - begin)
        if number is None or layout.name(number) != element.tag:
            raise NotExpressible("the element is not written there literally")
        return Site(layout, number, begin, element.tag)

    def component(self, node: Term, slot: str, number: int) -> Span | None:
        """Return the span of a component of an attribute, or of the text, of *node*."""
        stem = f"{AT}{slot}" if slot else f"<{TEXT}"
        value = self.elements[node].slots[slot][number]
        span = self._document.map.triples.get((node, f"{stem}-{number}>", value))
        if span is None:
            return None
        begin, _ = self._piece(span.start)
        return Span(span.start - begin, span.end - begin)

    def _start(self, node: Term) -> int:
        spans = self._document.map.nodes.get(node)
        if spans is None:
            raise NotExpressible("the element is not written there")
        return spans.whole.start

    def _piece(self, at: int) -> tuple[int, SourceText]:
        return self._pieces[bisect_right(self._pieces, at, key=lambda piece: piece[0]) - 1]

    def _place(self, at: int) -> tuple[int, int]:
        begin, source = self._piece(at)
        return id(source), at - begin

    def layout(self, source: SourceText) -> ElementLayout:
        """Return the layout of one of the texts."""
        if id(source) not in self._layouts:
            self._layouts[id(source)] = ElementLayout(source)
        return self._layouts[id(source)]

    @cached_property
    def _shared(self) -> Counter[tuple[int, int]]:
        """Return the number of elements at each place; not counted where it is always one."""
        if not self._document.pieces:
            return Counter()
        nodes = self._document.map.nodes
        return Counter(self._place(nodes[each].whole.start) for each in self.elements)
