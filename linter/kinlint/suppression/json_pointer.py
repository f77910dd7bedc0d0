"""Resolves JSON Pointers (RFC 6901) to places in a text without parsing it into values."""

from __future__ import annotations

import re
from json import JSONDecodeError, JSONDecoder
from typing import NamedTuple

from kinlint.text import Span

_SPACE = re.compile(r"[ \t\r\n]*")
_SKIP = JSONDecoder().raw_decode


class Place(NamedTuple):
    """The place of a value, and the same with the key in front of it, if any."""

    value: Span
    """Place of the value."""
    member: Span
    """The same with the key in front of it, if any."""


def locate(text: str, pointer: str) -> Place | None:
    """The place of the value at *pointer*; None if there is none or the text is not JSON.

    Of equal keys in one object the last counts, as for every JSON reader in use.
    """
    if pointer and not pointer.startswith("/"):
        return None
    try:
        start = at = _skip_space(text, 0)
        for token in pointer.split("/")[1:]:
            found = _step(text, at, token.replace("~1", "/").replace("~0", "~"))
            if found is None:
                return None
            start, at = found
        end = _SKIP(text, at)[1]
    except (JSONDecodeError, IndexError, RecursionError):
        return None
    return Place(Span(at, end), Span(start, end))


def _skip_space(text: str, at: int) -> int:
    match = _SPACE.match(text, at)
    return match.end() if match else at


def _step(text: str, at: int, token: str) -> tuple[int, int] | None:
    """The offsets of what *token* names in the value at *at*: with its key, and without."""
    if text[at] == "{":
        return _member(text, _skip_space(text, at + 1), token)
    if text[at] == "[" and token.isdecimal():
        return _element(text, _skip_space(text, at + 1), int(token))
    return None


def _member(text: str, at: int, key: str) -> tuple[int, int] | None:
    found = None
    while text[at] != "}":
        start = at
        name, at = _SKIP(text, at)
        at = _skip_space(text, _skip_space(text, at) + 1)
        if name == key:
            found = start, at
        at = _skip_space(text, _SKIP(text, at)[1])
        if text[at] == ",":
            at = _skip_space(text, at + 1)
    return found


def _element(text: str, at: int, index: int) -> tuple[int, int] | None:
    while text[at] != "]":
        if index == 0:
            return at, at
        index -= 1
        at = _skip_space(text, _SKIP(text, at)[1])
        if text[at] == ",":
            at = _skip_space(text, at + 1)
    return None
