"""Asks Oxigraph itself whether it can run what was compiled."""

from __future__ import annotations

from collections.abc import Sequence

import pyoxigraph as ox

from kinlint.engine.compiler.deferral import Deferred


def try_out(text: str) -> None:
    """Raise `Deferred` if Oxigraph refuses *text*, for example for a function it lacks."""
    try:
        list(ox.Store().query(text))  # type: ignore[arg-type]
    except (RuntimeError, SyntaxError) as error:
        raise Deferred(f"Oxigraph cannot run this: {error}") from error


def try_regex(pattern: str, flags: str) -> None:
    """Raise `Deferred` if Oxigraph cannot apply a regular expression given as SPARQL strings.

    Its expressions have neither look-around nor back-references, and one that it cannot read
    is an error in every row, not of the query.
    """
    query = f"SELECT (REGEX('', {pattern}, {flags}) AS ?x) WHERE {{}}"
    (row,) = ox.Store().query(query)  # type: ignore[misc]
    if row[0] is None:
        raise Deferred(f"Oxigraph cannot read the regular expression {pattern}")


def try_call(name: str, arguments: Sequence[str]) -> None:
    """`try_regex` for a call of REGEX or REPLACE whose pattern is a constant."""
    pattern = _argument(arguments, 1)
    flags = _argument(arguments, 2 if name.upper() == "REGEX" else 3)
    if pattern is not None:
        try_regex(pattern, flags or "''")


def _argument(arguments: Sequence[str], wanted: int) -> str | None:
    """The argument at *wanted*, if it is there and a plain string."""
    depth = position = 0
    for at, word in enumerate(arguments):
        depth += (word == "(") - (word == ")")
        if depth < 0:
            return None
        if word == "," and not depth:
            position += 1
        elif position == wanted:
            plain = word[0] in "\"'" and arguments[at + 1 : at + 2] in (
                [","],
                [")"],
                (",",),
                (")",),
            )
            return word if plain else None
    return None
