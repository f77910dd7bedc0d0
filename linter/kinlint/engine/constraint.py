"""A SHACL constraint, compiled: all that a run needs to check it, as plain JSON values."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

from kinlint.light_dataclasses import asdict, dataclass
from kinlint.terms import Term, Triple

FOCUS = "$FOCUS"
"""Stands in `Constraint.single` where the token of the focus node belongs."""

PLAIN = re.compile(r"<[^<>]*>")
"""The predicate of a premise that is an IRI, and neither a variable nor a path."""


def predicates(path: Term) -> Sequence[Term | None]:
    """Return the predicates that *path* follows; None for any, such as of a variable."""
    return [None] if "!" in path else PLAIN.findall(path) or [None]


@dataclass(frozen=True, slots=True)
class Constraint:
    """A constraint of one shape, reached on one way from a target."""

    owner: str
    """The IRI of its rule, or of a shape outside rules; of a blank shape, the label."""
    shape: Term
    """The token of the source shape."""
    component: str
    """The IRI of its constraint component."""
    severity: str
    """The IRI of its own severity, or that of the shape."""
    messages: tuple[str, ...] = ()
    """Templates with `{?name}`, the one for readers of English first."""
    because: str = ""
    """The template of its `kl:because`: one sentence with the numbers that show the violation."""
    path: Term | None = None
    """The predicate of the shape; None for node shapes and longer paths."""
    select: str = ""
    """The query for every violation at once.

    It projects `?root` (the target node), `?this` (the focus node: `?root` unless the constraint
    sits in a property of a property), and, as far as the component has them, `?value`, `?path` and
    the variables of messages.
    """
    single: str = ""
    """The same query for one target node.

    Its text has `FOCUS` where the token of the node belongs; a blank node cannot be written there.
    """
    premises: tuple[Triple, ...] = ()
    """The triple patterns that hold wherever the constraint is violated.

    Variables have `?`; names that `select` projects mean the same in both. Sequences and inverses
    are taken apart; a predicate that is any other path is SPARQL text.
    """
    targets: tuple[Triple, ...] = ()
    """The patterns by one of which the target node was chosen.

    Classes are as if closed; there are none where a shape names its target nodes.
    """
    deferred: str | None = None
    """The reason why only the reference engine may judge this, and there are no queries."""
    formats: tuple[str, ...] = ()
    """The formats of its rule that it looks at, none for all.

    A constraint that speaks of the text of a format spares what another says of the model.
    """
    consumers: tuple[str, ...] = ()
    """The consumers that it is about, by its `kl:target`; none for all."""
    severity_for: tuple[tuple[str, tuple[str, ...], tuple[str, ...]], ...] = ()
    """Severities by its `kl:severityFor`: the IRI of each, its consumers and its formats."""
    feature: str = ""
    """The feature of descriptions that it finds, by its `kl:feature`: an IRI."""
    speaks_of: str = ""
    """Consumers whose departures it reports, by its `kl:speaksOf`: an IRI; empty if of none."""
    needs: tuple[Term, ...] | None = None
    """The properties and classes that the query looks at, None for any."""
    sweeps: str = ""
    """Kinds of terms that the query matches without a name: `c` classes, `p` properties."""

    def to_json(self) -> dict[str, Any]:
        """Return the constraint as JSON values; what has its default is left out."""
        values = asdict(self)
        needs = {"needs": values.pop("needs")} if self.needs is not None else {}
        return needs | {
            name: value for name, value in values.items() if value not in ("", None, ())
        }

    @classmethod
    def from_json(cls, values: dict[str, Any]) -> Constraint:
        """Return the constraint that `to_json` wrote."""
        return cls(
            **{
                **values,
                "messages": tuple(values.get("messages", ())),
                "formats": tuple(values.get("formats", ())),
                "consumers": tuple(values.get("consumers", ())),
                "severity_for": tuple(
                    (severity, tuple(consumers), tuple(formats))
                    for severity, consumers, formats in values.get("severity_for", ())
                ),
                "premises": tuple((s, p, o) for s, p, o in values.get("premises", ())),
                "needs": tuple(values["needs"]) if "needs" in values else None,
                "targets": tuple((s, p, o) for s, p, o in values.get("targets", ())),
            }
        )
