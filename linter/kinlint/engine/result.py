"""One violation, as an engine reports it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from kinlint.engine.constraint import Constraint
from kinlint.terms import Term


@dataclass(frozen=True, slots=True)
class Result:
    """A `sh:ValidationResult`: where a constraint is violated, by what.

    `path` and `value` are None where SHACL has none. `message` is the text that the query
    itself bound; otherwise the constraint's templates apply. `bindings` holds every variable
    that templates and premises may name, without its `?`.
    """

    constraint: Constraint
    focus: Term
    path: Term | None = None
    value: Term | None = None
    message: str | None = None
    bindings: Mapping[str, Term] = field(default_factory=dict)
