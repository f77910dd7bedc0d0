"""Changes of containers and tokens of a JSON text, which become edits of the text."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from typing import Any

from kinlint.edits import Edit, NotExpressible
from kinlint.formats.json_text.json_values import Array, Object
from kinlint.formats.jsonld.editing.container_edits import ContainerLayout, NewChild
from kinlint.formats.jsonld.editing.style import Style
from kinlint.formats.jsonld.editing.text_path import Seat, TextTree, children
from kinlint.light_dataclasses import dataclass, field
from kinlint.text import Span


class DeletedRanges:
    """Ranges, of which any two are apart or one within the other, as tokens of JSON are."""

    def __init__(self) -> None:
        # The widest ones, ascending.
        self._starts: list[int] = []
        self._ends: list[int] = []

    def add(self, span: Span) -> None:
        """Add *span* to the ranges."""
        if span in self:
            return
        first = bisect_right(self._starts, span.start - 1)
        last = bisect_right(self._starts, span.end - 1)
        self._starts[first:last] = [span.start]
        self._ends[first:last] = [span.end]

    def __contains__(self, span: Span) -> bool:
        at = bisect_right(self._starts, span.start) - 1
        return at >= 0 and span.end <= self._ends[at]

    def __iter__(self) -> Iterator[Span]:
        return map(Span, self._starts, self._ends)


@dataclass
class _Touched:
    """Changes of one container."""

    container: Object | Array
    """The container."""
    gone: set[int] = field(default_factory=set)
    """Indices of the children that are removed."""
    new: list[NewChild] = field(default_factory=list)
    """Children that are added."""


@dataclass
class ContainerChanges:
    """Changes of a JSON text: values are replaced, children of containers removed and added.

    A container that loses all its children is removed.
    """

    text: str
    """The text to change."""
    tree: TextTree
    """Its values with their places."""
    style: Style
    """Its indentation and line ends."""
    cut: DeletedRanges = field(default_factory=DeletedRanges)
    """Removed ranges."""
    lasting: set[int] = field(default_factory=set)
    """Containers that stay, even if they lose all their children."""
    _tokens: dict[Span, Any] = field(default_factory=dict)
    _wraps: dict[Span, tuple[list[Any], list[Any]]] = field(default_factory=dict)
    _touched: dict[int, _Touched] = field(default_factory=dict)

    def replace(self, span: Span, value: Any) -> None:
        """Replace the token at *span* by *value*."""
        self._tokens[span] = value
        self.cut.add(span)

    def rename(self, span: Span, name: str) -> None:
        """Rename the key, or the value that is a name, at *span* to *name*."""
        self._tokens[span] = name

    def remove(self, seat: Seat) -> None:
        """Remove the member or element at *seat*."""
        touched = self._of(seat.holder)
        touched.gone.add(seat.number)
        whole = seat.span if isinstance(seat.at, int) else Span(seat.at.start, seat.at.value_end)
        self.cut.add(whole)

    def insert(self, container: Object | Array, piece: NewChild) -> None:
        """Insert *piece* into *container*, in the place of a removed child if there is one."""
        self._of(container).new.append(piece)

    def wrap(self, span: Span, value: Any, *, first: bool = False) -> None:
        """Replace the value at *span* by an array of itself and *value*, which may come *first*."""
        before, after = self._wraps.setdefault(span, ([], []))
        (before if first else after).append(value)

    def gone(self, container: Object | Array) -> set[int]:
        """Return the numbers of the children of *container* that go."""
        return self._of(container).gone

    def _of(self, container: Object | Array) -> _Touched:
        return self._touched.setdefault(id(container), _Touched(container))

    def edits(self) -> list[Edit]:
        """Return the edits, ascending and apart.

        Raises Unsayable where one would be within what another takes out.
        """
        self._empty()
        layout = ContainerLayout(self.text, self.tree.root, self.style)
        edits: list[Edit] = []
        for span, (before, after) in self._wraps.items():
            edits += layout.wrapped(span, before, after)
        for touched in self._touched.values():
            edits += layout.contained(touched.container, touched.gone, touched.new)
        for span, value in self._tokens.items():
            indent, used = layout.line(span.start)
            edits.append(Edit(span, self.style.serialized(value, indent, used=used)))
        return [edit for edit in _joined(edits) if self.text[slice(*edit.span)] != edit.text]

    def _empty(self) -> None:
        """Remove containers that lose all their children."""
        waiting = list(self._touched.values())
        while waiting:
            touched = waiting.pop()
            container = touched.container
            if touched.new or id(container) in self.lasting or not touched.gone:
                continue
            seat = self.tree.seat(container)
            if seat is None or len(touched.gone) < len(children(container)):
                continue
            self.remove(seat)
            waiting.append(self._of(seat.holder))


def _joined(edits: list[Edit]) -> list[Edit]:
    """Return edits in order; those that touch are one, and deletions within others are left out."""
    joined: list[Edit] = []
    for edit in sorted(edits, key=_order):
        last = joined[-1] if joined else None
        if last is None or edit.span.start > last.span.end:
            joined.append(edit)
        elif edit.span.start == last.span.end:
            joined[-1] = Edit(Span(last.span.start, edit.span.end), last.text + edit.text)
        elif edit.text:
            raise NotExpressible("the new statement would be inside a deleted one")
    return joined


def _order(edit: Edit) -> tuple[int, bool, int]:
    """Return the sort key: by place; at one place insertions first, then the longest."""
    start, end = edit.span
    return start, end > start, -end
