"""States an element of plain JSON, whose places are not known."""

from __future__ import annotations

from typing import Any

from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.jsonld.compiled.term_table import Meaning, TermTable
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
        """What it states, in the order of the text."""
        self.nodes: list[Term] = []
        """What it describes."""

    def _types(self, subject: Term, table: TermTable, key: str, value: Any) -> None:
        types = table.types
        if type(value) is str:
            self.triples.append((subject, RDF_TYPE, types[value]))
        else:
            self._distinct([(subject, RDF_TYPE, types[name]) for name in value])

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
        elif all(type(each) is str for each in value):
            words = meaning.words
            self._distinct([(subject, predicate, words[each]) for each in value])
        else:
            seen = set()
            for each in value:
                term = self._value(meaning, key, each)
                self.triples.append((subject, predicate, term))
                seen.add(term)
            if len(seen) < len(value):
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

    def _describe(self, subject: Term, element: dict[str, Any], naming: str | None) -> None:
        self.nodes.append(subject)

    def _nested(
        self, node: Term, meaning: Meaning, key: str, element: dict[str, Any], naming: str | None
    ) -> None:
        if len(self.around) > 1:
            raise PlacesNeeded
