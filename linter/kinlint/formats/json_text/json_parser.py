"""Reads JSON (RFC 8259) in one pass without recursion, keeping the place of every token."""

from __future__ import annotations

import re
from json.decoder import JSONDecodeError, scanstring  # type: ignore[attr-defined]
from math import isinf
from typing import Any, NamedTuple, NoReturn

from kinlint.errors import SourceError
from kinlint.formats.json_text.json_values import (
    Array,
    Integer,
    Key,
    Member,
    Object,
    ParsedJson,
    Real,
    Text,
)
from kinlint.text import SourceText, Span

MAX_DEPTH = 500
"""Largest nesting depth of arrays and objects."""
MAX_DIGITS = 1000
"""Largest length of a number in characters."""
SHOWN_DIGITS = 24
"""Number of characters of a number that a message repeats."""

_SPACE = re.compile(r"[ \t\n\r]*")
_PLAIN = re.compile(r'"[^"\\\x00-\x1f]*"')
_NUMBER = re.compile(r"-?(?:0|[1-9][0-9]*)(\.[0-9]+)?([eE][-+]?[0-9]+)?")
_WORD = re.compile(r"[^\s,:\[\]{}\"]{1,24}")
_SURROGATE = re.compile("[\ud800-\udfff]")
NEXT_MEMBER = re.compile(r'[ \t\n\r]*,[ \t\n\r]*(?=")')
NEXT_ELEMENT = re.compile(r"[ \t\n\r]*,[ \t\n\r]*(?![\],])")
_COLON = re.compile(r"[ \t\n\r]*:[ \t\n\r]*")
_LITERALS = {"t": ("true", True), "f": ("false", False), "n": ("null", None)}


def parse(source: SourceText) -> ParsedJson:
    """Parse the JSON value of *source*.

    Raises SourceError with line and column when it is none.
    """
    return Parser(source).document()


class ArrayElement(NamedTuple):
    """Element of an array."""

    value: Any
    """The value."""
    span: Span
    """Its place."""
    repeats: list[Object]
    """Objects in it with repeated keys."""
    closing: bool = False
    """True if it is not an element, but the bracket that ends the array."""


def element(source: SourceText, at: int, *, first: bool, depth: int) -> ArrayElement:
    """Parse the next element of an array.

    *depth* counts the arrays and objects around it, the array itself included. *at* is behind the
    opening bracket if the element is the *first*, or else behind the previous one. Raises
    SourceError as `parse` does.
    """
    return Parser(source).element(at, first=first, depth=depth)


