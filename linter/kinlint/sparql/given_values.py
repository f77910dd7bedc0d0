"""Gives a SELECT the values that one of its variables may have."""

from __future__ import annotations

from collections.abc import Iterable

import pyoxigraph as ox

from kinlint.terms import Term, iri_value, is_iri


def is_nameable(term: Term) -> bool:
    """Tell whether a query can name *term*: an IRI by RFC 3987 (stores take others too)."""
    if not is_iri(term):
        return False
    try:
        ox.NamedNode(iri_value(term))
    except ValueError:
        return False
    return True


def with_values(select: str, variable: str, values: Iterable[Term]) -> str:
    """Return *select*, whose first brace opens its group, where *variable* has one of *values*."""
    head, brace, group = select.partition("{")
    return f"{head}{brace} VALUES {variable} {{ {' '.join(sorted(values))} }} {group}"
