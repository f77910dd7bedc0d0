"""Checks of a query that a user asks: the terms, the grammar, and what it may look at."""

from __future__ import annotations

from kinlint.catalogue.repair_file import prefixes
from kinlint.catalogue.term_checks import query_faults
from kinlint.engine.compiler.oxigraph_probe import refused_query
from kinlint.engine.compiler.query_permissions import forbidden_in
from kinlint.errors import UsageError
from kinlint.sparql.tokens import NotSparql

KINDS = ("SELECT", "ASK", "CONSTRUCT")
"""The kinds of queries that are answered."""


def checked_query(text: str) -> str:
    """Return the query *text* with the prefixes of rules declared. Raises `UsageError`."""
    known = prefixes()
    try:
        fault = forbidden_in(text, known, KINDS)
        if fault:
            raise UsageError(f"query: {fault}")
        for found in query_faults(text, known):
            raise UsageError(f"query:{_line(text, found.offset)}: {found.text}")
        whole = "".join(f"PREFIX {name}: <{space}> " for name, space in known.items()) + text
        if refused := refused_query(whole, text, known):
            raise refused
    except NotSparql as error:
        raise UsageError(f"query:{_line(text, error.offset(text))}: {error}") from None
    return whole


def _line(text: str, offset: int) -> int:
    return text.count("\n", 0, offset) + 1
