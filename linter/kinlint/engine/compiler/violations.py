"""All constraints of a shape, and the condition that a node conforms to one."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from itertools import count
from typing import TYPE_CHECKING

from kinlint.engine.compiler import comparisons, counts
from kinlint.engine.compiler.custom_components import custom
from kinlint.engine.compiler.deferral import Deferred
from kinlint.engine.compiler.shacl_terms import sh
from kinlint.engine.compiler.shape import Shape, read_shape
from kinlint.engine.compiler.shape_scope import ShapeScope, Violation, component
from kinlint.engine.compiler.sparql_constraints import sparql
from kinlint.engine.compiler.value_conditions import CONDITIONS, condition_violations

if TYPE_CHECKING:
    from kinlint.engine.compiler.shapes_graph import ShapesGraph
    from kinlint.terms import Term

_COMPONENTS: dict[str, Callable[[ShapeScope], Iterator[Violation]]] = {
    **{name: partial(condition_violations, name=name) for name in CONDITIONS},
    "MinCount": counts.min_count,
    "MaxCount": counts.max_count,
    "QualifiedMinCount": counts.qualified_min,
    "QualifiedMaxCount": counts.qualified_max,
    "HasValue": comparisons.has_value,
    "UniqueLang": comparisons.unique_lang,
    "Equals": comparisons.equals,
    "LessThan": comparisons.less_than,
    "LessThanOrEquals": comparisons.less_than_or_equals,
    "Closed": comparisons.closed,
    "SPARQL": sparql,
    "Custom": custom,
}
_BEYOND = {"js": "JS", "expression": "Expression"}


_ONCE = (
    *("datatype", "nodeKind", "minCount", "maxCount", "minLength", "maxLength", "pattern"),
    *("minExclusive", "minInclusive", "maxExclusive", "maxInclusive", "languageIn", "uniqueLang"),
    *("in", "closed", "ignoredProperties", "flags", "severity", "deactivated"),
    *("qualifiedValueShape", "qualifiedMinCount", "qualifiedMaxCount"),
)
"""Parameters of which a shape has one value at most."""


def violations(scope: ShapeScope) -> Iterator[Violation]:
    """Yield every constraint of the shape of *scope*, those of `sh:property` excepted."""
    for name in _ONCE:
        scope.shape.one(name)
    for name, found in _COMPONENTS.items():
        try:
            yield from found(scope)
        except Deferred as reason:
            yield Violation(component(name), deferred=str(reason))
    for parameter, name in _BEYOND.items():
        if scope.shape.values(parameter):
            yield Violation(component(name), deferred=f"sh:{parameter} is not part of SHACL")


def top_frame(shape: Shape, names: count[int], above: tuple[Term, ...]) -> ShapeScope:
    """Return the scope in which results of *shape* are reported, reached through shapes *above*."""
    return ShapeScope(
        shape,
        focus="?this",
        value=f"?k_{next(names)}" if shape.path else "?this",
        out="?value",
        path="?path",
        extra="?other",
        names=names,
        above=above,
        conforms=partial(_conforms, shape.graph, names, (*above, shape.node)),
        top=True,
    )


def _conforms(
    graph: ShapesGraph, names: count[int], above: tuple[Term, ...], node: Term, variable: str
) -> str:
    """Return the condition that *variable* conforms to the shape *node*; never an error.

    Raises `Deferred` if the shape refers to itself through *above*: SHACL leaves open what that
    means.
    """
    if node in above:
        raise Deferred("the shape refers to itself")
    shape = read_shape(graph, node)
    if shape.deactivated:
        return "true"

    def fresh() -> str:
        return f"?k_{next(names)}"

    conforms = partial(_conforms, graph, names, (*above, node))
    value = fresh() if shape.path else variable
    scope = ShapeScope(shape, variable, value, fresh(), fresh(), fresh(), names, above, conforms)
    absent = [_absent(violation) for violation in violations(scope)]
    for inner in shape.values("property"):
        held = conforms(inner, value)
        absent.append(_absent(Violation("", scope.value_groups, f"!{held}")))
    return f"({' && '.join(absent)})" if absent else "true"


def _absent(violation: Violation) -> str:
    if violation.deferred is not None:
        raise Deferred(violation.deferred)
    return violation.absent


def properties(shape: Shape) -> Iterator[Shape]:
    """Yield the property shapes of *shape* that are in force."""
    for node in shape.graph.values(shape.node, sh("property")):
        inner = read_shape(shape.graph, node)
        if inner.path is None:
            raise shape.graph.invalid(node, "a property shape needs a sh:path")
        if not inner.deactivated:
            yield inner
