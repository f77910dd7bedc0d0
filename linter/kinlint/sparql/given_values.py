"""Gives a SELECT the values that one of its variables may have."""

from __future__ import annotations

import re
from collections.abc import Iterable

from kinlint.terms import Term

_NAMEABLE = re.compile(r"<[^\x00-\x20<>\"{}|^`\\\ud800-\udfff]*>")


def is_nameable(term: Term) -> bool:
    """Tell whether a query can name *term*: an IRI, and none of those that only a store takes."""
    return _NAMEABLE.fullmatch(term) is not None


def with_values(select: str, variable: str, values: Iterable[Term]) -> str:
    """Return *select*, whose first brace opens its group, where *variable* has one of *values*."""
    head, brace, group = select.partition("{")
    return f"{head}{brace} VALUES {variable} {{ {' '.join(sorted(values))} }} {group}"
