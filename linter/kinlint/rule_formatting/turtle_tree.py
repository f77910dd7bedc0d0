"""The statements of a Turtle text as a tree that keeps comments and the spelling of terms."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TypeAlias

from kinlint.formats.turtle.turtle_tokens import Token, tokens
from kinlint.light_dataclasses import dataclass, field

BLANK_LINE = re.compile(r"\n[ \t\r]*\n")


@dataclass(frozen=True)
class Leaf:
    """A term as it is written."""

    text: str
    """The term."""


@dataclass(frozen=True)
class Branch:
    """A collection, or a blank node with properties."""

    items: tuple[Value, ...] = ()
    """The members of a collection."""
    properties: tuple[Property, ...] = ()
    """The properties of a blank node."""
    is_collection: bool = False
    """True for a collection."""
    comments: tuple[str, ...] = ()
    """Comments before the closing bracket."""


Value: TypeAlias = "Leaf | Branch"


@dataclass(frozen=True)
class Property:
    """A verb and its objects."""

    verb: str
    """Verb, as written."""
    objects: tuple[Value, ...]
    """Objects, in their order."""
    comments: tuple[str, ...] = ()
    """Comments before it, and among its objects."""

    spaced: bool = False
    """A blank line stands before it."""


@dataclass(frozen=True)
class Statement:
    """A subject with its properties, or a directive, which has none."""

    subject: Value
    """Subject, or the directive."""
    properties: tuple[Property, ...] = ()
    """Properties, in their order; none for a directive."""
    comments: tuple[str, ...] = ()
    """Comments before it."""

    spaced: bool = False
    """A blank line stands before it."""


@dataclass
class Turtle:
    """A text that is read: its prefixes, its statements, and the names that stand in it."""

    text: str
    """The text."""
    prefixes: dict[str, str] = field(default_factory=dict)
    """The IRI of each prefix, with its brackets."""

    used: set[str] = field(default_factory=set)
    """The prefixes of the names in the text."""

    header: tuple[str, ...] = ()
    """Comments before the first directive."""

    trailer: tuple[str, ...] = ()
    """Comments after the last statement."""

    statements: list[Statement] = field(default_factory=list)
    """Statements in their order."""

    def __post_init__(self) -> None:
        """Read the text, which has to be Turtle: whether it is so is not found out here."""
        self._tokens = self._with_gaps()
        self._pending: list[str] = []
        self._spaced = False
        self._advance()
        while self._token.kind != "end":
            self._statement()
        self.trailer = self._comments()

    def _with_gaps(self) -> Iterator[tuple[str, Token]]:
        end = 0
        for token in tokens(self.text):
            yield self.text[end : token.start], token
            end = token.end

    def _advance(self) -> Token:
        """Go to the next token, and return the one that was current."""
        token = getattr(self, "_token", None)
        gap, self._token = next(self._tokens, ("", Token("end", "", 0, 0)))
        self._spaced = BLANK_LINE.search(gap) is not None
        self._pending += [line.strip() for line in gap.split("\n") if line.strip()]
        return token or self._token

    def _comments(self) -> tuple[str, ...]:
        found, self._pending = tuple(self._pending), []
        return found

    def _statement(self) -> None:
        spaced, comments = self._spaced, self._comments()
        if self._token.text in ("@prefix", "PREFIX", "prefix"):
            if not self.prefixes:
                self.header = comments
                comments = ()
            self._advance()
            name = self._advance().text.rstrip(":")
            self.prefixes[name] = self._advance().text
            self._pending = [*comments, *self._pending]
        else:
            subject = self._value()
            at_end = self._token.text == "."
            properties = () if at_end else self._properties()
            self.statements.append(Statement(subject, properties, comments, spaced))
        if self._token.text == ".":
            self._advance()

    def _properties(self) -> tuple[Property, ...]:
        found: list[Property] = []
        while self._token.text not in (".", "]") and self._token.kind != "end":
            spaced, comments = self._spaced, self._comments()
            verb = self._word(self._advance())
            objects = [self._value()]
            while self._token.text == ",":
                self._advance()
                objects.append(self._value())
            while self._token.text == ";":
                after = self._pending
                self._pending = []
                comments = (*comments, *after)
                self._advance()
            found.append(Property(verb, tuple(objects), comments, spaced))
        return tuple(found)

    def _value(self) -> Value:
        token = self._advance()
        if token.text == "[":
            properties = self._properties()
            branch = Branch(properties=properties, comments=self._comments())
            self._advance()
            return branch
        if token.text == "(":
            items: list[Value] = []
            while self._token.text != ")":
                items.append(self._value())
            self._advance()
            return Branch(tuple(items), is_collection=True)
        text = self._word(token)
        if token.kind == "string" and self._token.kind == "at":
            text += self._advance().text
        elif token.kind == "string" and self._token.text == "^^":
            self._advance()
            text += f"^^{self._word(self._advance())}"
        return Leaf(text)

    def _word(self, token: Token) -> str:
        if token.kind == "name":
            self.used.add(token.text.partition(":")[0])
        return token.text
