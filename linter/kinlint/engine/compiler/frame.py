"""Where a shape is judged: the variables of a query, and what a violation is made of."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import count
from typing import TYPE_CHECKING

from kinlint.engine.compiler.names import sh
from kinlint.terms import Term, Triple, iri_value, is_blank, is_iri

if TYPE_CHECKING:
    from kinlint.engine.compiler.shape import Shape

THIS = "?this"


@dataclass(frozen=True)
class Frame:
    """A shape with the variable of its focus node and names for what is found there.

    `value` is the value node: `focus` itself in node shapes. `out`, `path` and `extra` name
    what a result may say. `above` are the shapes through which this one was reached, from the
    one with targets on. `conforms` gives the condition that a variable conforms to a shape.
    `top` says that results are reported, rather than conformance asked.
    """

    shape: Shape
    focus: str
    value: str
    out: str
    path: str
    extra: str
    names: count[int]
    above: tuple[Term, ...]
    conforms: Callable[[Term, str], str]
    top: bool = False

    @property
    def each(self) -> tuple[str, ...]:
        """The group that binds `value` to each value node; none in node shapes."""
        return (self.reach(self.value),) if self.shape.path else ()

    def reach(self, end: str) -> str:
        """The group that binds *end* to each value node of a property shape."""
        assert self.shape.path is not None
        return self.shape.path.pattern(self.focus, end, self.names)

    def fresh(self) -> str:
        """A variable that occurs nowhere else."""
        return f"?k_{next(self.names)}"


@dataclass(frozen=True)
class Violation:
    """How a query finds what breaks one constraint.

    `groups` are evaluated one inside the other, the focus node bound; each solution for which
    `condition` holds is a violation. `condition` is never an error. `shown` are the variables
    of a result; `at_value` says that the value node is its value. `path` says that a variable
    rather than the shape tells the path. `formats` are those it is for, where not all that the
    rule is for. `severity` is its own, where it is not that of the shape. `stands` says that it
    finds the same without a focus node, for all of them at once.
    """

    component: str
    groups: tuple[str, ...] = ()
    condition: str = ""
    shown: tuple[str, ...] = ()
    at_value: bool = False
    messages: tuple[str, ...] = ()
    own_messages: bool = False
    premises: tuple[Triple, ...] = ()
    deferred: str | None = None
    formats: tuple[str, ...] = ()
    severity: str = ""
    stands: bool = False

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
    """The IRI of a component of SHACL."""
    return iri_value(sh(f"{name}ConstraintComponent"))


def shown(shape: Shape, term: Term) -> str:
    """*term* for messages, with the prefixes of the shape's file."""
    if not is_iri(term):
        return "a blank node" if is_blank(term) else term
    iri = iri_value(term)
    for prefix, namespace in shape.graph.home(shape.node).prefixes.items():
        if iri.startswith(namespace) and len(iri) > len(namespace) > 0:
            return f"{prefix}:{iri[len(namespace) :]}"
    return iri