class Parser:
    """Reader of one text; offsets go in and come out."""

    def __init__(self, source: SourceText) -> None:
        self.source = source
        self.text = source.text
        self.repeats: list[Object] = []
        self.tokens: dict[int, dict[str, Key]] = {}

    def fail(self, cause: str, at: int) -> NoReturn:
        """Refuse the text at an offset."""
        place = self.source.position(at)
        raise SourceError(self.source.name, cause, place.line, place.column)

    def document(self) -> ParsedJson:
        """Return the whole text."""
        text = self.text
        at = self.space(0)
        if at == len(text):
            self.fail("the file is empty", 0)
        if text[at] in "{[":
            value, end = self.container(at)
        else:
            value, end = self.scalar(at)
        rest = self.space(end)
        if rest != len(text):
            self.fail(f"not JSON: {self.shown(rest)} after the end of the value", rest)
        return ParsedJson(value, Span(at, end), self.repeats)

    def space(self, at: int) -> int:
        """Return the offset behind white space."""
        match = _SPACE.match(self.text, at)
        return match.end() if match else at

    def shown(self, at: int) -> str:
        """Return the token at an offset, for a message."""
        if at >= len(self.text):
            return "the end of the file"
        word = _WORD.match(self.text, at)
        return f"'{word.group() if word else self.text[at]}'"

    def unexpected(self, wanted: str, at: int) -> NoReturn:
        """Refuse what stands in the place of what is *wanted*."""
        if at >= len(self.text):
            self.fail(f"the file is cut off: expected {wanted}", at)
        self.fail(f"not JSON: expected {wanted}, found {self.shown(at)}", at)

    def container(self, at: int, depth: int = 0) -> tuple[Any, int]:
        """Return the array or object at an offset, with all it contains, within *depth* others."""
        text = self.text
        stack: list[tuple[Array | Object, Key | None]] = []
        current: Array | Object = Object(at) if text[at] == "{" else Array(at)
        root = current
        key: Key | None = None
        at = self.space(at + 1)
        first = True
        while True:
            # Invariant: `at` stands behind an opening bracket (first) or behind a value.
            if type(current) is Object:
                if first and text.startswith("}", at):
                    closed = True
                else:
                    match = None if first else NEXT_MEMBER.match(text, at)
                    closed = not first and match is None
                    if not closed:
                        key, at = self.key(match.end() if match else at)
            elif first and text.startswith("]", at):
                closed = True
            else:
                match = None if first else NEXT_ELEMENT.match(text, at)
                closed = not first and match is None
                at = match.end() if match else at
            if closed:
                at = self.close(current, at)
                if not stack:
                    return root, at
                done, (current, key) = current, stack.pop()
                self.add(current, key, done, done.start, at)
                first = False
                continue
            first = False
            opening = text[at : at + 1]
            if opening in ("{", "["):
                if depth + len(stack) >= MAX_DEPTH - 1:
                    self.fail(f"nested more than {MAX_DEPTH} levels deep", at)
                stack.append((current, key))
                current = Object(at) if opening == "{" else Array(at)
                at, first = self.space(at + 1), True
            else:
                value, end = self.scalar(at)
                self.add(current, key, value, at, end)
                at = end

    def element(self, at: int, *, first: bool, depth: int) -> ArrayElement:
        """Return the next element of an array, or its closing bracket."""
        at = self.space(at) if first else at
        follows = None if first else NEXT_ELEMENT.match(self.text, at)
        if self.text.startswith("]", at) if first else follows is None:
            end = self.close(Array(at), at)
            return ArrayElement(None, Span(end - 1, end), [], closing=True)
        at = follows.end() if follows else at
        if self.text[at : at + 1] in ("{", "["):
            value, end = self.container(at, depth)
        else:
            value, end = self.scalar(at)
        return ArrayElement(value, Span(at, end), self.repeats)

    def close(self, current: Array | Object, at: int) -> int:
        """End *current*, and return the offset behind its bracket."""
        at = self.space(at)
        if type(current) is Object:
            if not self.text.startswith("}", at):
                self.misplaced(at, "a key in double quotes", "',' or '}'")
        elif not self.text.startswith("]", at):
            self.misplaced(at, "a value", "',' or ']'")
        current.end = at + 1
        return at + 1

    def misplaced(self, at: int, after_comma: str, otherwise: str) -> NoReturn:
        """Refuse what follows a value, or a comma behind it."""
        if self.text.startswith(",", at):
            self.unexpected(after_comma, self.space(at + 1))
        self.unexpected(otherwise, at)

    def add(
        self, current: Array | Object, key: Key | None, value: Any, start: int, end: int
    ) -> None:
        """Add a value between two offsets to *current*, under *key* if that is an object."""
        if isinstance(current, Array):
            if value is None or value is True or value is False:
                if current.literals is None:
                    current.literals = {}
                current.literals[len(current)] = Span(start, end)
            current.append(value)
            return
        if key is None:
            raise AssertionError
        key.value_start, key.value_end = start, end
        if key in current:
            self.repeat(current, key)
        elif current.overwritten is not None:
            self.tokens[id(current)][key] = key
        current[key] = value

    def repeat(self, current: Object, key: Key) -> None:
        """Note that *key* stands in *current* once more."""
        # A dictionary keeps the first of two equal keys, so the earlier one must go.
        if current.overwritten is None:
            current.overwritten = []
            self.repeats.append(current)
            self.tokens[id(current)] = {known: known for known in current if type(known) is Key}
        tokens = self.tokens[id(current)]
        current.overwritten.append(Member(tokens[key], current.pop(key)))
        tokens[key] = key

    def key(self, at: int) -> tuple[Key, int]:
        """Return the key at an offset, and the offset of its value."""
        if not self.text.startswith('"', at):
            self.unexpected("a key in double quotes", at)
        content, end = self.string(at)
        key = Key(content)
        key.start, key.end = at, end
        colon = _COLON.match(self.text, end)
        if colon is None:
            self.unexpected("':'", self.space(end))
        return key, colon.end()

    def string(self, at: int) -> tuple[str, int]:
        """Return the string at an offset, and the offset behind it."""
        text = self.text
        plain = _PLAIN.match(text, at)
        if plain is not None:
            end = plain.end()
            return text[at + 1 : end - 1], end
        try:
            content, end = scanstring(text, at + 1, True)  # noqa: FBT003 (positional only)
        except JSONDecodeError as error:
            if error.msg.startswith("Unterminated"):
                self.fail("the file is cut off: a string is not closed", at)
            self.fail(f"not JSON: {error.msg[0].lower()}{error.msg[1:]}", error.pos)
        if _SURROGATE.search(content):
            self.fail("not JSON: half of a surrogate pair in a string", at)
        return content, end

    def scalar(self, at: int) -> tuple[Any, int]:
        """Return the value at an offset, no array or object, and the offset behind it."""
        text = self.text
        opening = text[at : at + 1]
        if opening == '"':
            content, end = self.string(at)
            string = Text(content)
            string.start, string.end = at, end
            return string, end
        number = _NUMBER.match(text, at)
        if number is not None:
            return self.number(number)
        word, literal = _LITERALS.get(opening, ("", None))
        if word and text.startswith(word, at):
            self.boundary(at + len(word), at)
            return literal, at + len(word)
        return self.unexpected("a value", at)

    def boundary(self, end: int, at: int) -> None:
        """Refuse a word or number that runs on: `nullx`, `01`, `1.`, `1e`."""
        following = self.text[end : end + 1]
        if following and (following.isalnum() or following in "._+-"):
            self.fail(f"not JSON: expected a value, found {self.shown(at)}", at)

    def number(self, match: re.Match[str]) -> tuple[Integer | Real, int]:
        """Return the matched number, and the offset behind it."""
        at, end = match.span()
        self.boundary(end, at)
        if end - at > MAX_DIGITS:
            self.fail(f"a number of {end - at} characters is too long to be one", at)
        spelling = match.group()
        number: Integer | Real
        if isinf(float(spelling)):
            shown = spelling if len(spelling) <= SHOWN_DIGITS else f"{spelling[:SHOWN_DIGITS]}..."
            self.fail(f"the number {shown} is too large for a double", at)
        number = Integer(spelling) if match.lastindex is None else Real(spelling)
        number.start, number.end = at, end
        return number, end
