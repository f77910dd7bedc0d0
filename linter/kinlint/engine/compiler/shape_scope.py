"""The variables that stand for a shape's nodes in a query, and the parts of its violations."""

from __future__ import annotations

from collections.abc import Callable
from itertools import count
from typing import TYPE_CHECKING

from kinlint.engine.compiler.shacl_terms import sh
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term, Triple, iri_value, is_blank, is_iri

if TYPE_CHECKING:
    from kinlint.engine.compiler.shape import Shape

THIS = "?this"


@dataclass(frozen=True)
class ShapeScope:
    """A shape with the SPARQL variables for its focus node, its value nodes and its results."""

    shape: Shape
    """The shape."""
    focus: str
    """The variable of the focus node."""
    value: str
    """The variable of the value node: `focus` itself in node shapes."""
    out: str
    """The variable of the value in a result."""
    path: str
    """The variable of the path in a result."""
    extra: str
    """The variable of what values are compared by or with: a language tag, a limit."""
    names: count[int]
    """Numbers for fresh variables, shared by all scopes of a query."""
    above: tuple[Term, ...]
    """The shapes through which this one was reached, from the one with targets on."""
    conforms: Callable[[Term, str], str]
    """Returns the condition that a variable conforms to a shape."""
    top: bool = False
    """Results are reported, rather than conformance asked."""

    @property
    def value_groups(self) -> tuple[str, ...]:
        """The group that binds `value` to each value node; none in node shapes."""
        return (self.value_pattern(self.value),) if self.shape.path else ()

    def value_pattern(self, end: str) -> str:
        """Return the group that binds *end* to each value node of a property shape."""
        assert self.shape.path is not None
        return self.shape.path.pattern(self.focus, end, self.names)

    def fresh(self) -> str:
        """Return a variable that occurs nowhere else."""
        return f"?k_{next(self.names)}"


@dataclass(frozen=True)
class Violation:
    """The part of a query that finds the violations of one constraint of a shape."""

    component: str
    """The IRI of the constraint component."""
    groups: tuple[str, ...] = ()
    """Groups that are evaluated one inside the other, the focus node bound."""
    condition: str = ""
    """Of the solutions of `groups`, those are violations for which this holds; never an error."""
    shown: tuple[str, ...] = ()
    """The variables of a result."""
    at_value: bool = False
    """The value node is the value of the result."""
    messages: tuple[str, ...] = ()
    """Templates of its message, one for each language."""
    because: str = ""
    """The template of its `kl:because`."""
    own_messages: bool = False
    """The messages are those of the constraint or its component, not of the shape."""
    premises: tuple[Triple, ...] = ()
    """Patterns that every violation matches."""
    deferred: str | None = None
    """The reason why the reference engine has to judge the constraint."""
    formats: tuple[str, ...] = ()
    """The formats that it is for, where not all that the rule is for."""
    severity: str = ""
    """Its own severity, where that is not the severity of the shape."""
    consumers: tuple[str, ...] = ()
    """The consumers that it is about, where not all."""
    severity_for: tuple[tuple[str, tuple[str, ...], tuple[str, ...]], ...] = ()
    """Severities for certain consumers or formats: the IRI of each, consumers and formats."""
    feature: str = ""
    """The IRI of the feature that it finds, where it finds one."""
    speaks_of: str = ""
    """The IRI of `kl:speaksOf`: the consumers whose departures it reports."""
    without_focus: bool = False
    """The groups find the same with no focus node bound, for all nodes at once."""

    @property
    def body(self) -> str:
        """All of it as one pattern."""
        groups = [*self.groups, *([f"FILTER({self.condition})"] if self.condition else [])]
        return " LATERAL ".join(f"{{ {group} }}" for group in groups)

    @property
    def absent(self) -> str:
        """The condition that there is no such violation."""
        return f"NOT EXISTS {{ {self.body} }}" if self.groups else f"!({self.condition})"


def component(name: str) -> str:
    """Return the IRI of a component of SHACL."""
    return iri_value(sh(f"{name}ConstraintComponent"))


def shown(shape: Shape, term: Term) -> str:
    """Return *term* for messages, with the prefixes of the shape's file."""
    if not is_iri(term):
        return "a blank node" if is_blank(term) else term
    iri = iri_value(term)
    for prefix, namespace in shape.graph.home(shape.node).prefixes.items():
        if iri.startswith(namespace) and len(iri) > len(namespace) > 0:
            return f"{prefix}:{iri[len(namespace) :]}"
    return iri
