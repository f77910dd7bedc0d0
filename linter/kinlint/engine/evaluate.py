"""Runs compiled constraints on a store."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Protocol

from kinlint.engine.constraint import FOCUS, Constraint
from kinlint.engine.pruning import Lookup, Presence
from kinlint.engine.result import Result
from kinlint.engine.store import rank
from kinlint.terms import Term, is_blank, is_iri, literal_value


class Queryable(Lookup, Protocol):
    """A store that answers SELECT queries with tokens, such as `kinlint.engine.store.Store`."""

    def rows(self, text: str) -> Iterator[dict[str, Term]]:
        """Yield the solutions of a query: the tokens of bound variables by name."""
        ...


def check(
    store: Queryable, constraints: Iterable[Constraint], focus: Term | None = None
) -> Iterator[Result]:
    """Yield the violations of *constraints*; deferred ones are passed over.

    With a *focus*, only those of that target node and of what is reached from it. That takes about
    a millisecond a constraint at any size of the model, unless *focus* is a blank node, which no
    query can name: then everything is checked and the rest dropped.
    """
    by_name = focus is not None and not is_blank(focus)
    presence = Presence(store)
    for constraint in constraints:
        if constraint.deferred is not None or not presence.may_violate(constraint):
            continue
        if not by_name:
            found = rows(store, constraint)
            yield from (result(constraint, each) for each in found if focus in (None, each["root"]))
        elif focus is not None:
            text = constraint.single.replace(FOCUS, focus)
            found = sorted(store.rows(text), key=rank, reverse=True)
            yield from (result(constraint, each) for each in found)


def rows(store: Queryable, constraint: Constraint) -> list[dict[str, Term]]:
    """Return all violations of *constraint* as its query has them, sorted."""
    return sorted(store.rows(constraint.select), key=rank, reverse=True)


def result(constraint: Constraint, row: Mapping[str, Term]) -> Result:
    """Return the violation of *constraint* that its query has a *row* for."""
    path = row.get("path")
    return Result(
        constraint=constraint,
        focus=row["this"],
        path=path if path is not None and is_iri(path) else constraint.path,
        value=row.get("value"),
        message=literal_value(row["message"]) if "message" in row else None,
        bindings={name: term for name, term in row.items() if name != "root"},
    )
