"""Turtle statements with the place of their terms.

Whether a text is Turtle at all is not decided here: the reader asks a validating parser first.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import NamedTuple

from kinlint.document import NodeSpans
from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.turtle.turtle_tokens import Token, Unread, tokens
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import RDF, RDF_TYPE, XSD, Term, iri, literal
from kinlint.text import Span
from kinlint.uri_references import resolve_uri

FIRST, REST, NIL = iri(f"{RDF}first"), iri(f"{RDF}rest"), iri(f"{RDF}nil")

_DEPTH = 150
_ESCAPE = re.compile(r"\\(?:u([0-9A-Fa-f]{4})|U([0-9A-Fa-f]{8})|(.))", re.DOTALL)
_NAMED = {"t": "\t", "b": "\b", "n": "\n", "r": "\r", "f": "\f"}


class Statement(NamedTuple):
    """A triple, and where its three terms are written."""

    subject: Term
    """Subject."""
    predicate: Term
    """Predicate."""
    value: Term
    """Object."""
    places: tuple[Span, Span, Span]
    """Places of subject, predicate and object."""


@dataclass
class Grammar:
    """Reads a text into `statements`, in its order; `nodes` places what it describes."""

    text: str
    """Text to read."""
    base: str
    """IRI that relative IRIs are resolved against."""
    blanks: BlankNodes
    """Source of names for blank nodes."""
    statements: list[Statement] = field(default_factory=list)
    """Triples so far, in the order of the text."""
    nodes: dict[Term, NodeSpans] = field(default_factory=dict)
    """Places of the nodes that the text describes."""
    prefixes: dict[str, str] = field(default_factory=dict)
    """Namespaces by prefix, as far as declared."""
    declarations: list[tuple[str, str, Span]] = field(default_factory=list)
    """Prefixes, each with its namespace and the place of that, in the order of the text."""

    def read(self) -> None:
        """Read everything.

        Raises Unread where the text is something else than Turtle 1.1.
        """
        self._tokens = tokens(self.text)
        self._depth = 0
        self._token = next(self._tokens)
        while self._token.kind != "end":
            self._statement()

    def _next(self) -> Token:
        token = self._token
        self._token = next(self._tokens, token)
        return token

    def _take(self, text: str) -> Token:
        if self._token.text != text:
            raise Unread(self._token.start)
        return self._next()

    def _statement(self) -> None:
        word = self._token.text.lower()
        if word in ("@prefix", "prefix", "@base", "base"):
            self._next()
            name = self._next().text.removesuffix(":") if word.endswith("prefix") else None
            token = self._next()
            target = self._resolved(token)
            if name is None:
                self.base = target
            else:
                self.prefixes[name] = target
                self.declarations.append((name, target, token.span))
            if word.startswith("@"):
                self._take(".")
            return
        first = self._token
        before = len(self.statements)
        subject, place = self._term()
        bare = first.text == "[" and len(self.statements) > before
        if not (bare and self._token.text == "."):
            self._predicates(subject, place)
        end = self._take(".").end
        if first.text not in ("[", "("):
            self.nodes.setdefault(subject, NodeSpans(Span(first.start, end), place))

    def _predicates(self, subject: Term, place: Span) -> None:
        while True:
            token = self._next()
            predicate = RDF_TYPE if token.text == "a" else iri(self._name(token))
            while True:
                value, where = self._term()
                places = (place, token.span, where)
                self.statements.append(Statement(subject, predicate, value, places))
                if self._token.text != ",":
                    break
                self._next()
            if self._token.text != ";":
                return
            while self._token.text == ";":
                self._next()
            if self._token.text in (".", "]"):
                return

    def _term(self) -> tuple[Term, Span]:
        token = self._next()
        if token.kind == "string":
            return self._literal(token)
        if token.text == "[":
            return self._nested(self._properties, token)
        if token.text == "(":
            return self._nested(self._collection, token)
        if token.kind == "blank":
            return self.blanks.named(token.text[2:]), token.span
        return self._simple(token), token.span

    def _simple(self, token: Token) -> Term:
        if token.kind == "number":
            return literal(token.text, XSD + _number_type(token.text))
        if token.text in ("true", "false"):
            return literal(token.text, f"{XSD}boolean")
        return iri(self._name(token))

    def _nested(
        self, inner: Callable[[Token], tuple[Term, Span]], token: Token
    ) -> tuple[Term, Span]:
        self._depth += 1
        if self._depth > _DEPTH:
            raise Unread(token.start)
        result = inner(token)
        self._depth -= 1
        return result

    def _properties(self, opening: Token) -> tuple[Term, Span]:
        node = self.blanks.fresh()
        if self._token.text == "]":
            return node, Span(opening.start, self._next().end)
        start = opening.span
        self._predicates(node, start)
        span = Span(opening.start, self._take("]").end)
        self.nodes[node] = NodeSpans(span)
        return node, span

    def _collection(self, opening: Token) -> tuple[Term, Span]:
        elements: list[tuple[Term, Span]] = []
        while self._token.text != ")":
            elements.append(self._term())
        span = Span(opening.start, self._next().end)
        cells = [*(self.blanks.fresh() for _ in elements), NIL]
        for (value, place), cell, rest in zip(elements, cells, cells[1:], strict=False):
            self.statements.append(Statement(cell, FIRST, value, (span, place, place)))
            self.statements.append(Statement(cell, REST, rest, (span, span, span)))
        return cells[0], span

    def _literal(self, token: Token) -> tuple[Term, Span]:
        quotes = 3 if token.text[:3] in ('"""', "'''") else 1
        value = _unescaped(token.text[quotes:-quotes])
        if self._token.kind == "at":
            language = self._next()
            return literal(value, language=language.text[1:].lower()), Span(
                token.start, language.end
            )
        if self._token.text == "^^":
            self._next()
            datatype = self._next()
            span = Span(token.start, datatype.end)
            return literal(value, self._name(datatype)), span
        return literal(value), token.span

    def _name(self, token: Token) -> str:
        if token.kind == "iri":
            return self._resolved(token)
        prefix, colon, local = token.text.partition(":")
        if token.kind != "name" or not colon or prefix not in self.prefixes:
            raise Unread(token.start)
        return self.prefixes[prefix] + re.sub(r"\\(.)", r"\1", local)

    def _resolved(self, token: Token) -> str:
        if token.kind != "iri":
            raise Unread(token.start)
        written = _unescaped(token.text[1:-1])
        return (
            written if re.match(r"[A-Za-z][\w+.-]*:", written) else resolve_uri(self.base, written)
        )


def _unescaped(text: str) -> str:
    if "\\" not in text:
        return text
    return _ESCAPE.sub(_character, text)


def _character(match: re.Match[str]) -> str:
    short, long, other = match.groups()
    return _NAMED.get(other, other) if other else chr(int(short or long, 16))


def _number_type(text: str) -> str:
    if "e" in text.lower():
        return "double"
    return "decimal" if "." in text else "integer"
