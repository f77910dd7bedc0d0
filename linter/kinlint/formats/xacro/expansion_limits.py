"""Limits of an expansion: far more than any robot needs, far less than what hangs.

Work is counted, not timed, so that a file has the same result on every machine. A step of the
evaluator counts one. What Python does in one call counts by the size of what it is given, with
everything that is shared written out: hashing, comparing and printing follow all of it.
"""

from __future__ import annotations

import ast
from collections.abc import (
    Callable,
    Iterable,
    Iterator,
    KeysView,
    Mapping,
    Sequence,
    Sized,
    ValuesView,
)
from collections.abc import Set as AbstractSet
from time import thread_time
from typing import Any

from kinlint.light_dataclasses import dataclass

NUMBER = 1 << 256
"""Whole numbers beyond this are refused."""
CHARACTERS = 1 << 20
ITEMS = 100_000
"""The size of one text, and of one list."""
ENTRIES = 2_000
"""The size of one set or table: with keys of equal hash, filling it is quadratic."""
PER_STEP = 16
"""Items or characters that Python handles in the time of a step, on the safe side."""
FILLED = (set, frozenset, dict)
"""Types that fill a set or a table with the items of their argument."""
UNCOUNTED = (isinstance, issubclass)
"""Functions that look at no content, and whose arguments are types."""


class Refused(Exception):
    """An expression asks for what no robot description needs."""


class LimitExceeded(Exception):
    """An expansion goes beyond what any robot needs."""


