"""Asks Oxigraph itself whether it can run what was compiled."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence

import pyoxigraph as ox

from kinlint.engine.compiler.deferral import Deferred
from kinlint.sparql.tokens import NotSparql, split


def refused_query(text: str, written: str, prefixes: Mapping[str, str]) -> NotSparql | None:
    """Return why the query *text* is no SPARQL for Oxigraph; None if it is.

    The place is that in *written*, which is *text* as its author wrote it, with *prefixes*.
    """
    return _refused(lambda store, each: store.query(each), text, written, prefixes)


def refused_update(text: str, written: str, prefixes: Mapping[str, str]) -> NotSparql | None:
    """Return why the update *text* is no SPARQL for Oxigraph, as `refused_query` does."""
    return _refused(lambda store, each: store.update(each), text, written, prefixes)


def _refused(
    run: Callable[[ox.Store, str], object], text: str, written: str, prefixes: Mapping[str, str]
) -> NotSparql | None:
    try:
        run(ox.Store(), text)
    except SyntaxError:
        header = "".join(f"PREFIX {name}: <{iri}> " for name, iri in prefixes.items())
        try:
            run(ox.Store(), header + written)
        except SyntaxError as error:
            return _near(header + written, len(header), str(error))
        return NotSparql("not SPARQL 1.1")
    except RuntimeError:
        return None  # It is SPARQL, with a function that is the author's own.
    return None


def _near(text: str, header: int, error: str) -> NotSparql:
    """Return *error*, which begins with the line and column in *text*, less its first *header*."""
    found = re.search(r"(\d+):(\d+)", error)
    line, column = (int(found[1]), int(found[2])) if found else (1, 1)
    at = sum(len(each) for each in text.splitlines(keepends=True)[: line - 1]) + column - 1
    start = max((each.start for each in split(text) if each.start <= at), default=0)
    rest = text[start:].split("\n", maxsplit=1)[0].strip()
    return NotSparql(f"not SPARQL 1.1 near '{rest}'", start=max(start - header, 0))


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
    """Return `try_regex` for a call of REGEX or REPLACE whose pattern is a constant."""
    pattern = _argument(arguments, 1)
    flags = _argument(arguments, 2 if name.upper() == "REGEX" else 3)
    if pattern is not None:
        try_regex(pattern, flags or "''")


def _argument(arguments: Sequence[str], wanted: int) -> str | None:
    """Return the argument at *wanted*, if it is there and a plain string."""
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
