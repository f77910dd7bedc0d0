"""SPARQL-based constraint components, declared in shapes graphs: SHACL 6."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import product
from typing import TYPE_CHECKING

from kinlint.engine.compiler.deferral import Deferred
from kinlint.engine.compiler.literal_conditions import constant
from kinlint.engine.compiler.shacl_terms import sh
from kinlint.engine.compiler.shape import messages
from kinlint.engine.compiler.shape_scope import THIS, ShapeScope, Violation
from kinlint.engine.compiler.sparql_constraints import (
    query_for,
    rename,
    result_variables,
    solutions,
)
from kinlint.light_dataclasses import dataclass, replace
from kinlint.sparql.ast import Group, Select, Union, render
from kinlint.terms import Term, iri_value, is_iri

if TYPE_CHECKING:
    from kinlint.engine.compiler.shapes_graph import ShapesGraph

_RESERVED = {"this", "shapesGraph", "currentShape", "path", "PATH", "value"}


@dataclass(frozen=True)
class Parameter:
    """A parameter of a component: the property that gives it, and its variable."""

    path: Term
    """Property that gives the value (`sh:path`)."""
    variable: str
    """Name of the SPARQL variable with the value."""
    optional: bool
    """True if a shape may leave it out (`sh:optional`)."""


def custom(scope: ShapeScope) -> Iterator[Violation]:
    """Yield the violations of every declared component whose parameters the shape gives."""
    graph = scope.shape.graph
    for node in graph.subjects():
        if not graph.values(node, sh("parameter")) or not is_iri(node):
            continue
        parameters = _parameters(graph, node)
        given = [graph.values(scope.shape.node, each.path) for each in parameters]
        required = zip(parameters, given, strict=True)
        if any(not values and not each.optional for each, values in required):
            continue
        validator = _validator(scope, node)
        if validator is None or not any(given):
            continue
        for values in product(*(_options(each) for each in given)):
            bindings = {
                each.variable: value for each, value in zip(parameters, values, strict=True)
            }
            try:
                yield _violation(scope, node, validator, bindings)
            except Deferred as reason:
                yield Violation(iri_value(node), deferred=str(reason))


def _options(values: list[Term]) -> list[Term | None]:
    return [*values] or [None]


def _parameters(graph: ShapesGraph, node: Term) -> list[Parameter]:
    found = []
    for each in graph.values(node, sh("parameter")):
        path = graph.one(each, sh("path"))
        name = re.split(r"[/#:]", path[1:-1])[-1] if path and is_iri(path) else ""
        if not path or not re.fullmatch(r"\w+", name) or name in _RESERVED:
            raise graph.invalid(each, "a parameter needs a sh:path that can name a variable")
        found.append(Parameter(path, f"?{name}", graph.is_true(each, sh("optional"))))
    if all(each.optional for each in found):
        raise graph.invalid(node, "a component needs a parameter that is not optional")
    return found


def _validator(scope: ShapeScope, node: Term) -> Term | None:
    """Return the validator that SHACL 6.3 chooses for the kind of shape."""
    special = "propertyValidator" if scope.shape.path else "nodeValidator"
    found = scope.shape.graph.values(node, sh(special), sh("validator"))
    return found[0] if found else None


def _violation(
    scope: ShapeScope, node: Term, validator: Term, given: dict[str, Term | None]
) -> Violation:
    graph = scope.shape.graph
    parameters = tuple(given)
    bound = {name: constant(value) for name, value in given.items() if value is not None}
    binds = tuple(f"BIND({value} AS {name})" for name, value in bound.items())
    own = scope.shape.messages or messages(graph, validator) or messages(graph, node)
    default = (f"'{{?this}}' violates '{iri_value(node)}'.",)
    violation = Violation(
        iri_value(node), shown=tuple(bound), messages=own or default, own_messages=True
    )
    if not graph.values(validator, sh("ask")):
        query = query_for(scope, validator, "select", (THIS, *parameters))
        query = replace(query, select=_passing(query.select, parameters))
        groups = (solutions(scope, query, (THIS, *parameters), binds),)
        at_value = not scope.shape.path and "?value" not in query.variables
        shown = tuple(dict.fromkeys([*bound, *result_variables(scope, query)]))
        return replace(violation, groups=groups, shown=shown, at_value=at_value)
    prebound = (THIS, "?value", *parameters)
    query = query_for(scope, validator, "ask", prebound)
    held = Select(("SELECT", *prebound), query.select.group, query.select.tail)
    if query.select.tail:
        raise Deferred("an ASK query with solution modifiers")
    body = Group((Union((Group((held,)),)),))
    return replace(violation, groups=_asked(scope, body, binds), shown=("?value", *bound))


def _asked(scope: ShapeScope, body: Group, binds: tuple[str, ...]) -> tuple[str, ...]:
    """Return groups with a solution for each value node for which *body* has none."""
    groups = (f"BIND({scope.value} AS ?value)", *binds, f"FILTER NOT EXISTS {render(body)}")
    if scope.top:
        return (*scope.value_groups, *groups)
    hidden = (*rename(scope.focus, THIS), *groups)
    chain = " LATERAL ".join(f"{{ {group} }}" for group in hidden)
    names = " ".join(dict.fromkeys([scope.focus, scope.value]))
    return (*scope.value_groups, f"SELECT {names} WHERE {{ {chain} }}")


def _passing(select: Select, parameters: tuple[str, ...]) -> Select:
    """Return *select* with *parameters* among its variables: their values then reach its WHERE."""
    missing = [name for name in parameters if name not in select.head]
    if not missing:
        return select
    if any(str(word).upper() in ("GROUP", "HAVING") for word in select.tail):
        raise Deferred("a validator that groups its solutions does not return its parameters")
    return replace(select, head=(*select.head, *missing))
