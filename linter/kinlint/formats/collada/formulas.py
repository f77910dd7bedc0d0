"""Formulas of COLLADA, in MathML, that are linear in the position of one joint."""

from __future__ import annotations

from kinlint.formats.collada.collada_elements import ColladaElement
from kinlint.light_dataclasses import dataclass

MOST_DEEP = 50
"""Greatest depth of a formula."""


@dataclass(frozen=True)
class Linear:
    """Multiple of a symbol, and an offset."""

    symbol: ColladaElement | None
    """The symbol; None for a constant."""
    factor: float
    """Factor of the symbol."""
    offset: float
    """Number that is added."""

    def __add__(self, other: Linear) -> Linear | None:
        if self.symbol and other.symbol and self.symbol.text() != other.symbol.text():
            return None
        symbol = self.symbol or other.symbol
        return Linear(symbol, self.factor + other.factor, self.offset + other.offset)

    def times(self, other: Linear) -> Linear | None:
        """Return the product; None if it is not linear."""
        if self.symbol and other.symbol:
            return None
        number, rest = (self, other) if self.symbol is None else (other, self)
        return Linear(rest.symbol, rest.factor * number.offset, rest.offset * number.offset)


def linear(math: ColladaElement) -> Linear | None:
    """Return what the element *math* computes; None if that is not linear in one symbol."""
    return _value(math.children[0], 0) if len(math.children) == 1 else None


def _value(element: ColladaElement, depth: int) -> Linear | None:
    if element.tag == "csymbol":
        return Linear(element, 1.0, 0.0)
    if element.tag == "cn":
        return _constant(element)
    if element.tag != "apply" or not element.children or depth > MOST_DEEP:
        return None
    operator, *operands = element.children
    if not operands:
        return _value(operator, depth + 1)
    values = [_value(each, depth + 1) for each in operands]
    known = [each for each in values if each is not None]
    if len(known) < len(values) or not known:
        return None
    return _applied(operator.tag, known)


def _applied(operator: str, values: list[Linear]) -> Linear | None:
    first, *others = values
    result: Linear | None = first
    if operator in ("plus", "times"):
        for each in others:
            result = result and (result + each if operator == "plus" else result.times(each))
        return result
    if operator == "minus" and len(others) <= 1:
        negative = Linear(values[-1].symbol, -values[-1].factor, -values[-1].offset)
        return first + negative if others else negative
    if operator == "divide" and len(others) == 1:
        (divisor,) = others
        if divisor.symbol is None and divisor.offset:
            return first.times(Linear(None, 0.0, 1 / divisor.offset))
    return None


def _constant(element: ColladaElement) -> Linear | None:
    try:
        return Linear(None, 0.0, float(element.text()))
    except ValueError:
        return None
