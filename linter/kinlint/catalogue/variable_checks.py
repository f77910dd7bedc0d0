"""Checks of the variables in the queries of rules: each gets a value, and is used."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping

from kinlint.catalogue.term_checks import Fault, WrittenQuery, queries
from kinlint.engine.compiler.shacl_terms import sh
from kinlint.engine.compiler.shapes_graph import ShapesFile
from kinlint.engine.compiler.sparql_constraints import BECAUSE
from kinlint.rule import PLACEHOLDER
from kinlint.sparql.ast import Clause, Filter, Select, Triples, Values, walk
from kinlint.sparql.parser import parse
from kinlint.sparql.tokens import NotSparql, split, tokens
from kinlint.sparql.variables import assigned, projection, variables, words
from kinlint.suggestion import did_you_mean, distance
from kinlint.terms import literal_value

PREBOUND = frozenset({"?this", "?PATH", "?currentShape", "?shapesGraph"})
"""Variables that a query of a shape is given: SHACL 5.3.1."""
GIVEN = PREBOUND | {"?value", "?path", "?root", "?count"}
"""Variables that every message may name; `?count` is that of a group (`kl:groupBy`)."""
NONE = frozenset({"?none", "?nothing"})
"""Variables that stand for no value, as in `IF(?condition, ?value, ?none)`."""
SHORTEST = 3
"""The number of letters from which a name may be a slip for another."""


class Variables:
    """The variables of a query."""

    def __init__(self, query: WrittenQuery, select: Select) -> None:
        """Read *query*, which is *select*."""
        self.query = query
        self.select = select
        self.places: dict[str, int] = {}
        for each in split(query.text):
            if each.kind == "variable":
                self.places.setdefault(f"?{each.text[1:]}", each.start)
        self.bound = assigned(select) | {
            name
            for part in walk(select)
            if isinstance(part, (Triples, Values, Clause))
            for name in (variables(part) if not isinstance(part, Clause) else part.head)
        }
        self.counts = Counter(word for word in words(select) if word in self.places)

    @property
    def shown(self) -> list[str]:
        """Return the variables of its solutions."""
        return projection(self.select)

    def unbound(self) -> Iterator[Fault]:
        """Yield the variables that are read and get no value."""
        for name, place in self.places.items():
            if name not in self.bound | PREBOUND | NONE:
                hint = _hint(name, self.bound | {"?this"})
                yield Fault(place, f"nothing gives {name} a value{hint}")

    def misspelt(self) -> Iterator[Fault]:
        """Yield the variables that occur once, and are a letter away from another."""
        nested = self._nested()
        for name in self.single():
            for other in sorted(self.places.keys() - {name}):
                same = len(name) == len(other) and sorted(name) != sorted(other)
                if min(len(name), len(other)) <= SHORTEST or (name in nested and same):
                    continue
                digits = [[c for c in each if c.isdigit()] for each in (name, other)]
                if digits[0] == digits[1] and distance(name, other, 1) == 1:
                    text = f"{name} occurs only here, did you mean '{other}'?"
                    yield Fault(self.places[name], text)

    def unused(self) -> Iterator[Fault]:
        """Yield the variables outside of EXISTS and MINUS that occur once and are not shown."""
        nested = self._nested()
        for name in self.single():
            if name not in nested:
                text = f"{name} is never used: write [] if any value will do"
                yield Fault(self.places[name], text)

    def single(self) -> list[str]:
        """Return the variables that occur once and are not shown."""
        shown = {*self.shown, *PREBOUND, *NONE}
        return [name for name, count in self.counts.items() if count == 1 and name not in shown]

    def _nested(self) -> set[str]:
        found = set[str]()
        for part in walk(self.select):
            if isinstance(part, Filter):
                found.update(words(part))
            elif isinstance(part, Clause) and part.head[0].upper() == "MINUS":
                found.update(words(part.group))
        return found


def variable_faults(file: ShapesFile, prefixes: Mapping[str, str]) -> Iterator[Fault]:
    """Yield variables of *file* that nothing gives a value, or that are misspelt.

    That is: of its SELECT queries, and of the messages of constraints with such a query.
    """
    for each in selects(file, prefixes):
        for fault in (*each.unbound(), *each.misspelt()):
            yield _placed(file, each, fault)
        yield from _message_faults(file, each)


def unused_variables(file: ShapesFile, prefixes: Mapping[str, str]) -> Iterator[Fault]:
    """Yield variables of *file* that get a value and are not used."""
    for each in selects(file, prefixes):
        misspelt = {fault.offset for fault in each.misspelt()}
        for fault in each.unused():
            if fault.offset not in misspelt:
                yield _placed(file, each, fault)


def selects(file: ShapesFile, prefixes: Mapping[str, str]) -> Iterator[Variables]:
    """Yield the variables of each SELECT of `sh:sparql` in *file* that can be read."""
    constraints = {value for _, way, value in file.triples if way == sh("sparql")}
    for query in queries(file):
        if query.kind == sh("select") and query.node in constraints:
            try:
                yield Variables(query, parse(tokens(query.text, prefixes)))
            except NotSparql:
                continue


def _message_faults(file: ShapesFile, query: Variables) -> Iterator[Fault]:
    """Yield variables of messages that no solution of *query* has."""
    known = {*query.shown, *GIVEN}
    for node, way, value in file.triples:
        if node == query.query.node and way in (sh("message"), BECAUSE):
            for match in PLACEHOLDER.finditer(literal_value(value)):
                name = f"?{match[1]}"
                if name not in known:
                    text = f"the query does not select {match[0]} of the message"
                    yield Fault(
                        _nearest(file.text, match[0], query.query.start), text + _hint(name, known)
                    )


def _nearest(text: str, word: str, place: int) -> int:
    """Return the offset in *text* of the *word* that is nearest to *place*."""
    found = [each.start() for each in re.finditer(re.escape(word), text)]
    return min(found, key=lambda each: abs(each - place), default=place)


def _placed(file: ShapesFile, variables: Variables, fault: Fault) -> Fault:
    return Fault(variables.query.place(file.text, fault.offset), fault.text)


def _hint(name: str, choices: set[str]) -> str:
    """Return a suggestion for the variable *name*."""
    found = did_you_mean(name[1:], [each[1:] for each in choices])
    return found.replace("'", "'?", 1) if found else ""
