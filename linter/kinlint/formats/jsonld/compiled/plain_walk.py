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
        self._distinct([(subject, RDF_TYPE, each) for each in classes])

    def _distinct(self, stated: list[Triple]) -> None:
        if len(stated) > 1 and len(set(stated)) < len(stated):
            raise PlacesNeeded
        self.triples += stated

    def _property(self, subject: Term, meaning: Meaning, key: str, value: Any) -> None:
        predicate = meaning.predicate
        if meaning.listed:
            head = self._listed(meaning, key, value)
            self.triples.append((subject, predicate, head))
        elif type(value) is str:
            self.triples.append((subject, predicate, meaning.words[value]))
        elif type(value) is not list:
            self.triples.append((subject, predicate, self._value(meaning, key, value)))
        elif value and type(value[0]) is str:
            words = meaning.words
            try:
                found = [(subject, predicate, words[each]) for each in value]
            except (NoWord, TypeError):
                self._values(subject, meaning, key, value)
            else:
                self._distinct(found)
        else:
            self._values(subject, meaning, key, value)

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
