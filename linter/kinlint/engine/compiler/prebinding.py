"""Restrictions of SHACL on queries with pre-bound variables: SHACL 5.2.1, appendix A."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from kinlint.sparql.ast import Bind, Clause, Element, Group, Select, Values, walk
from kinlint.sparql.variables import projection, words

OPTIONAL = ("?currentShape", "?shapesGraph")
"""Variables that SHACL lets an engine pre-bind, and sub-selects leave out."""


def forbidden(select: Select, prebound: tuple[str, ...]) -> str | None:
    """Return the fault of *select* where the variables *prebound* have values, or None."""
    return next(_faults(select, prebound), None)


def _faults(select: Select, prebound: tuple[str, ...]) -> Iterator[str]:
    for part in walk(select):
        yield from _part_faults(part, prebound)
        if isinstance(part, Select) and part is not select:
            shown = projection(part)
            yield from (f"a sub-select lacks {name}" for name in prebound if name not in shown)
    if "VALUES" in [word.upper() for word in select.tail if isinstance(word, str)]:
        yield "VALUES is not allowed in SHACL"
    for word, variable in pairwise(words(select)):
        if word.upper() == "AS" and variable in (*prebound, *OPTIONAL):
            yield f"AS gives a value to {variable}, which has one already"
    if str(select.head[0]).upper() == "SELECT" and "?this" not in projection(select):
        yield "the query does not return $this"


def _part_faults(part: Group | Element, prebound: tuple[str, ...]) -> Iterator[str]:
    match part:
        case Clause((word, *_), _) if word.upper() in ("MINUS", "SERVICE"):
            yield f"{word.upper()} is not allowed in SHACL"
        case Values():
            yield "VALUES is not allowed in SHACL"
        case Bind(_, variable) if variable in (*prebound, *OPTIONAL):
            yield f"BIND gives a value to {variable}, which has one already"
        case _:
            pass
