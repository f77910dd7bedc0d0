"""SHACL property paths as SPARQL: SHACL 2.3.1."""

from __future__ import annotations

from itertools import count, pairwise
from typing import TYPE_CHECKING, Literal, TypeAlias

from kinlint.engine.compiler.shacl_terms import sh
from kinlint.engine.compiler.shapes_graph import FIRST
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term, Triple, is_iri

if TYPE_CHECKING:
    from kinlint.engine.compiler.shapes_graph import ShapesGraph

Kind: TypeAlias = Literal["predicate", "inverse", "sequence", "alternative", "*", "+", "?"]

_CLOSURES: dict[Term, Kind] = {
    sh("zeroOrMorePath"): "*",
    sh("oneOrMorePath"): "+",
    sh("zeroOrOnePath"): "?",
}
_MIN_MEMBERS = 2


@dataclass(frozen=True)
class Path:
    """A property path: a predicate, or an operator with its operands."""

    kind: Kind
    """Operator, or that it is a predicate."""
    predicate: Term = ""
    """Predicate; empty for an operator."""
    parts: tuple[Path, ...] = ()
    """Operands of the operator."""

    @property
    def text(self) -> str:
        """The path in SPARQL, in parentheses unless it is a predicate."""
        match self.kind:
            case "predicate":
                return self.predicate
            case "inverse":
                return f"(^{self.parts[0].text})"
            case "sequence" | "alternative":
                glue = "/" if self.kind == "sequence" else "|"
                return f"({glue.join(part.text for part in self.parts)})"
            case closure:
                return f"({self.parts[0].text}{closure})"

    @property
    def may_stay(self) -> bool:
        """True if the path can lead from a node to itself in no steps."""
        match self.kind:
            case "predicate":
                return False
            case "*" | "?":
                return True
            case "alternative":
                return any(part.may_stay for part in self.parts)
            case _:
                return all(part.may_stay for part in self.parts)

    def steps(self, start: str, end: str, names: count[int]) -> list[Triple]:
        """Return triple patterns from *start* to *end*; sequences and inverses are taken apart."""
        if self.kind == "sequence":
            inner = [f"?k_{next(names)}" for _ in self.parts[1:]]
            nodes = pairwise([start, *inner, end])
            return [
                step
                for part, (a, b) in zip(self.parts, nodes, strict=True)
                for step in part.steps(a, b, names)
            ]
        if self.kind == "inverse":
            return self.parts[0].steps(end, start, names)[::-1]
        return [(start, self.text, end)]

    def pattern(self, start: str, end: str, names: count[int]) -> str:
        """Return a group that binds *end* to each node the path leads to from *start*, once.

        *start* must be bound where the group is evaluated.
        """
        chain = " LATERAL ".join("{ " + " ".join(s) + " }" for s in self.steps(start, end, names))
        if self.may_stay:
            # Oxigraph lets a path of no steps match only terms that occur in the graph.
            chain = f"{{ {chain} }} UNION {{ BIND({start} AS {end}) }}"
        return f"{{ SELECT DISTINCT {start} {end} WHERE {{ {chain} }} }}"


def read_path(graph: ShapesGraph, node: Term) -> Path:
    """Return the path that *node* stands for; `RuleInvalid` if it is none."""
    return _read(graph, node, ())


def _read(graph: ShapesGraph, node: Term, above: tuple[Term, ...]) -> Path:
    if is_iri(node):
        return Path("predicate", node)
    if node in above:
        raise graph.invalid(node, "the property path contains itself")
    above = (*above, node)
    if graph.values(node, FIRST):
        return Path("sequence", parts=_members(graph, node, above))
    if inverse := graph.one(node, sh("inversePath")):
        return Path("inverse", parts=(_read(graph, inverse, above),))
    if choice := graph.one(node, sh("alternativePath")):
        return Path("alternative", parts=_members(graph, choice, above))
    for predicate, closure in _CLOSURES.items():
        if inner := graph.one(node, predicate):
            return Path(closure, parts=(_read(graph, inner, above),))
    raise graph.invalid(node, "this is not a property path")


def _members(graph: ShapesGraph, head: Term, above: tuple[Term, ...]) -> tuple[Path, ...]:
    members = graph.list(head)
    if len(members) < _MIN_MEMBERS:
        raise graph.invalid(head, "a property path needs two members or more here")
    return tuple(_read(graph, member, above) for member in members)
