"""Symbols of xacro expressions besides properties: functions, `math` and `xacro`."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from kinlint.formats.xacro.expansion_limits import NUMBER, Limits, Refused, weight
from kinlint.formats.xacro.expression import Entries, Members
from kinlint.light_dataclasses import dataclass

KINDS = (int, float, str, bool, list, dict, tuple, set, frozenset, complex, type(None))
SMALL = 1000
"""The greatest argument of functions whose values grow without measure."""
DIGITS = 400
PLAIN: Mapping[str, Any] = {
    each.__name__: each
    for each in (dict, len, str, float, int, bool, min, max)  # as long as Python exists
}
NAMED: Mapping[str, Any] = {
    each.__name__: each
    for each in (
        *(abs, all, any, complex, divmod, enumerate, frozenset, hash, isinstance, issubclass),
        *(ord, reversed, slice, zip),
    )
}
GROWING = ("comb", "perm", "factorial")


class Namespace(Members):
    """Functions under one name, such as `math`."""

    def __init__(self, name: str, values: Mapping[str, Any]) -> None:
        self._name = name
        self._values = values

    def member(self, name: str) -> Any:
        """Return the member *name*; raises NameError if there is none."""
        try:
            return self._values[name]
        except KeyError:
            raise NameError(f"name '{self._name}.{name}' is not defined") from None


def symbols(bounds: Limits, own: Mapping[str, Any]) -> dict[str, Any]:
    """Return the symbols of every expression.

    *own* are those of xacro itself, such as `load_yaml`.
    """
    plain = {**PLAIN, **_Python(bounds).values}
    mathematics = _mathematics(bounds)
    direct = {name: plain[name] for name in (*PLAIN, "list", "map", "round", "sorted", "range")}
    return {
        **mathematics,
        **direct,
        **{name: own[name] for name in ("load_yaml", "abs_filename", "dotify")},
        "math": Namespace("math", mathematics),
        "python": Namespace("python", {**NAMED, **plain}),
        "xacro": Namespace("xacro", own),
    }


@dataclass(frozen=True)
class _Python:
    """Functions of Python that could be asked for too much."""

    bounds: Limits
    """Limits to the sizes of values."""

    @property
    def values(self) -> Mapping[str, Any]:
        """All of them, and those that need no bounds, by name."""
        return {
            "filter": self._kept,
            "list": list,
            "map": self._mapped,
            "range": range,
            "repr": repr,
            "round": self._nearest,
            "set": set,
            "sorted": self._ordered,
            "sum": self._sum,
            "tuple": tuple,
            "type": self._kind,
        }

    def _sum(self, items: Iterable[Any], start: Any = 0) -> Any:
        total = start
        for item in self.bounds.items(items):
            self.bounds.check_addition(total, item)
            total = total + item
        return total

    def _nearest(self, number: Any, digits: int | None = None) -> Any:
        if digits is None:
            return round(number)
        if abs(digits) > DIGITS:
            raise Refused("rounding to so many digits")
        return round(number, digits)

    def _kind(self, value: Any) -> type:
        if not isinstance(value, KINDS):
            raise Refused("the type of this")
        return type(value)

    def _ordered(self, items: Iterable[Any], **how: Any) -> list[Any]:
        found = self.bounds.listed(items)
        self.bounds.charge(weight(found) * len(found).bit_length())
        return sorted(found, **how)

    def _mapped(self, function: Callable[..., Any], *items: Iterable[Any]) -> list[Any]:
        return [function(*each) for each in zip(*map(self.bounds.items, items), strict=False)]

    def _kept(self, function: Callable[..., Any] | None, items: Iterable[Any]) -> list[Any]:
        return list(filter(function, self.bounds.items(items)))


def _mathematics(bounds: Limits) -> dict[str, Any]:
    values = {name: value for name, value in vars(math).items() if not name.startswith("_")}
    for name in GROWING:
        values[name] = _small(values[name])

    def product(items: Iterable[Any], *, start: Any = 1) -> Any:
        total = start
        for item in bounds.items(items):
            if not isinstance(item, int | float):
                raise TypeError("math.prod multiplies numbers")
            total = bounds.result(total * item)
        return total

    def multiple(*numbers: int) -> int:
        if sum(number.bit_length() for number in numbers) > NUMBER.bit_length():
            raise Refused("a huge number")
        return math.lcm(*numbers)

    return {**values, "prod": product, "lcm": multiple}


def _small(function: Callable[..., Any]) -> Callable[..., Any]:
    def call(*arguments: int) -> Any:
        if any(each > SMALL for each in arguments):
            raise Refused(f"math.{function.__name__} of more than {SMALL}")
        return function(*arguments)

    return call


def tokenize(text: str, separators: str = ",; ", skip_empty: bool = True) -> list[str]:  # noqa: FBT001, FBT002
    """Return the parts of *text* between *separators*, which are single characters."""
    parts = re.split(f"[{re.escape(separators)}]", text) if separators else [text]
    return [part for part in parts if part] if skip_empty else parts


def dotted(value: Any) -> Any:
    """Return *value* with tables whose entries may be named with a dot, at every depth."""
    if isinstance(value, dict):
        return Entries({key: dotted(each) for key, each in value.items()})
    return [dotted(each) for each in value] if isinstance(value, list) else value
