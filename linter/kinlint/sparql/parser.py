"""Reads tokens into the tree of `kinlint.sparql.ast`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeVar

from kinlint.sparql.ast import (
    Bind,
    Clause,
    Construct,
    Element,
    Expression,
    Filter,
    Group,
    Select,
    Triples,
    Union,
    Update,
    Values,
)
from kinlint.sparql.tokens import NotSparql, split, written_out

_CLAUSES = {"OPTIONAL", "MINUS", "GRAPH", "SERVICE", "LATERAL"}
_STARTS = {*_CLAUSES, "FILTER", "BIND", "VALUES", "{", "}"}


def parse(tokens: tuple[str, ...]) -> Select:
    """Return the SELECT or ASK query that *tokens* spell, its prologue removed."""
    reader = _Reader(tokens)
    return reader.whole(reader.select())


def parse_construct(text: str, prefixes: Mapping[str, str] | None = None) -> Construct:
    """Return the CONSTRUCT query *text*, in full IRIs.

    Prefixes that its prologue declares come before *prefixes*. Raises `NotSparql`.
    """
    reader = _Reader(written_out(split(text), prefixes or {}))
    return reader.whole(reader.construct())


def parse_update(text: str, prefixes: Mapping[str, str] | None = None) -> Update:
    """Return the one `DELETE … INSERT … WHERE …` that *text* is, in full IRIs.

    Either of DELETE and INSERT may be missing. Prefixes that its prologue declares come before
    *prefixes*. Raises `NotSparql`, also for the other forms of updates.
    """
    reader = _Reader(written_out(split(text), prefixes or {}))
    return reader.whole(reader.update())


T = TypeVar("T")


class _Reader:
    def __init__(self, tokens: tuple[str, ...]) -> None:
        self.tokens = tokens
        self.at = 0

    def whole(self, part: T) -> T:
        """Return *part*, if nothing but a semicolon is left after it."""
        while self.at < len(self.tokens) and self.next == ";":
            self.take()
        if self.at < len(self.tokens):
            raise NotSparql(f"'{self.next}' stands after the end of the query", self.at)
        return part

    def construct(self) -> Construct:
        self.take("CONSTRUCT")
        template = self.template()
        if self.next.upper() == "WHERE":
            self.take()
        return Construct(template, self.group(), self.tail())

    def update(self) -> Update:
        changes = dict.fromkeys(("DELETE", "INSERT"), Triples(()))
        verb = self.take("DELETE", "INSERT").upper()
        changes[verb] = self.template()
        if verb == "DELETE" and self.next.upper() == "INSERT":
            self.take()
            changes["INSERT"] = self.template()
        self.take("WHERE")
        return Update(changes["DELETE"], changes["INSERT"], self.group())

    def template(self) -> Triples:
        """Return the triples between braces, in which no group may stand."""
        self.take("{")
        start = self.at
        while self.next != "}":
            if self.take().upper() in _STARTS:
                self.at -= 1
                raise NotSparql(f"'{self.next}' stands in a template", self.at)
        found = Triples(self.tokens[start : self.at])
        self.take("}")
        return found

    @property
    def next(self) -> str:
        if self.at >= len(self.tokens):
            raise NotSparql("the query ends too early", self.at)
        return self.tokens[self.at]

    def take(self, *wanted: str) -> str:
        token = self.next
        if wanted and token.upper() not in wanted:
            raise NotSparql(f"'{token}' stands where {' or '.join(wanted)} is due", self.at)
        self.at += 1
        return token

    def select(self) -> Select:
        head: list[str | Group] = [self.take("SELECT", "ASK")]
        while self.next.upper() not in ("WHERE", "{"):
            head.append(self.piece())
        if self.next.upper() == "WHERE":
            self.take()
        return Select(tuple(head), self.group(), self.tail())

    def tail(self) -> Expression:
        """Return the solution modifiers, and the VALUES clause, after a group."""
        tail: list[str | Group] = []
        while self.at < len(self.tokens) and self.next != "}":
            tail.append(self.piece() if self.next != "{" else self.block())
        return tuple(tail)

    def block(self) -> str:
        """Return the braces of a VALUES clause, which hold no structure."""
        start = self.at
        while self.take() != "}":
            pass
        return " ".join(self.tokens[start : self.at])

    def piece(self) -> str | Group:
        """Read one token of an expression, or the group after EXISTS."""
        if self.next == "{":
            return self.group()
        return self.take()

    def group(self) -> Group:
        self.take("{")
        elements: list[Element] = []
        if self.next.upper() == "SELECT":
            elements.append(self.select())
        while self.next != "}":
            if self.next == ".":
                # A dot after anything but triples separates nothing that order does not.
                self.take()
            else:
                elements.append(self.element())
        self.take("}")
        return Group(tuple(elements))

    def element(self) -> Element:
        word = self.next.upper()
        if word == "{":
            return self.union()
        if word == "FILTER":
            self.take()
            return Filter(self.constraint())
        if word == "BIND":
            self.take()
            *expression, _, variable = self.parenthesised()[1:-1]
            return Bind(tuple(expression), str(variable))
        if word == "VALUES":
            start = self.at
            while self.next != "{":
                self.take()
            self.block()
            return Values(self.tokens[start : self.at])
        if word in _CLAUSES:
            head = [self.take()]
            while self.next != "{":
                head.append(self.take())
            return Clause(tuple(head), self.group())
        return self.triples()

    def union(self) -> Union:
        branches = [self.group()]
        while self.next.upper() == "UNION":
            self.take()
            branches.append(self.group())
        return Union(tuple(branches))

    def constraint(self) -> Expression:
        """Return `(…)`, `NAME(…)`, `<iri>(…)`, `EXISTS {…}` or `NOT EXISTS {…}`."""
        head: list[str | Group] = []
        while self.next not in ("(", "{"):
            head.append(self.take())
        return (*head, self.group()) if self.next == "{" else (*head, *self.parenthesised())

    def parenthesised(self) -> list[str | Group]:
        found: list[str | Group] = [self.take("(")]
        depth = 1
        while depth:
            if self.next == "}":
                self.take(")")
            found.append(self.piece())
            depth += (found[-1] == "(") - (found[-1] == ")")
        return found

    def triples(self) -> Triples:
        start = self.at
        depth = 0
        while depth or self.next.upper() not in _STARTS:
            depth += (self.next in ("(", "[")) - (self.next in (")", "]"))
            self.take()
        return Triples(self.tokens[start : self.at])
