"""Limits of an expansion: far more than any robot needs, far less than what hangs."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from time import monotonic
from typing import Any

NUMBER = 1 << 256
"""Whole numbers beyond this are refused."""
CHARACTERS = 1 << 20
ITEMS = 100_000
"""The size of one text, and of one list."""
CONTAINERS = (list, tuple, dict, set, frozenset)


class Refused(Exception):
    """An expression asks for what no robot description needs."""


class LimitExceeded(Exception):
    """An expansion goes beyond what any robot needs."""


@dataclass
class Limits:
    """Remaining allowances. Counts decide, so that results are the same everywhere.

    The clock covers cases that no count foresees.
    """

    nodes: int = 150_000
    steps: int = 1_000_000
    characters: int = 1 << 25
    seconds: float = 20.0

    def __post_init__(self) -> None:
        self._until = monotonic() + self.seconds

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
        if not self.steps & 0xFFF and monotonic() > self._until:
            raise LimitExceeded(f"expanding it takes longer than {self.seconds:g} seconds")

    def text(self, text: str) -> str:
        """Return *text*, which is counted."""
        if len(text) > CHARACTERS:
            raise LimitExceeded(f"a text of more than {CHARACTERS} characters")
        self.characters -= len(text)
        if self.characters < 0:
            raise LimitExceeded("it expands to far more text than any robot has")
        return text

    def check_operation(self, kind: ast.operator, left: Any, right: Any) -> None:
        """Raise Refused if the result of an operator would be huge."""
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
            self._check_format(left)

    def check_addition(self, left: Any, right: Any) -> None:
        """Raise Refused if the sum would be huge."""
        if hasattr(left, "__len__") and hasattr(right, "__len__"):
            if len(left) + len(right) > (CHARACTERS if isinstance(left, str) else ITEMS):
                raise Refused("a huge sum")
            self.steps -= (len(left) + len(right)) >> 4

    def _check_product(self, left: Any, right: Any) -> None:
        for one, other in ((left, right), (right, left)):
            if isinstance(one, int) and hasattr(other, "__len__"):
                if one * len(other) > (CHARACTERS if isinstance(other, str) else ITEMS):
                    raise Refused("a huge product")
                self.steps -= max(0, one * len(other)) >> 4
        if isinstance(left, int) and isinstance(right, int):
            bits = left.bit_length() + right.bit_length()
            if bits > 2 * NUMBER.bit_length():
                raise Refused("a huge number")

    def _check_format(self, template: Any) -> None:
        if not isinstance(template, str) or "*" in template:
            raise Refused("a format of variable width")
        digits = "".join(c if c.isdigit() else " " for c in template).split()
        if any(len(each) > 2 for each in digits):  # noqa: PLR2004
            raise Refused("a format of more than 99 characters")

    def items(self, values: Any) -> Iterator[Any]:
        """Yield the items of *values*, each a step."""
        for value in values:
            self.step()
            yield value

    def listed(self, values: Iterable[Any]) -> list[Any]:
        """Return *values* as a list, unless it is a huge one."""
        if isinstance(values, range) and len(values) > ITEMS:
            raise Refused("a huge range")
        return list(self.items(values))

    def result(self, value: Any) -> Any:
        """Return *value*, if it is not huge."""
        if isinstance(value, str):
            return self.text(value)
        if isinstance(value, int) and value.bit_length() > 2 * NUMBER.bit_length():
            raise Refused("a huge number")
        if isinstance(value, range) and len(value) > ITEMS:
            raise Refused("a huge range")
        if isinstance(value, CONTAINERS):
            self.steps -= self._weight(value, CHARACTERS) >> 4
        return value

    def _weight(self, value: Any, limit: int) -> int:
        """Return the size of *value* with all that it shares written out; at most *limit*."""
        if isinstance(value, str):
            weight = 1 + len(value)
        elif isinstance(value, CONTAINERS):
            weight = 1
            parts = (*value, *value.values()) if isinstance(value, dict) else value
            for part in parts:
                weight += self._weight(part, limit - weight)
        else:
            weight = 1
        if weight > limit:
            raise Refused("a huge list")
        return weight

    def method(self, owner: Any, method: Callable[..., Any]) -> Callable[..., Any]:
        """Wrap *method* of *owner* to count its steps, and to refuse to blow up a text."""

        def call(*values: Any) -> Any:
            if hasattr(owner, "__len__"):
                self.steps -= len(owner) >> 4
            self.step()
            name = method.__name__
            if name == "replace" and len(values) > 1:
                size = (len(owner) + 1) * (len(str(values[1])) + 1)
                if size > CHARACTERS:
                    raise Refused("a huge text")
            if name == "join":
                return self._join(owner, self.listed(values[0]))
            return method(*values)

        return call

    def _join(self, owner: str, parts: list[Any]) -> str:
        if sum(len(owner) + len(part) for part in parts) > CHARACTERS:
            raise Refused("a huge text")
        return owner.join(parts)
