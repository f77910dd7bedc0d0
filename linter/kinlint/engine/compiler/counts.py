"""Constraint components that count value nodes: SHACL 4.2 and 4.7.3."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from kinlint.engine.compiler.shacl_terms import sh
from kinlint.engine.compiler.shape_scope import ShapeScope, Violation, component, shown
from kinlint.terms import XSD, is_literal, literal_datatype, literal_value

if TYPE_CHECKING:
    from kinlint.terms import Term


def min_count(scope: ShapeScope) -> Iterator[Violation]:
    """Yield the violations of `sh:minCount`."""
    for least in _numbers(scope, "minCount"):
        if least < 1:
            continue
        message = f"There are fewer than {least} values." if least > 1 else "There is no value."
        yield Violation(
            component("MinCount"),
            _fewer(scope, scope.out, scope.value_pattern(scope.out), least),
            messages=(message,),
        )


def max_count(scope: ShapeScope) -> Iterator[Violation]:
    """Yield the violations of `sh:maxCount`."""
    for most in _numbers(scope, "maxCount"):
        message = f"There are more than {most} values." if most else "There is a value."
        groups = _more(scope, scope.out, scope.value_pattern(scope.out), most)
        yield Violation(component("MaxCount"), groups, messages=(message,))


def qualified_min(scope: ShapeScope) -> Iterator[Violation]:
    """Yield the violations of `sh:qualifiedMinCount`."""
    for least, end, found, name in _qualified(scope, "qualifiedMinCount"):
        if least > 0:
            text = f"There are fewer than {least} values that conform to '{name}'."
            groups = _fewer(scope, end, found, least)
            yield Violation(component("QualifiedMinCount"), groups, messages=(text,))


def qualified_max(scope: ShapeScope) -> Iterator[Violation]:
    """Yield the violations of `sh:qualifiedMaxCount`."""
    for most, end, found, name in _qualified(scope, "qualifiedMaxCount"):
        text = f"There are more than {most} values that conform to '{name}'."
        groups = _more(scope, end, found, most)
        yield Violation(component("QualifiedMaxCount"), groups, messages=(text,))


def _fewer(scope: ShapeScope, end: str, found: str, least: int) -> tuple[str, ...]:
    """Return groups that hold if *found* binds *end* to fewer than *least* terms."""
    if least == 1:
        return (f"FILTER NOT EXISTS {{ {found} }}",)
    number = scope.fresh()
    counted = f"SELECT {scope.focus} (COUNT(DISTINCT {end}) AS {number})"
    inner = f"{counted} WHERE {{ {found} }} GROUP BY {scope.focus}"
    return (f"OPTIONAL {{ {inner} }} FILTER(COALESCE({number}, 0) < {least})",)


def _more(scope: ShapeScope, end: str, found: str, most: int) -> tuple[str, ...]:
    """Return groups that hold if *found* binds *end* to more than *most* terms."""
    if most == 0:
        return (f"FILTER EXISTS {{ {found} }}",)
    having = f"HAVING (COUNT(DISTINCT {end}) > {most})"
    return (f"SELECT {scope.focus} WHERE {{ {found} }} GROUP BY {scope.focus} {having}",)


def _qualified(scope: ShapeScope, name: str) -> Iterator[tuple[int, str, str, str]]:
    shape = scope.shape
    wanted = shape.values("qualifiedValueShape")
    for number in _numbers(scope, name) if wanted else ():
        for qualifier in wanted:
            end = scope.fresh()
            conditions = [scope.conforms(qualifier, end)]
            if shape.graph.is_true(shape.node, sh("qualifiedValueShapesDisjoint")):
                others = _siblings(scope, qualifier)
                conditions += [f"!{scope.conforms(other, end)}" for other in others]
            reached = f"{{ {scope.value_pattern(end)} }}"
            found = f"{reached} LATERAL {{ FILTER({' && '.join(conditions)}) }}"
            yield number, end, found, shown(shape, qualifier)


def _siblings(scope: ShapeScope, qualifier: Term) -> list[Term]:
    """Return the other qualified value shapes of the parents of a shape: SHACL 4.7.3."""
    graph = scope.shape.graph
    found = {
        sibling: None
        for parent in graph.referrers(sh("property"), scope.shape.node)
        for each in graph.values(parent, sh("property"))
        for sibling in graph.values(each, sh("qualifiedValueShape"))
        if sibling != qualifier
    }
    return list(found)


def _numbers(scope: ShapeScope, name: str) -> Iterator[int]:
    shape = scope.shape
    for value in shape.values(name):
        if not shape.path:
            if name.startswith("qualified"):
                continue
            raise shape.graph.invalid(shape.node, f"a node shape cannot have sh:{name}")
        if not is_literal(value) or literal_datatype(value) != f"{XSD}integer":
            raise shape.graph.invalid(shape.node, f"sh:{name} is not an xsd:integer: {value}")
        try:
            yield int(literal_value(value))
        except ValueError:
            cause = f"sh:{name} is not a whole number that can be counted to"
            raise shape.graph.invalid(shape.node, cause) from None
