"""One SHACL constraint, compiled: what a run needs to check it, as plain JSON values."""

from __future__ import annotations

import re
from dataclasses import asdict, dataclass
from typing import Any

from kinlint.terms import Term, Triple

FOCUS = "$FOCUS"
"""Stands in `Constraint.single` where the token of the focus node belongs."""

PLAIN = re.compile(r"<[^<>]*>")
"""The predicate of a premise that is an IRI, and neither a variable nor a path."""


@dataclass(frozen=True, slots=True)
class Constraint:
    """A constraint of one shape, reached on one way from a target.

    `owner`, `component` and `severity` are IRIs (`owner` is a blank node label for a blank
    shape outside a rule); `severity` is its own, or that of the shape; `shape` is the token of the
    source shape. `path` is the token of the shape's predicate, None for node shapes and longer
    paths. `messages` are templates with `{?name}`, the one for readers of English first.

    `select` finds every violation at once. It projects `?root` (the target node), `?this` (the
    focus node: `?root` unless the constraint sits in a property of a property), and, as far
    as the component says them, `?value`, `?path` and the variables of messages. `single` is the
    same for one target node: its text has `FOCUS` where the node's token belongs. A blank node
    cannot be written there.

    `premises` are the triple patterns that hold wherever the constraint is violated, variables
    with `?`; names that `select` projects mean the same in both. Sequences and inverses are
    taken apart; a predicate that is any other path is SPARQL text. `targets` are the patterns by
    one of which the target node was chosen, with classes as if closed; there are none where a shape
    names its target nodes. `deferred` says why only the reference engine may judge this; then
    `select` and `single` are empty. `formats` are those of its rule that it looks at, none for all:
    one that speaks of the text of a format spares what another says of the model. `needs` are the
    properties and classes that the query looks at, None for any.
    """

    owner: str
    shape: Term
    component: str
    severity: str
    messages: tuple[str, ...] = ()
    path: Term | None = None
    select: str = ""
    single: str = ""
    premises: tuple[Triple, ...] = ()
    targets: tuple[Triple, ...] = ()
    deferred: str | None = None
    formats: tuple[str, ...] = ()
    needs: tuple[Term, ...] | None = None

    def to_json(self) -> dict[str, Any]:
        """The constraint as JSON values; what has its default is left out."""
        values = asdict(self)
        needs = {"needs": values.pop("needs")} if self.needs is not None else {}
        return needs | {
            name: value for name, value in values.items() if value not in ("", None, ())
        }

    @classmethod
    def from_json(cls, values: dict[str, Any]) -> Constraint:
        """The constraint that `to_json` wrote."""
        return cls(
            **{
                **values,
                "messages": tuple(values.get("messages", ())),
                "formats": tuple(values.get("formats", ())),
                "premises": tuple((s, p, o) for s, p, o in values.get("premises", ())),
                "needs": tuple(values["needs"]) if "needs" in values else None,
                "targets": tuple((s, p, o) for s, p, o in values.get("targets", ())),
            }
        )
