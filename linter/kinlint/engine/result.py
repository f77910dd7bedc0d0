"""A violation, as an engine reports it."""

from __future__ import annotations

from collections.abc import Mapping

from kinlint.engine.constraint import Constraint
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import Term


@dataclass(frozen=True, slots=True)
class Result:
    """A `sh:ValidationResult`: a violation of a constraint."""

    constraint: Constraint
    """The violated constraint."""
    focus: Term
    """The focus node."""
    path: Term | None = None
    """The path of the violation; None where SHACL has none."""
    value: Term | None = None
    """The value node; None where SHACL has none."""
    message: str | None = None
    """The text that the query itself bound; otherwise the constraint's templates apply."""
    bindings: Mapping[str, Term] = field(default_factory=dict)
    """Every variable that templates and premises may name, without its `?`."""
