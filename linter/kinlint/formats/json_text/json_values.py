"""JSON values that carry their place: each is a plain Python value to those who do not care.

`start` and `end` are offsets of the token in the text, quotes and brackets included. `true`,
`false` and `null` cannot carry anything; their place is known to the key or array they stand in.
"""

from __future__ import annotations

from typing import Any, NamedTuple, TypeAlias

from kinlint.text import Span


class Placed:
    """Mix-in of values with their range in the text, brackets and quotes included."""

    __slots__ = ()
    start: int
    end: int

    @property
    def span(self) -> Span:
        """The token, or the brackets and all between."""
        return Span(self.start, self.end)


class Text(Placed, str):
    """A string."""

    __slots__ = ("end", "start")


class Key(Text):
    """A member's name, which also knows where the member's value stands."""

    __slots__ = ("value_end", "value_start")
    value_start: int
    value_end: int

    @property
    def value_span(self) -> Span:
        """The value's token."""
        return Span(self.value_start, self.value_end)


class Integer(Placed, int):
    """A number without fraction and exponent."""


class Real(Placed, float):
    """A number with a fraction or an exponent."""

    __slots__ = ("end", "start")


class Array(Placed, list[Any]):
    """An array; `literals` places the `true`, `false` and `null` among its elements."""

    __slots__ = ("end", "literals", "start")
    literals: dict[int, Span] | None

    def __init__(self, start: int) -> None:
        super().__init__()
        self.start = self.end = start
        self.literals = None

    def element_span(self, index: int) -> Span:
        """Return the span of element *index*."""
        if self.literals and index in self.literals:
            return self.literals[index]
        element = self[index]
        return Span(element.start, element.end)


class Member(NamedTuple):
    """Occurrence of a key with its value."""

    key: Key
    """Key, with its place."""
    value: Any
    """The value."""


class Object(Placed, dict[str, Any]):
    """An object: the last occurrence of a key wins, `overwritten` holds the earlier ones."""

    __slots__ = ("end", "overwritten", "start")
    overwritten: list[Member] | None

    def __init__(self, start: int) -> None:
        super().__init__()
        self.start = self.end = start
        self.overwritten = None

    def key(self, name: str) -> Key | None:
        """Return the token of the key called *name*."""
        return next((key for key in self if key == name and isinstance(key, Key)), None)


Value: TypeAlias = Text | Integer | Real | Array | Object | bool | None


class ParsedJson(NamedTuple):
    """A JSON text: its value, where that stands, and the objects with repeated keys."""

    value: Value
    """The value."""
    span: Span
    """Place of the value."""
    repeats: list[Object]
    """Objects with repeated keys."""
