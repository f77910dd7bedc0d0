"""rdflib's SPARQL expressions as the standard has them: what cannot be computed is an error."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rdflib import Literal
from rdflib.plugins.sparql import operators
from rdflib.plugins.sparql.parserutils import value
from rdflib.plugins.sparql.sparql import SPARQLError, SPARQLTypeError

ORDER = frozenset({"<", "<=", ">", ">="})
ROUNDING = frozenset({"Builtin_ROUND", "Builtin_CEIL", "Builtin_FLOOR"})


def numeric(original: Callable[[Any], Any], term: Any) -> Any:
    """Return the number that *term* is; "0,4" is none, whatever datatype is claimed for it.

    rdflib takes every literal of a numeric datatype for a number, and fails when it counts with it.
    """
    number = original(term)
    if isinstance(number, Literal):
        raise SPARQLTypeError(f"{term!r} is not in the lexical space of its datatype")
    return number


def evaluated(original: Callable[..., Any], expression: Any, context: Any) -> Any:
    """Return the value of *expression*, or the error it is, which SPARQL passes on as a value.

    rdflib lets other exceptions than its own escape. It cannot round what has more digits than its
    decimals, or is infinite; such numbers have no fraction.
    """
    try:
        if expression.name == "RelationalExpression" and expression.get("op") in ORDER:
            _comparable(*(value(context, expression.get(side)) for side in ("expr", "other")))
        return original(expression, context)
    except SPARQLError as error:
        return error
    except (ArithmeticError, TypeError, ValueError) as error:
        if expression.name in ROUNDING:
            return value(context, expression.get("arg"))
        return SPARQLError(str(error))


def _comparable(*terms: Any) -> None:
    """Raise `SPARQLError` if one of *terms* is a number and another none, or not a number.

    rdflib puts numbers and texts in some order, and NaN before everything.
    """
    numbers = [_is_number(term) for term in terms]
    wrong = any(isinstance(term, Literal) and term.ill_typed for term in terms)
    if wrong or (any(numbers) and not all(numbers)):
        raise SPARQLTypeError("a number is neither less nor greater than what is none")


def _is_number(term: Any) -> bool:
    try:
        number = operators.numeric(term)
    except SPARQLError:
        return False
    return bool(number == number)  # noqa: PLR0124  NaN is not
