"""Conditions about literals, in terms of what Oxigraph's store does with them.

A store keeps well-formed numbers as values and forgets how they were spelled; derived integer
types become `xsd:integer`. Ill-formed literals it keeps as they are. Conditions are never
errors: what SPARQL cannot tell is false.
"""

from __future__ import annotations

from kinlint.engine.compiler.deferral import Deferred
from kinlint.terms import XSD, Term, is_literal, literal_datatype

_FORGOTTEN = {
    f"{XSD}{name}"
    for name in (
        *("byte", "short", "int", "long"),
        *("unsignedByte", "unsignedShort", "unsignedInt", "unsignedLong"),
        *("positiveInteger", "negativeInteger", "nonPositiveInteger", "nonNegativeInteger"),
        "dateTimeStamp",
    )
}
_NUMBER = r"([0-9]+(\\.[0-9]*)?|\\.[0-9]+)"
_FORMS = {
    "boolean": "(true|false|1|0)",
    "integer": "[+-]?[0-9]+",
    "decimal": rf"[+-]?{_NUMBER}",
    "double": rf"([+-]?{_NUMBER}([eE][+-]?[0-9]+)?|[+-]?INF|NaN)",
    "float": rf"([+-]?{_NUMBER}([eE][+-]?[0-9]+)?|[+-]?INF|NaN)",
    "hexBinary": "([0-9a-fA-F]{2})*",
}
_CASTS = {
    *("date", "dateTime", "time", "gYear", "gYearMonth", "gMonth", "gMonthDay", "gDay"),
    *("duration", "dayTimeDuration", "yearMonthDuration"),
}
_NUMERIC = ", ".join(f"<{XSD}{name}>" for name in ("integer", "decimal", "double", "float"))


def has_datatype(variable: str, datatype: Term) -> str:
    """Return the condition that *variable* is a well-formed literal of *datatype*."""
    iri = datatype[1:-1]
    if iri in _FORGOTTEN:
        raise Deferred(f"Oxigraph does not keep {datatype} apart from its base type")
    parts = [f"sameTerm(DATATYPE({variable}), {datatype})"]
    name = iri.removeprefix(XSD)
    if name in _FORMS:
        parts.append(f'REGEX(STR({variable}), "^{_FORMS[name]}$")')
    elif name in _CASTS:
        parts.append(f'STR({datatype}(STR({variable}))) != ""')
    return f"COALESCE({' && '.join(parts)}, false)"


def comparison(left: str, operator: str, right: str) -> str:
    """Return the condition that `left operator right` holds: SPARQL's, where that is defined.

    Oxigraph compares neither decimals with more than 18 fraction digits nor booleans.
    """

    def both(kind: str, cast: str) -> str:
        typed = " && ".join(f"DATATYPE({side}) IN ({kind})" for side in (left, right))
        sides = f" {operator} ".join(cast.format(side) for side in (left, right))
        return f"IF({typed}, {sides}, false)"

    numbers = both(_NUMERIC, f"<{XSD}double>(STR({{}}))")
    booleans = both(f"<{XSD}boolean>", f"<{XSD}integer>({{}})")
    return f"COALESCE({left} {operator} {right}, {numbers} || {booleans}, false)"


def constant(term: Term) -> Term:
    """Return *term*, if a query can name it and a store keeps it apart from others."""
    if term.startswith("_:"):
        raise Deferred("a blank node of the shapes graph is a parameter")
    if is_literal(term) and literal_datatype(term) in _FORGOTTEN:
        raise Deferred(f"Oxigraph does not keep {term} apart from an xsd:integer")
    return term
