"""JSON with places down to the elements of the outermost `@graph`, which are plain values."""

from __future__ import annotations

import re
from json import JSONDecoder
from math import isinf
from typing import Any, NoReturn

from kinlint.errors import SourceError
from kinlint.formats.json_text.json_parser import (
    MAX_DIGITS,
    NEXT_ELEMENT,
    NEXT_MEMBER,
    Parser,
    element,
)
from kinlint.formats.json_text.json_values import Array, Object, ParsedJson, Placed
from kinlint.text import SourceText, Span

GRAPH = "@graph"
WITHIN = 2
"""The object and the array in which the elements of the outermost graph stand."""
_ESCAPED_SURROGATE = re.compile(r"\\u[dD][89a-fA-F]")


class Unplaced(Placed):
    """An element of the outermost graph, as a plain value; only its own place is known."""

    __slots__ = ("end", "source", "start", "value")

    def __init__(self, source: SourceText, start: int, end: int, value: dict[str, Any]) -> None:
        self.source = source
        self.start = start
        self.end = end
        self.value = value

    def placed(self) -> tuple[Object, list[Object]]:
        """Return the same with the places of all that is in it, and its objects that repeat keys.

        Raises SourceError for what is nested too deep.
        """
        found = element(self.source, self.start, first=True, depth=WITHIN)
        return found.value, found.repeats


class Repeating(dict[str, Any]):
    """A plain object with a key that stands in it more than once."""


class NotOutlined(Exception):
    """The text has no outermost graph of objects, or is read with care for another reason."""


def outline(source: SourceText) -> ParsedJson:
    """Parse *source*, leaving the objects in the array of its outermost `@graph` `Unplaced`.

    Raises NotOutlined where `parse` has to tell what it is, if it is JSON at all.
    """
    if "\\" in source.text and _ESCAPED_SURROGATE.search(source.text):
        raise NotOutlined
    try:
        return _Outline(source).document()
    except (SourceError, ValueError, StopIteration, RecursionError) as error:
        raise NotOutlined from error


class _Outline(Parser):
    def document(self) -> ParsedJson:
        """Return the outermost object."""
        start = self.space(0)
        if not self.text.startswith("{", start):
            raise NotOutlined
        root = Object(start)
        at, follows = self.space(start + 1), None
        graph = False
        while True:
            key, at = self.key(follows.end() if follows else at)
            begin = at
            if key == GRAPH and self.text.startswith("[", at):
                value, at = self._elements(at)
                graph = True
            elif self.text[at : at + 1] in ("{", "["):
                value, at = self.container(at, 1)
            else:
                value, at = self.scalar(at)
            self.add(root, key, value, begin, at)
            follows = NEXT_MEMBER.match(self.text, at)
            if follows is None:
                break
        end = self.close(root, at)
        if not graph or root.overwritten is not None or self.space(end) != len(self.text):
            raise NotOutlined
        return ParsedJson(root, Span(start, end), self.repeats)

    def _elements(self, at: int) -> tuple[Array, int]:
        array, text, source, scan = Array(at), self.text, self.source, _SCANNER.scan_once
        at = self.space(at + 1)
        while True:
            if not text.startswith("{", at):
                raise NotOutlined
            value, end = scan(text, at)
            array.append(Unplaced(source, at, end, value))
            follows = NEXT_ELEMENT.match(text, end)
            if follows is None:
                return array, self.close(array, end)
            at = follows.end()


def _object(members: list[tuple[str, Any]]) -> dict[str, Any]:
    found = dict(members)
    return found if len(found) == len(members) else Repeating(found)


def _integer(spelling: str) -> int:
    _check(spelling)
    return int(spelling)


def _real(spelling: str) -> float:
    return _check(spelling)


def _check(spelling: str) -> float:
    number = float(spelling)
    if len(spelling) > MAX_DIGITS or isinf(number):
        raise NotOutlined
    return number


def _refuse(_: str) -> NoReturn:
    raise NotOutlined


_SCANNER: Any = JSONDecoder(
    object_pairs_hook=_object, parse_int=_integer, parse_float=_real, parse_constant=_refuse
)
