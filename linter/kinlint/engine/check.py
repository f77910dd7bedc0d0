"""Runs compiled constraints on a store."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Protocol

from kinlint.engine.constraint import FOCUS, Constraint
from kinlint.engine.presence import Lookup, Presence
from kinlint.engine.result import Result
from kinlint.terms import Term, is_blank, is_iri, literal_value


class Queryable(Lookup, Protocol):
    """What answers SELECT queries with tokens, such as `kinlint.engine.store.Store`."""

    def rows(self, text: str) -> Iterator[dict[str, Term]]:
        """The solutions of a query: the tokens of bound variables by name."""
        ...


def check(
    store: Queryable, constraints: Iterable[Constraint], focus: Term | None = None
) -> Iterator[Result]:
    """The violations of *constraints*; deferred ones are passed over.

    With a *focus*, only those of that target node and of what is reached from it. That takes
    about a millisecond a constraint at any size of the model, unless *focus* is a blank node,
    which no query can name: then everything is checked and the rest dropped.
    """
    by_name = focus is not None and not is_blank(focus)
    presence = Presence(store)
    for constraint in constraints:
        if constraint.deferred is not None or not presence.may_violate(constraint):
            continue
        text = constraint.select
        if by_name and focus is not None:
            text = constraint.single.replace(FOCUS, focus)
        for row in store.rows(text):
            root = row.pop("root")
            if focus is None or by_name or root == focus:
                yield _result(constraint, row)


def _result(constraint: Constraint, row: Mapping[str, Term]) -> Result:
    path = row.get("path")
    return Result(
        constraint=constraint,
        focus=row["this"],
        path=path if path is not None and is_iri(path) else constraint.path,
        value=row.get("value"),
        message=literal_value(row["message"]) if "message" in row else None,
        bindings=row,
    )
