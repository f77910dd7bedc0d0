"""Layout style of a JSON text, applied to new values."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from typing import Any, Self

from kinlint.formats.json_text.json_values import Array, Object
from kinlint.formats.jsonld.editing.text_path import children
from kinlint.light_dataclasses import dataclass

WIDTH = 100
"""The line that a value may fill before it is broken, unless the file's own lines are longer."""

_SAMPLE = 2000
_LINE_END = re.compile(r"\r\n|\r|\n")


class Verbatim(str):
    """JSON text that is to be written as it is."""

    __slots__ = ()


class Spelled(float):
    """A number with the characters to write it."""

    __slots__ = ("spelling",)
    spelling: str

    def __new__(cls, spelling: str) -> Self:
        """Return the number that *spelling* writes in JSON."""
        number = super().__new__(cls, spelling)
        number.spelling = spelling
        return number


@dataclass(frozen=True)
class Style:
    """Layout of one file."""

    newline: str
    """Line end."""
    unit: str
    """Indentation of a level."""
    colon: str
    """Separator of key and value."""
    comma: str
    """Separator of values on one line."""
    array_pad: str
    """Space inside the brackets of an array on one line."""
    object_pad: str
    """Space inside the brackets of an object on one line."""
    flat_arrays: bool
    """True if some array is opened and closed on one line."""
    flat_objects: bool
    """True if some object is opened and closed on one line."""
    ascii: bool
    """True if other characters are escaped."""

    def serialized(
        self, value: Any, indent: str, *, flat: bool | None = None, used: int = 0
    ) -> str:
        """Return *value* as JSON at a line indented by *indent*.

        *used* is the number of characters taken on the line. *flat* keeps an object on one line, or
        spreads it; by default the style of the file decides.
        """
        line = self.flat(value)
        if isinstance(value, (dict, list)) and value and self.newline:
            kin = self.flat_objects if isinstance(value, dict) else self.flat_arrays
            wanted = kin if flat is None else flat
            if not wanted or (flat is None and len(indent) + used + len(line) > WIDTH):
                return self._spread(value, indent)
        return line

    def flat(self, value: Any) -> str:
        """Return *value* on one line."""
        if isinstance(value, dict):
            members = (f"{self.text(key)}{self.colon}{self.flat(v)}" for key, v in value.items())
            return self.bracketed("{", list(members), "}")
        if isinstance(value, list):
            return self.bracketed("[", [self.flat(element) for element in value], "]")
        return self.text(value)

    def bracketed(self, opening: str, texts: Sequence[str], closing: str) -> str:
        """Return *texts* with commas, in brackets, on one line."""
        pad = self.object_pad if opening == "{" else self.array_pad
        return (
            f"{opening}{pad}{self.comma.join(texts)}{pad}{closing}" if texts else opening + closing
        )

    def text(self, value: Any) -> str:
        """Return a scalar, or text that is JSON already."""
        if isinstance(value, Verbatim):
            return str(value)
        if isinstance(value, Spelled):
            return value.spelling
        return json.dumps(value, ensure_ascii=self.ascii)

    def _spread(self, value: Any, indent: str) -> str:
        inner = indent + self.unit
        if isinstance(value, dict):
            texts = []
            for key, item in value.items():
                name = f"{self.text(key)}{self.colon}"
                texts.append(name + self.serialized(item, inner, used=len(name) + 1))
            opening, closing = "{", "}"
        else:
            texts = [self.serialized(item, inner, used=1) for item in value]
            opening, closing = "[", "]"
        joint = f",{self.newline}{inner}"
        return f"{opening}{self.newline}{inner}{joint.join(texts)}{self.newline}{indent}{closing}"


def style(text: str, root: Any) -> Style:
    """Return the manner of *text*, by the first of its containers that show it."""
    newline = unit = comma = array_pad = object_pad = colon = None
    spread = {"[": False, "{": False}
    flat = {"[": False, "{": False}
    for container, depth in _containers(root):
        held = children(container)
        if not held:
            continue
        first = text[container.start + 1 : held[0].whole.start]
        if colon is None and held[0].key is not None:
            colon = text[held[0].key.end : held[0].value.start]
        found = _LINE_END.search(first)
        opening = text[container.start]
        if found:
            spread[opening] = True
            newline = newline or found.group()
            indent = first[first.rfind(found.group()) + len(found.group()) :]
            if unit is None and depth:
                unit = indent[: len(indent) // depth] if depth else indent
            continue
        if len(held) > 1 and comma is None:
            between = text[held[0].whole.end : held[1].whole.start]
            comma = between if not _LINE_END.search(between) else None
        flat[opening] = True
        if opening == "[" and array_pad is None:
            array_pad = first
        elif opening == "{" and object_pad is None:
            object_pad = first
    colon = colon or ": "
    comma = comma or ("," if colon == ":" and not newline else ", ")
    return Style(
        newline or "",
        unit if unit is not None else "  ",
        colon,
        comma,
        array_pad if array_pad is not None else (object_pad or ""),
        object_pad if object_pad is not None else (array_pad or ""),
        flat["["] or not spread["["],
        flat["{"] or not newline,
        text.isascii() and re.search(r"\\u[0-9a-fA-F]{4}", text) is not None,
    )


def _containers(root: Any) -> Iterator[tuple[Object | Array, int]]:
    """Yield the first containers of a text, outer before inner, with their depth from one."""
    level: list[tuple[Object | Array, int]] = [(root, 1)]
    for container, depth in level:
        yield container, depth
        values = container.values() if isinstance(container, Object) else container
        for value in values:
            if len(level) >= _SAMPLE:
                break
            if isinstance(value, (Object, Array)):
                level.append((value, depth + 1))
