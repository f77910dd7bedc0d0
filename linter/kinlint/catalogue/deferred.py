"""Sequences that are decoded no earlier than they are looked at."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, NamedTuple, TypeVar, overload

from kinlint.engine.constraint import Constraint

T = TypeVar("T")


class _Decoded(Sequence[T]):
    """A sequence of what `_value` returns; to others, as good as a tuple."""

    def _value(self, index: int) -> T:
        raise NotImplementedError

    @overload
    def __getitem__(self, index: int) -> T: ...
    @overload
    def __getitem__(self, index: slice) -> tuple[T, ...]: ...
    def __getitem__(self, index: int | slice) -> T | tuple[T, ...]:
        numbers = range(len(self))[index]
        return (
            self._value(numbers) if isinstance(numbers, int) else tuple(map(self._value, numbers))
        )

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Sequence) and tuple(self) == tuple(other)

    def __hash__(self) -> int:
        return hash(tuple(self))

    def __repr__(self) -> str:
        return repr(tuple(self))

    def __reduce__(self) -> tuple[Any, ...]:
        return tuple, (tuple(self),)


class Deferred(_Decoded[T]):
    """A sequence that is decoded as a whole."""

    def __init__(self, decode: Callable[[], Iterable[T]]) -> None:
        """Begin with what *decode* will return."""
        self._decode = decode
        self._values: tuple[T, ...] | None = None

    def _decoded(self) -> tuple[T, ...]:
        if self._values is None:
            self._values = tuple(self._decode())
        return self._values

    def __len__(self) -> int:
        return len(self._decoded())

    def _value(self, index: int) -> T:
        return self._decoded()[index]

    def __iter__(self) -> Iterator[T]:
        return iter(self._decoded())


class ConstraintHead(NamedTuple):
    """The part of a constraint that decides whether a run needs it."""

    owner: str
    """The IRI of its rule, or of a shape outside rules."""
    formats: tuple[str, ...]
    """The formats of its rule that it looks at, none for all."""
    deferred: bool
    """True if only the reference engine may judge it."""


class ConstraintTable(_Decoded[Constraint]):
    """Constraints that are decoded one by one."""

    def __init__(
        self, heads: Sequence[ConstraintHead], decode: Callable[[int], Constraint]
    ) -> None:
        """Begin with the *heads* of all, and with *decode*, which returns one of them."""
        self.heads = heads
        self._decode = decode
        self._known: dict[int, Constraint] = {}

    def __len__(self) -> int:
        return len(self.heads)

    def _value(self, index: int) -> Constraint:
        if index not in self._known:
            self._known[index] = self._decode(index)
        return self._known[index]


def heads(constraints: Sequence[Constraint]) -> Sequence[ConstraintHead]:
    """Return the heads of *constraints*, without decoding them."""
    if isinstance(constraints, ConstraintTable):
        return constraints.heads
    return [
        ConstraintHead(each.owner, each.formats, each.deferred is not None) for each in constraints
    ]
