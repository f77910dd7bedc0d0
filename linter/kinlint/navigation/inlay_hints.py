"""Values beside what is written: degrees beside radians, and what expressions of xacro come to."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from math import degrees
from pathlib import Path
from typing import NamedTuple

from kinlint.addresses import enclosing, last_tag, unordered
from kinlint.document import Document
from kinlint.facts.predicate_index import numeric
from kinlint.formats.xml.element_types import Angles
from kinlint.formats.xml.schema import schema
from kinlint.navigation.statement_index import StatementIndex
from kinlint.navigation.text_names import Paths
from kinlint.terms import Term, iri, is_blank, is_literal, literal_value
from kinlint.text import Span
from kinlint.vocabulary import ATTRIBUTE, SRC

AT, TEXT = f"<{ATTRIBUTE}", f"<{SRC}text"
_COMPONENT = re.compile(r"(.*?)(?:-([1-9]\d*))?>\Z", re.DOTALL)
_EXPRESSION = re.compile(r"\$[{(]")
MOST_VALUES = 3


class InlayHint(NamedTuple):
    """Text to show behind a place."""

    offset: int
    """The place."""
    text: str
    """The text."""


class _Value(NamedTuple):
    """A number or word of an attribute, or of the text of an element."""

    element: Term
    """The element."""
    name: str
    """Name of the attribute; empty for the text of the element."""
    component: int
    """Index among the words of the attribute."""
    value: Term
    """The literal that it is lifted to."""
    span: Span
    """Its place."""


class InlayHints:
    """Hints in the texts of *documents*, called by *paths*."""

    def __init__(self, documents: Sequence[Document], paths: Paths) -> None:
        self._paths = paths
        self._indexes = [StatementIndex(each) for each in documents if each.format.is_tree]

    def hints(self, name: str, span: Span) -> Sequence[InlayHint]:
        """Return the hints in *span* of the text called *name*, in its order."""
        found: dict[int, dict[str, None]] = {}
        for index in self._indexes:
            values = list(self._values(index, self._paths[name], span))
            for hint in (*_expressions(index, values), *_angles(index, values)):
                found.setdefault(hint.offset, {})[hint.text] = None
        return [
            InlayHint(offset, " | ".join(list(texts)[:MOST_VALUES]))
            for offset, texts in sorted(found.items())
        ]

    def expressions(self, name: str, offset: int) -> Sequence[InlayHint]:
        """Return what the expression at *offset* of the text called *name* comes to."""
        path = self._paths[name]
        found: dict[str, InlayHint] = {}
        for index in self._indexes:
            if index.document.format.includes and self._may_compute(index.document, path, offset):
                there = self._values(index, path, Span(offset, offset))
                for hint in _expressions(index, list(there)):
                    found.setdefault(hint.text, hint)
        return list(found.values())[:MOST_VALUES]

    def _may_compute(self, document: Document, path: Path, offset: int) -> bool:
        """Tell whether the markup around *offset* of the file at *path* has an expression."""
        for each in document.sources:
            if self._paths[each.name] == path:
                start = each.text.rfind("<", 0, offset) + 1
                end = each.text.find("<", max(start, offset))
                if _EXPRESSION.search(each.text, start, end if end >= 0 else len(each.text)):
                    return True
        return False

    def _values(self, index: StatementIndex, path: Path, span: Span) -> Iterator[_Value]:
        """Yield the values of the elements that *span* of the file at *path* has a part of."""
        document = index.document
        for node, spans in document.map.nodes.items():
            if is_blank(node):
                continue
            place = document.location(spans.whole)
            if place.span.end < span.start or span.end < place.span.start:
                continue
            if self._paths[place.source.name] != path:
                continue
            for predicate, value in index.by_subject.get(node, ()):
                if not is_literal(value) or not predicate.startswith((AT, TEXT)):
                    continue
                written = index.place(node, predicate, value)
                if written is None or self._paths[written.source.name] != path:
                    continue
                if span.start <= written.span.end and written.span.start <= span.end:
                    match = _COMPONENT.match(predicate)
                    own = match[1] if match else predicate
                    name = own[len(AT) :] if own.startswith(AT) else ""
                    number = int(match[2] or 0) if match else 0
                    yield _Value(node, name, number, value, written.span)


def _expressions(index: StatementIndex, values: Sequence[_Value]) -> Iterator[InlayHint]:
    """Yield the values of expressions where they stand."""
    if not index.document.format.includes:
        return
    for each in values:
        place = index.place(each.element, _predicate(each), each.value)
        written = "" if place is None else place.source[place.span]
        if _EXPRESSION.search(written):
            number = numeric(each.value)
            shown = literal_value(each.value) if number is None else f"{number:.6g}"
            yield InlayHint(each.span.end, f"= {shown}")


def _predicate(value: _Value) -> Term:
    end = f"-{value.component}" if value.component else ""
    return f"{AT}{value.name}{end}>" if value.name else f"{TEXT}{end}>"


def _angles(index: StatementIndex, values: Sequence[_Value]) -> Iterator[InlayHint]:
    """Yield the degrees of values that are in radians, behind the last number of an attribute."""
    table = schema(index.document.format.lifted_as)
    together: dict[tuple[Term, str], list[_Value]] = {}
    for each in values:
        together.setdefault((each.element, each.name), []).append(each)
    for (element, name), own in together.items():
        tags = last_tag(element), unordered(element[:-1].rpartition("/")[2])
        types = [each for tag in tags for each in table.types.get(tag, ())]
        meant = (each for type_ in types for each in type_.angles.get(name, ()))
        angles = next((each for each in meant if _holds(index, element, each)), None)
        if angles is None:
            continue
        ordered = sorted(own, key=lambda each: each.component)
        numbers = [numeric(each.value) for each in ordered][angles.first :]
        if len(numbers) not in (1, 3) or None in numbers or not any(numbers):
            continue
        shown = " ".join(f"{degrees(each or 0):.4g}°" for each in numbers)
        yield InlayHint(ordered[-1].span.end, shown)


def _holds(index: StatementIndex, element: Term, angles: Angles) -> bool:
    """Tell whether the attribute on which *angles* depend has one of their words."""
    if not angles.attribute:
        return True
    predicate = iri(ATTRIBUTE + angles.attribute)
    for each in enclosing(element):
        if (found := next(index.values(each, predicate), None)) is not None:
            return literal_value(found) in angles.words
    return "" in angles.words
