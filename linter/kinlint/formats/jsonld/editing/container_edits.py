"""Edits that put new children into containers and take old ones out, in the manner of the text."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise
from typing import Any, NamedTuple

from kinlint.edits import Edit
from kinlint.formats.json_text.json_values import Array, Object
from kinlint.formats.jsonld.editing.style import WIDTH, Style
from kinlint.formats.jsonld.editing.text_path import Child, children
from kinlint.light_dataclasses import dataclass
from kinlint.text import Span

_LINE_END = re.compile(r"\r\n|\r|\n")
_SIBLINGS = 200


class NewChild(NamedTuple):
    """A new child of an object or array."""

    value: Any
    """JSON that is yet to be laid out."""
    key: str | None
    """Its key, in an object."""
    after: int
    """The number of the child before it; -1 if it comes first."""


@dataclass(frozen=True)
class ContainerLayout:
    """Lays out changes of `text`, whose outermost value is `root`, in its `style`."""

    text: str
    """The text to change."""
    root: Any
    """Its outermost value."""
    style: Style
    """Its indentation and line ends."""

    def wrapped(self, span: Span, before: Sequence[Any], after: Sequence[Any]) -> list[Edit]:
        """Return the edits that make an array of the value at *span* and other values."""
        style = self.style
        pad, joint, end = style.array_pad, style.comma, style.array_pad
        if not style.flat_arrays:
            indent, _ = self.line(span.start)
            pad = style.newline + indent + style.unit
            joint, end = f",{pad}", style.newline + indent
        opening = f"[{pad}" + "".join(f"{style.flat(value)}{joint}" for value in before)
        closing = "".join(f"{joint}{style.flat(value)}" for value in after) + f"{end}]"
        return [Edit(Span(at, at), text) for at, text in zip(span, (opening, closing), strict=True)]

    def contained(
        self, container: Object | Array, gone: set[int], new: Sequence[NewChild]
    ) -> list[Edit]:
        """Return the edits that remove the children *gone* of *container* and insert *new* ones."""
        held = children(container)
        if not held:
            return [self._filled(container, new)] if new else []
        left, pieces = set(gone), []
        edits: list[Edit] = []
        for piece in new:
            heir = self._heir(held, left, piece)
            if heir is None:
                pieces.append(piece)
            else:
                left.remove(heir)
                edits += self._exchanged(held[heir], piece)
        kept = [number for number in range(len(held)) if number not in left]
        if not kept:
            return [self._emptied(container, held, pieces)]
        edits += _removed(held, left)
        edits += [self._inserted(container, held, kept, piece) for piece in pieces]
        return edits

    def _heir(self, held: list[Child], gone: set[int], piece: NewChild) -> int | None:
        """Return the removed child whose place *piece* takes; elements keep their order."""
        if piece.key is None:
            return next(
                (number for number in (piece.after, piece.after + 1) if number in gone), None
            )
        alike = (number for number in sorted(gone) if self._alike(held[number], piece))
        return next(alike, min(gone, default=None))

    def _alike(self, old: Child, piece: NewChild) -> bool:
        """Tell whether *piece* has the key or the value of *old*."""
        same = self.text[old.value.start : old.value.end] == self.style.flat(piece.value)
        return same or old.key == piece.key

    def _exchanged(self, old: Child, piece: NewChild) -> list[Edit]:
        indent, used = self.line(old.value.start)
        value = self.style.serialized(piece.value, indent, used=used)
        edits = []
        if old.key is not None and piece.key is not None and piece.key != old.key:
            edits.append(Edit(old.key.span, self.style.text(piece.key)))
        if value != self.text[old.value.start : old.value.end]:
            edits.append(Edit(old.value, value))
        return edits

    def _emptied(
        self, container: Object | Array, held: list[Child], pieces: Sequence[NewChild]
    ) -> Edit:
        """Return the edit that replaces all children by *pieces*, or by nothing at all."""
        if not pieces:
            return Edit(Span(container.start + 1, container.end - 1), "")
        first = held[0].whole.start
        joint = self._joint(container, held, 0, first=True)
        indent, _ = self.line(first)
        spread = _LINE_END.search(joint) is not None
        texts = [self._child(container, piece, indent, spread=spread) for piece in pieces]
        return Edit(Span(first, held[-1].whole.end), joint.join(texts))

    def _filled(self, container: Object | Array, pieces: Sequence[NewChild]) -> Edit:
        """Return the edit that gives an empty container its first children."""
        if isinstance(container, Object):
            value: Any = {str(piece.key): piece.value for piece in pieces}
        else:
            value = [piece.value for piece in pieces]
        indent, used = self.line(container.start)
        flat = False if container is self.root and self.style.newline else None
        text = self.style.serialized(value, indent, used=used, flat=flat)
        return Edit(Span(container.start, container.end), text)

    def _inserted(
        self, container: Object | Array, held: list[Child], kept: list[int], piece: NewChild
    ) -> Edit:
        before = [number for number in kept if number <= piece.after]
        neighbour = before[-1] if before else kept[0]
        joint = self._joint(container, held, neighbour, first=not before)
        found = _LINE_END.search(joint)
        indent = joint[joint.rfind(found.group()) + len(found.group()) :] if found else ""
        text = self._child(container, piece, indent, spread=found is not None)
        if found and isinstance(container, Array) and not isinstance(piece.value, dict):
            joint = self._same_line(held, text) or joint
        if before:
            at = held[neighbour].whole.end
            return Edit(Span(at, at), joint + text)
        at = held[neighbour].whole.start
        return Edit(Span(at, at), text + joint)

    def _child(
        self, container: Object | Array, piece: NewChild, indent: str, *, spread: bool
    ) -> str:
        style = self.style
        name = f"{style.text(piece.key)}{self._colon(container)}" if piece.key is not None else ""
        if not spread:
            return name + style.flat(piece.value)
        flat = None
        if isinstance(container, Array) and isinstance(piece.value, dict):
            flat = None if self._has_flat(container) else False
        return name + style.serialized(piece.value, indent, used=len(name) + 1, flat=flat)

    def _colon(self, container: Object | Array) -> str:
        first = children(container)[0]
        return (
            self.style.colon if first.key is None else self.text[first.key.end : first.value.start]
        )

    def _has_flat(self, array: Array) -> bool:
        """Tell whether some object of *array* is written on one line."""
        near = (element for element in array[:_SIBLINGS] if isinstance(element, Object))
        return any(not _LINE_END.search(self.text, *element.span) for element in near if element)

    def _joint(
        self, container: Object | Array, held: list[Child], neighbour: int, *, first: bool
    ) -> str:
        """Return the text between two children, the first of them *neighbour*."""
        if neighbour + 1 < len(held):
            return self.text[held[neighbour].whole.end : held[neighbour + 1].whole.start]
        if neighbour and not first:
            return self.text[held[neighbour - 1].whole.end : held[neighbour].whole.start]
        lead = self.text[container.start + 1 : held[0].whole.start]
        return f",{lead}" if _LINE_END.search(lead) else self.style.comma

    def _same_line(self, held: list[Child], text: str) -> str | None:
        """Return the separator of elements on one line, if there are any and room for one more."""
        for one, other in pairwise(held):
            between = self.text[one.whole.end : other.whole.start]
            if not _LINE_END.search(between):
                end = held[-1].whole.end
                width = end - self._start_of_line(end) + len(between) + len(text)
                return between if width < WIDTH else None
        return None

    def _start_of_line(self, offset: int) -> int:
        return max(self.text.rfind("\n", 0, offset), self.text.rfind("\r", 0, offset)) + 1

    def line(self, offset: int) -> tuple[str, int]:
        """Return the indentation of the line of *offset*, and the number of characters between."""
        start = self._start_of_line(offset)
        line = self.text[start:offset]
        indent = line[: len(line) - len(line.lstrip(" \t"))]
        return indent, len(line) - len(indent)


def _removed(held: list[Child], gone: set[int]) -> list[Edit]:
    """Return edits that take out runs of children with their commas; some child stays."""
    edits = []
    for first in sorted(number for number in gone if number - 1 not in gone):
        last = first
        while last + 1 in gone:
            last += 1
        if first == 0:
            span = Span(held[0].whole.start, held[last + 1].whole.start)
        else:
            span = Span(held[first - 1].whole.end, held[last].whole.end)
        edits.append(Edit(span, ""))
    return edits
