"""The way from an offset down into a JSON text, and from a value up to what holds it."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from typing import Any, NamedTuple

from kinlint.formats.json_text.json_values import Array, Key, Object
from kinlint.text import Span


class Child(NamedTuple):
    """A member or an element: its place, and that of its value, which may be all of it."""

    whole: Span
    """Place of the member or element."""
    value: Span
    """Place of its value."""
    key: Key | None = None
    """Key of a member; None for an element of an array."""


class Seat(NamedTuple):
    """The position of a value: in an object under a key, or in an array at an index."""

    holder: Object | Array
    """Object or array that contains the value."""
    at: Key | int
    """Its key or index there."""

    @property
    def value(self) -> Any:
        """Return the value at this position."""
        return self.holder[self.at]  # type: ignore[index]

    @property
    def span(self) -> Span:
        """The value's place."""
        if isinstance(self.at, Key):
            return self.at.value_span
        assert isinstance(self.holder, Array)
        return self.holder.element_span(self.at)

    @property
    def number(self) -> int:
        """Return the index among the children of its holder, in the order of the text."""
        if isinstance(self.at, int):
            return self.at
        starts = [child.whole.start for child in children(self.holder)]
        return starts.index(self.at.start)


class TextTree:
    """A parsed text; the seats of containers are known once something within was asked for."""

    def __init__(self, root: Any) -> None:
        self.root = root
        self._seats: dict[int, Seat] = {}

    def seat(self, container: Object | Array) -> Seat | None:
        """Return the position of *container*; None if it is the root."""
        if container is self.root:
            return None
        if id(container) not in self._seats:
            self.seat_at(container.start)
        return self._seats.get(id(container))

    def above(self, container: Object | Array) -> Iterator[Seat]:
        """Yield the seats of *container* and of those around it, innermost first."""
        while (seat := self.seat(container)) is not None:
            yield seat
            container = seat.holder

    def container_at(self, offset: int) -> Any:
        """Return the innermost container round *offset*."""
        value, holder = self.root, self.root
        while isinstance(value, (Object, Array)):
            holder, seat = value, _towards(value, offset)
            value = seat.value if seat else None
            if isinstance(value, (Object, Array)) and seat:
                self._seats[id(value)] = seat
        return holder

    def seat_at(self, offset: int) -> Seat | None:
        """Return the seat of the value that begins at *offset*.

        None if that is the root or a key.
        """
        value, seat = self.root, None
        while isinstance(value, (Object, Array)) and value.start != offset:
            seat = _towards(value, offset)
            if seat is None:
                return None
            value = seat.value
            if isinstance(value, (Object, Array)):
                self._seats[id(value)] = seat
        return seat if seat is not None and seat.span.start == offset else None


def children(container: Object | Array) -> list[Child]:
    """Return the children of *container* in the order of the text, overwritten members too."""
    if isinstance(container, Array):
        spans = [container.element_span(index) for index in range(len(container))]
        return [Child(span, span) for span in spans]
    keys = [key for key in container if isinstance(key, Key)]
    if container.overwritten:
        keys = sorted([*keys, *(member.key for member in container.overwritten)], key=_start)
    return [Child(Span(key.start, key.value_end), key.value_span, key) for key in keys]


def _start(key: Key) -> int:
    return key.start


def _towards(container: Object | Array, offset: int) -> Seat | None:
    if isinstance(container, Object):
        for key in container:
            if isinstance(key, Key) and key.value_start <= offset < key.value_end:
                return Seat(container, key)
        return None
    found = bisect_right(
        range(len(container)), offset, key=lambda index: container.element_span(index).start
    )
    inside = found and offset < container.element_span(found - 1).end
    return Seat(container, found - 1) if inside else None
