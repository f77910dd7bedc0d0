"""Layout style of a JSON text, applied to new values."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from typing import Any, Self

from kinlint.formats.json_text.json_values import Array, Object
from kinlint.formats.jsonld.editing.text_path import children
from kinlint.formats.jsonld.editing.tracing import OutlinedArray
from kinlint.light_dataclasses import dataclass
from kinlint.text import Span

WIDTH = 100
"""The line that a value may fill before it is broken, unless the file's own lines are longer."""

_SAMPLE = 2000
_LINE_END = re.compile(r"\r\n|\r|\n")
_OPENED = {"[": re.compile(r"\[[ \t]*+[^\s\]]"), "{": re.compile(r"\{[ \t]*+[^\s}]")}
"""Beginnings of containers that begin on one line, by their brackets, or the like in a string."""


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
    survey = _Survey(text)
    survey.look(root)
    colon = survey.colon or ": "
    comma = survey.comma or ("," if colon == ":" and not survey.newline else ", ")
    array, object_ = survey.pads["["], survey.pads["{"]
    return Style(
        survey.newline or "",
        survey.unit if survey.unit is not None else "  ",
        colon,
        comma,
        array if array is not None else (object_ or ""),
        object_ if object_ is not None else (array or ""),
        array is not None or "[" not in survey.spread,
        object_ is not None or not survey.newline,
        text.isascii() and re.search(r"\\u[0-9a-fA-F]{4}", text) is not None,
    )


class _Survey:
    """The layout that the first containers of *text* show, None for what none shows."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.newline: str | None = None
        self.unit: str | None = None
        self.colon: str | None = None
        self.comma: str | None = None
        self.pads: dict[str, str | None] = {"[": None, "{": None}
        """Space inside the brackets of the first array and object on one line."""
        self.spread: set[str] = set()
        """Opening brackets of containers on several lines."""

    def look(self, root: Any) -> None:
        """Look at the containers from *root* on, outer before inner.

        Elements of the outermost graph that cannot show anything more get no places.
        """
        level: list[tuple[Any, int, int | None]] = [(root, 1, None)]
        for held, depth, index in level:
            container = held if index is None else self._element(held, index)
            if not isinstance(container, (Object, Array)):
                continue
            self._read(container, depth)
            outlined = isinstance(container, OutlinedArray)
            values = container.values() if isinstance(container, Object) else container
            for number, value in enumerate(range(len(container)) if outlined else values):
                if len(level) >= _SAMPLE:
                    break
                if outlined:
                    level.append((container, depth + 1, number))
                elif isinstance(value, (Object, Array)):
                    level.append((value, depth + 1, None))

    def _element(self, graph: OutlinedArray, index: int) -> Any:
        """Return element *index* of *graph*, or None if nothing more can be seen in it."""
        if None not in (self.newline, self.unit, self.colon):
            missing = [
                bracket for bracket, pad in self.pads.items() if pad is None or self.comma is None
            ]
            if not any(self._may_show(graph.element_span(index), each) for each in missing):
                return None
        return graph[index]

    def _may_show(self, span: Span, bracket: str) -> bool:
        """Tell whether a container within *span* that opens with *bracket* may show more."""
        if bracket == "[" and "[" not in self.spread and self.pads["["] is None:
            return "[" in self.text[span.start : span.end]
        return _OPENED[bracket].search(self.text, span.start, span.end) is not None

    def _read(self, container: Object | Array, depth: int) -> None:
        """Note what *container* shows at a *depth*, from one."""
        held = children(container)
        if not held:
            return
        first = self.text[container.start + 1 : held[0].whole.start]
        if self.colon is None and held[0].key is not None:
            self.colon = self.text[held[0].key.end : held[0].value.start]
        found = _LINE_END.search(first)
        opening = self.text[container.start]
        if found:
            self.spread.add(opening)
            self.newline = self.newline or found.group()
            indent = first[first.rfind(found.group()) + len(found.group()) :]
            if self.unit is None:
                self.unit = indent[: len(indent) // depth]
            return
        if len(held) > 1 and self.comma is None:
            between = self.text[held[0].whole.end : held[1].whole.start]
            self.comma = between if not _LINE_END.search(between) else None
        if self.pads[opening] is None:
            self.pads[opening] = first
