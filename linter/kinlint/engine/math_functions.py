"""The mathematical functions of XPath 3.1 (F&O 4.8), which SPARQL lacks."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

import pyoxigraph as ox

from kinlint.engine.store import Function
from kinlint.terms import XSD

NAMESPACE = "http://www.w3.org/2005/xpath-functions/math#"
DOUBLE = ox.NamedNode(f"{XSD}double")


def _function(compute: Callable[..., float]) -> Function:
    def function(*terms: ox.NamedNode | ox.BlankNode | ox.Literal | ox.Triple) -> ox.Literal | None:
        try:
            value = compute(*(float(term.value) for term in terms))  # type: ignore[union-attr]
        except (AttributeError, ArithmeticError, TypeError, ValueError):
            return None
        return ox.Literal(repr(value), datatype=DOUBLE) if math.isfinite(value) else None

    return function


COMPUTED: Mapping[str, Callable[..., float]] = {
    "pi": lambda: math.pi,
    "exp": math.exp,
    "exp10": lambda power: math.pow(10.0, power),
    "log": math.log,
    "log10": math.log10,
    "pow": math.pow,
    "sqrt": math.sqrt,
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "asin": math.asin,
    "acos": math.acos,
    "atan": math.atan,
    "atan2": math.atan2,
}
MATH: Mapping[ox.NamedNode, Function] = {
    ox.NamedNode(f"{NAMESPACE}{name}"): _function(compute) for name, compute in COMPUTED.items()
}
"""The functions by name, of doubles and radians; undefined where the result is no number."""
