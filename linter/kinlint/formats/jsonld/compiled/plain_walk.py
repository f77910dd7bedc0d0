"""States an element of plain JSON, whose places are not known."""

from __future__ import annotations

from typing import Any

from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.jsonld.compiled.term_table import Meaning, NoWord, Shape, TermTable
from kinlint.formats.jsonld.compiled.walk import Walk
from kinlint.formats.jsonld.triples import FIRST, NIL, REST
from kinlint.terms import RDF_TYPE, Term, Triple


class PlacesNeeded(Exception):
    """Something is told of the element, at its place."""


class PlainWalk(Walk):
    """Statements of one element, and the nodes that it describes."""

    def __init__(self, blanks: BlankNodes) -> None:
        super().__init__(blanks)
        self.triples: list[Triple] = []
        """Statements in the order of the text."""
        self.nodes: list[Term] = []
        """Nodes that it describes."""

    def _shape(self, element: dict[str, Any], table: TermTable) -> Shape:
        keys = tuple(element)
        known = table.shapes.get(keys)
        if known is None:
            known = table.shapes[keys] = table.shape(keys)
        return known

    def _types(self, subject: Term, classes: list[Term], key: str, value: Any) -> None:  # noqa: ARG002
        self._state(subject, RDF_TYPE, classes)

    def _state(self, subject: Term, predicate: Term, values: list[Term]) -> None:
        if len(values) > 1 and len(set(values)) < len(values):
            raise PlacesNeeded
        self.triples += [(subject, predicate, value) for value in values]

    def _property(self, subject: Term, meaning: Meaning, key: str, value: Any) -> None:
        kind = type(value)
        if meaning.listed:
            term = self._listed(meaning, key, value)
        elif kind is str:
            term = meaning.words[value]
        elif kind is float:
            term = meaning.numbers[repr(value)]
        elif kind is not list:
            term = self._value(meaning, key, value)
        elif value and type(value[0]) is str:
            words = meaning.words
            try:
                terms = [words[each] for each in value]
            except (NoWord, TypeError):
                self._values(subject, meaning, key, value)
            else:
                self._state(subject, meaning.predicate, terms)
            return
        else:
            self._values(subject, meaning, key, value)
            return
        self.triples.append((subject, meaning.predicate, term))

    def _values(self, subject: Term, meaning: Meaning, key: str, values: list[Any]) -> None:
        seen = set()
        for each in values:
            term = self._value(meaning, key, each)
            self.triples.append((subject, meaning.predicate, term))
            seen.add(term)
        if len(seen) < len(values):
            raise PlacesNeeded

    def _list(self, meaning: Meaning, key: str, value: Any) -> Term:
        elements = value if type(value) is list else [value]
        if not elements:
            return NIL
        cells = [*(self.blanks.fresh() for _ in elements), NIL]
        for number, each in enumerate(elements):
            term = self._value(meaning, key, each)
            cell = cells[number]
            self.triples.append((cell, FIRST, term))
            self.triples.append((cell, REST, cells[number + 1]))
        return cells[0]

    def _describe(self, subject: Term, *_: Any) -> None:
        self.nodes.append(subject)

    def _nested(self, *_: Any) -> None:
        if len(self.around) > 1:
            raise PlacesNeeded