@dataclass
class Limits:
    """Remaining allowances of one expansion.

    PR2, whose expansion is the longest of the public robots, needs 15 % of the elements, 5 % of the
    steps and 1 % of the characters.
    """

    nodes: int = 120_000
    """Elements, texts and comments that may still be made."""
    steps: int = 300_000
    """Steps that evaluation may still take."""
    characters: int = 1 << 23
    """Characters of texts that may still be made."""
    seconds: float = 10.0
    """CPU time, in case that a count misses something."""

    def __post_init__(self) -> None:
        self._until = thread_time() + self.seconds

    @property
    def exhausted(self) -> bool:
        """Tell whether an allowance is used up."""
        return min(self.nodes, self.steps, self.characters) < 0 or thread_time() > self._until

    def node(self) -> None:
        """Count another element, text or comment."""
        self.nodes -= 1
        if self.nodes < 0:
            raise LimitExceeded("it expands to far more elements than any robot has")

    def step(self) -> None:
        """Count another step of evaluation."""
        self.steps -= 1
        if self.steps < 0:
            raise LimitExceeded("evaluating its expressions takes far longer than for any robot")
        if not self.steps & 0xFFF and thread_time() > self._until:
            raise LimitExceeded(f"expanding it takes longer than {self.seconds:g} seconds")

    def charge(self, weight: int) -> None:
        """Count the steps of handling *weight* items or characters."""
        self.steps -= weight // PER_STEP
        self.step()

    def text(self, text: str) -> str:
        """Return *text*, which is counted."""
        if len(text) > CHARACTERS:
            raise LimitExceeded(f"a text of more than {CHARACTERS} characters")
        self.characters -= len(text)
        if self.characters < 0:
            raise LimitExceeded("it expands to far more text than any robot has")
        return text

    def items(self, values: Iterable[Any]) -> Iterator[Any]:
        """Yield the items of *values*, each a step."""
        for value in values:
            self.step()
            yield value

    def listed(self, values: Iterable[Any], most: int = ITEMS) -> list[Any]:
        """Return *values* as a list, unless they are more than *most*."""
        if isinstance(values, Sized) and len(values) > most:
            raise Refused("a huge list")
        found: list[Any] = []
        for value in self.items(values):
            found.append(value)
            if len(found) > most:
                raise Refused("a huge list")
        return found

    def result(self, value: Any) -> Any:
        """Return *value*, if it is not huge."""
        if isinstance(value, str):
            return self.text(value)
        if isinstance(value, int) and value.bit_length() > 2 * NUMBER.bit_length():
            raise Refused("a huge number")
        if isinstance(value, Sized):
            if len(value) > ITEMS:
                raise Refused("a huge range" if isinstance(value, range) else "a huge list")
            self.charge(weight(value))
        return value

    def call(
        self,
        function: Callable[..., Any],
        positional: Sequence[Any],
        keywords: Mapping[str, Any],
    ) -> Any:
        """Return what *function* makes of its arguments, which are charged first.

        Functions among the arguments are charged whenever they are called.
        """
        if function in UNCOUNTED:
            self.step()
            return function(*positional)
        for each in (*positional, *keywords.values()):
            self.charge(weight(each))
        if function in FILLED:
            positional = [
                each if isinstance(each, Mapping) else self.listed(each, ENTRIES)
                for each in positional
            ]
        named = {name: self._counted(each) for name, each in keywords.items()}
        return self.result(function(*map(self._counted, positional), **named))

    def _counted(self, value: Any) -> Any:
        if not callable(value):
            return value
        return lambda *given: self.call(value, given, {})

    def method(self, owner: Any, name: str) -> Callable[..., Any]:
        """Return the method *name* of *owner*, which is charged for what it looks through."""

        def call(*values: Any) -> Any:
            self.charge(weight(owner))
            if name == "join":
                return self._join(owner, self.listed(values[0]))
            if name == "replace" and len(values) > 1:
                size = (len(owner) + 1) * (len(str(values[1])) + 1)
                if size > CHARACTERS:
                    raise Refused("a huge text")
            if isinstance(owner, AbstractSet):
                values = tuple(self.listed(each, ENTRIES) for each in values)
            return getattr(owner, name)(*values)

        return call

    def _join(self, owner: str, parts: list[Any]) -> str:
        if sum(len(owner) + len(part) for part in parts) > CHARACTERS:
            raise Refused("a huge text")
        return owner.join(parts)

    def check_operation(self, kind: ast.operator, left: Any, right: Any) -> None:
        """Charge an operator for its operands; raise Refused if its result would be huge."""
        whole = isinstance(left, int) and isinstance(right, int)
        if isinstance(kind, ast.Pow) and whole and right > 0:
            if abs(left).bit_length() * right > NUMBER.bit_length():
                raise Refused("a huge power")
        elif isinstance(kind, ast.LShift):
            if whole and left.bit_length() + right > NUMBER.bit_length():
                raise Refused("a huge number")
        elif isinstance(kind, ast.Mult):
            self._check_product(left, right)
        elif isinstance(kind, ast.Add):
            self.check_addition(left, right)
        elif isinstance(kind, ast.Mod) and isinstance(left, str | bytes):
            self._check_format(left, right)
        elif isinstance(left, AbstractSet) or isinstance(right, AbstractSet):
            self.charge(weight(left) + weight(right))

    def check_comparison(self, left: Any, right: Any) -> None:
        """Charge a comparison of two values, which may follow both to the end."""
        if isinstance(left, Sized) or isinstance(right, Sized):
            self.charge(weight(left) + weight(right))

    def check_addition(self, left: Any, right: Any) -> None:
        """Raise Refused if the sum would be huge."""
        if isinstance(left, Sized) and isinstance(right, Sized):
            length = len(left) + len(right)
            if length > (CHARACTERS if isinstance(left, str) else ITEMS):
                raise Refused("a huge sum")
            self.charge(length)

    def _check_product(self, left: Any, right: Any) -> None:
        for one, other in ((left, right), (right, left)):
            if isinstance(one, int) and isinstance(other, Sized):
                length = max(0, one * len(other))
                if length > (CHARACTERS if isinstance(other, str) else ITEMS):
                    raise Refused("a huge product")
                self.charge(length)
        if isinstance(left, int) and isinstance(right, int):
            bits = left.bit_length() + right.bit_length()
            if bits > 2 * NUMBER.bit_length():
                raise Refused("a huge number")

    def _check_format(self, template: Any, values: Any) -> None:
        if not isinstance(template, str) or "*" in template:
            raise Refused("a format of variable width")
        digits = "".join(c if c.isdigit() else " " for c in template).split()
        if any(len(each) > 2 for each in digits):  # noqa: PLR2004
            raise Refused("a format of more than 99 characters")
        # A name of a table can be asked for again and again, an item of a tuple only once.
        times = 1 if isinstance(values, tuple) else template.count("%")
        size = len(template) + 100 * template.count("%") + times * weight(values)
        if size > CHARACTERS:
            raise Refused("a huge text")
        self.charge(size)


def weight(value: Any, limit: int = CHARACTERS) -> int:
    """Return the size of *value* in items and characters, with all that it shares written out.

    Raises Refused if that is more than *limit*.
    """
    if isinstance(value, float | bool | None):
        size = 1
    elif isinstance(value, int):
        size = 1 + value.bit_length() // 3
    elif isinstance(value, str | range):
        size = 1 + len(value)
    elif isinstance(value, list | tuple | set | frozenset | KeysView | ValuesView):
        size = 1 + _parts(value, limit)
    elif isinstance(value, Mapping):
        size = 1 + _parts((*value.keys(), *value.values()), limit)
    else:
        size = 1
    if size > limit:
        raise Refused("a huge range" if isinstance(value, range) else "a huge list")
    return size


def _parts(values: Iterable[Any], limit: int) -> int:
    size = 0
    for each in values:
        size += weight(each, limit - size)
    return size
