"""SPARQL-based constraints: SHACL 5."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from kinlint.engine.compiler.deferral import Deferred
from kinlint.engine.compiler.shacl_terms import sh
from kinlint.engine.compiler.shape import messages
from kinlint.engine.compiler.shape_scope import THIS, ShapeScope, Violation, component, shown
from kinlint.engine.compiler.target_narrowing import runs_without_focus
from kinlint.engine.compiler.user_query import read_query
from kinlint.terms import iri_value, literal_value
from kinlint.vocabulary import KL

if TYPE_CHECKING:
    from kinlint.engine.compiler.shape import Shape
    from kinlint.engine.compiler.shapes_graph import ShapesGraph
    from kinlint.engine.compiler.user_query import Query
    from kinlint.terms import Term

BECAUSE = f"<{KL}because>"
FORMAT = f"<{KL}format>"
TARGET = f"<{KL}target>"
SEVERITY_FOR = f"<{KL}severityFor>"
FEATURE = f"<{KL}feature>"
SPEAKS_OF = f"<{KL}speaksOf>"
TARGET_NODE = sh("targetNode")
VALUE = "?k_value"


def sparql(scope: ShapeScope) -> Iterator[Violation]:
    """Yield the violations of `sh:sparql`: every solution of the author's query is a violation."""
    shape = scope.shape
    for node in shape.values("sparql"):
        if shape.graph.is_true(node, sh("deactivated")):
            continue
        own = messages(shape.graph, node) or shape.messages
        name = shown(shape, shape.node)
        try:
            query = query_for(scope, node, "select", (THIS,))
        except Deferred as reason:
            yield Violation(
                component("SPARQL"), messages=own, own_messages=True, deferred=str(reason)
            )
            continue
        yield Violation(
            component("SPARQL"),
            (solutions(scope, query, (THIS,)),),
            shown=result_variables(scope, query),
            at_value=not shape.path and "?value" not in query.variables,
            messages=own or (f"'{{?this}}' violates '{name}'.",),
            because=because(shape.graph, node),
            own_messages=True,
            premises=query.premises,
            formats=formats(shape.graph, node),
            severity=severity(shape.graph, node),
            consumers=consumers(shape.graph, node),
            severity_for=severity_for(shape.graph, node),
            feature=named_for(shape, node, FEATURE),
            speaks_of=named_for(shape, node, SPEAKS_OF),
            without_focus=runs_without_focus(query.select),
        )


def because(graph: ShapesGraph, node: Term) -> str:
    """Return the template of a constraint's `kl:because`; "" if it has none."""
    told = graph.one(node, BECAUSE)
    return " ".join(literal_value(told).split()) if told is not None else ""


def formats(graph: ShapesGraph, node: Term) -> tuple[str, ...]:
    """Return the formats that a constraint is limited to by `kl:format`."""
    return tuple(sorted(map(literal_value, graph.values(node, FORMAT))))


def consumers(graph: ShapesGraph, node: Term) -> tuple[str, ...]:
    """Return the consumers that a constraint is about by `kl:target`."""
    return tuple(sorted(map(literal_value, graph.values(node, TARGET))))


def severity_for(
    graph: ShapesGraph, node: Term
) -> tuple[tuple[str, tuple[str, ...], tuple[str, ...]], ...]:
    """Return the severities of `kl:severityFor`: the IRI, the consumers and the formats of each."""
    return tuple(
        sorted(
            (severity(graph, each), consumers(graph, each), formats(graph, each))
            for each in graph.values(node, SEVERITY_FOR)
        )
    )


def severity(graph: ShapesGraph, node: Term) -> str:
    """Return the IRI of a constraint's own `sh:severity`; "" if it has none."""
    return named(graph, node, sh("severity"))


def named(graph: ShapesGraph, node: Term, predicate: Term) -> str:
    """Return the IRI that *node* names by *predicate*; "" if it names none."""
    own = graph.one(node, predicate)
    return iri_value(own) if own is not None else ""


def named_for(shape: Shape, node: Term, predicate: Term) -> str:
    """Return the IRI that the constraint *node* of *shape* names by *predicate*, else the shape."""
    return named(shape.graph, node, predicate) or named(shape.graph, shape.node, predicate)


def query_for(scope: ShapeScope, node: Term, kind: str, prebound: tuple[str, ...]) -> Query:
    """Return the author's query of *node*, ready for *scope*, where *prebound* have values."""
    shape = scope.shape
    path = shape.path.text if shape.path else None
    query = read_query(shape.graph, node, kind, path, prebound)
    nodes = (*scope.above, shape.node)
    if query.may_stay and any(shape.graph.values(each, TARGET_NODE) for each in nodes):
        raise Deferred("a path of no steps may start from a target node outside the graph")
    return query


def solutions(
    scope: ShapeScope, query: Query, prebound: tuple[str, ...], before: tuple[str, ...] = ()
) -> str:
    """Return the group that has the solutions of *query*, each once.

    *before* are groups that bind variables of *prebound* other than `$this`. Where only conformance
    is asked, none of the author's variables is seen outside.
    """
    names = dict.fromkeys([*prebound, *query.variables])
    if _has_own_value(scope, query):
        del names["?value"]
        names[f"(COALESCE(?value, {THIS}) AS {VALUE})"] = None
    inner = f"SELECT DISTINCT {' '.join(names)} WHERE {{ {{ {query.text} }} }}"
    if scope.top:
        return " LATERAL ".join(f"{{ {group} }}" for group in (*before, inner))
    groups = (*rename(scope.focus, THIS), *before, inner)
    chain = " LATERAL ".join(f"{{ {group} }}" for group in groups)
    return f"SELECT {scope.focus} WHERE {{ {chain} }}"


def rename(variable: str, name: str) -> tuple[str, ...]:
    """Return groups that give *name* the value of *variable*: none if they are the same."""
    return () if variable == name else (f"BIND({variable} AS {name})",)


def result_variables(scope: ShapeScope, query: Query) -> tuple[str, ...]:
    """Return the variables of a result, all of *query* but `$this`, as a SELECT names them."""
    own = _has_own_value(scope, query)
    names = [name for name in query.variables if name != THIS]
    return tuple(f"({VALUE} AS ?value)" if own and name == "?value" else name for name in names)


def _has_own_value(scope: ShapeScope, query: Query) -> bool:
    """Tell whether *query* may tell a value where a node shape would have its focus node."""
    return scope.top and not scope.shape.path and "?value" in query.variables
