"""Values of attributes and texts of elements: a string, a number, several of them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from math import inf, isfinite
from typing import TypeAlias

from kinlint.light_dataclasses import dataclass
from kinlint.terms import XSD, Term, literal

Value: TypeAlias = Term | tuple[Term, ...] | None
"""Literal, one literal for each component, or None for an invalid value."""

UNEXPANDED = re.compile(r"\$[{(]")
"""Begins an expression or a substitution of xacro."""

NUMBER = re.compile(r"[-+]?(?:\d++(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?", re.ASCII)
DECIMAL_COMMA = re.compile(r"[-+]?\d+,\d+(?:[eE][-+]?\d+)?,?", re.ASCII)
INTEGER = re.compile(r"([-+]?\d+)(?:[uU]|\.0*)?", re.ASCII)
"""A whole number, as C++ writes one without a sign, or with nothing behind the point."""
HEXADECIMAL = re.compile(r"[-+]?0[xX][0-9a-fA-F]{1,64}")
INFINITE = {"inf": "INF", "+inf": "INF", "-inf": "-INF"}
TRUTHS = {"true": "true", "false": "false", "1": "1", "0": "0"}
SPACE = " \t\r\n"
PART = re.compile(r"[^ \t\r\n\f\v]+")
"""A part of a vector; other space of Unicode separates nothing for any parser."""

MOST_KEPT = 100_000
LONGEST_KEPT = 200


class ValueReader(dict[str, Value]):
    """Values by how they are written, each made out once; subclasses know one kind of value."""

    expected = "text"

    def __missing__(self, written: str) -> Value:
        value = self.read(written)
        if len(written) <= LONGEST_KEPT:
            if len(self) >= MOST_KEPT:
                self.clear()
            self[written] = value
        return value

    def read(self, written: str) -> Value:
        """Return the value that *written* stands for; None if it stands for none."""
        return None if "$" in written and UNEXPANDED.search(written) else literal(written)

    def reason(self, written: str) -> str:
        """Say why *written* stands for no value."""
        return f"not {self.expected}" if written.strip(SPACE) else "empty"


class NumberReader(ValueReader):
    """Numbers: as many as one of `counts` says, or any if it is empty."""

    def __init__(self, counts: tuple[int, ...], form: Form, *, vector: bool) -> None:
        super().__init__()
        self.counts, self.vector, self.infinite = counts, vector, form.infinite
        self.least, self.greatest = form.least, form.greatest
        if not vector:
            self.expected = "number"
            if isfinite(self.least):
                self.expected += f" from {self.least:g}"
            if isfinite(self.greatest):
                self.expected += f" to {self.greatest:g}"
        else:
            many = " or ".join(map(str, counts))
            self.expected = f"{many} numbers" if many else "numbers"

    def read(self, written: str) -> Value:
        """Return the numbers in *written*, spelled as there."""
        parts = PART.findall(written)
        if (len(parts) not in self.counts) if self.counts else not parts:
            return None
        tokens = tuple(token for part in parts if (token := self._number(part)) is not None)
        if len(tokens) < len(parts):
            return None
        return tokens if self.vector else tokens[0]

    def reason(self, written: str) -> str:
        """Return the first part of *written* that is no number, or how many there are."""
        parts = PART.findall(written)
        wrong = next((part for part in parts if self._number(part) is None), None)
        if not parts:
            return "empty"
        if wrong is None:
            return f"{len(parts)} numbers"
        if DECIMAL_COMMA.fullmatch(wrong):
            return f"decimal comma in {wrong}"
        if NUMBER.fullmatch(wrong):
            fault = "out of range" if isfinite(float(wrong)) else "too large for a double"
            return f"{wrong} is {fault}"
        if wrong.lower() in INFINITE:
            return f"{wrong} is not finite"
        return f"'{wrong}' is not a number"

    def _number(self, part: str) -> Term | None:
        if NUMBER.fullmatch(part):
            value = float(part)
            if isfinite(value) and self.least <= value <= self.greatest:
                return f'"{part}"^^<{XSD}double>'
        elif self.infinite and part.lower() in INFINITE:
            if not self.least <= float(part) <= self.greatest:
                return None
            return f'"{INFINITE[part.lower()]}"^^<{XSD}double>'
        return None


class IntegerReader(ValueReader):
    """Whole numbers."""

    expected = "a whole number"

    def read(self, written: str) -> Value:
        """Return the number in *written*, spelled as there."""
        part = written.strip(SPACE)
        if HEXADECIMAL.fullmatch(part):
            part = str(int(part, 16))
        match = INTEGER.fullmatch(part)
        return f'"{match[1]}"^^<{XSD}integer>' if match else None


class BooleanReader(ValueReader):
    """True or false, in words or as a digit."""

    expected = "true or false"

    def read(self, written: str) -> Value:
        """Return the truth value of *written*, in any case."""
        truth = TRUTHS.get(written.strip(SPACE).lower())
        return None if truth is None else f'"{truth}"^^<{XSD}boolean>'


@dataclass(frozen=True, slots=True)
class Form:
    """Form of a value in a schema: names of kinds, of which vectors may be several."""

    kinds: tuple[str, ...]
    """Names of kinds; several are alternatives."""
    infinite: bool = False
    """True if numbers may be infinite."""
    least: float = -inf
    """The least number."""
    greatest: float = inf
    """The greatest number."""


@cache
def value_reader(form: Form) -> ValueReader:
    """Return the reader of values of *form*; cached, since files repeat each other."""
    kinds = form.kinds
    if kinds[0] in _PLAIN:
        return _PLAIN[kinds[0]]()
    if kinds[0] == "number":
        return NumberReader((1,), form, vector=False)
    counts = tuple(sorted(int(kind.removeprefix("vector")) for kind in kinds if kind != "vectors"))
    return NumberReader(counts, form, vector=True)


_PLAIN: Mapping[str, type[ValueReader]] = {
    "text": ValueReader,
    "integer": IntegerReader,
    "boolean": BooleanReader,
}
