"""Constraint components that look at several values or at other properties: SHACL 4.4 to 4.8."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from kinlint.engine.compiler.literal_conditions import comparison, constant
from kinlint.engine.compiler.shacl_terms import sh
from kinlint.engine.compiler.shape_scope import ShapeScope, Violation, component, shown
from kinlint.terms import Term, is_iri, literal_value

if TYPE_CHECKING:
    from kinlint.engine.compiler.shape import Shape


def has_value(scope: ShapeScope) -> Iterator[Violation]:
    """Yield the violations of `sh:hasValue`."""
    for value in scope.shape.values("hasValue"):
        wanted = constant(value)
        name = shown(scope.shape, value) if is_iri(value) else literal_value(value)
        if scope.shape.path:
            values = scope.value_pattern(scope.out)
            found = f"{{ {values} }} LATERAL {{ FILTER({_same(scope, wanted)}) }}"
            if not scope.shape.path.may_stay:
                steps = scope.shape.path.steps(scope.focus, wanted, scope.names)
                found = " LATERAL ".join(f"{{ {' '.join(step)} }}" for step in steps)
            missing = f"NOT EXISTS {{ {found} }}"
        else:
            missing = f"!sameTerm({scope.focus}, {wanted})"
        yield Violation(
            component("HasValue"),
            (),
            missing,
            messages=(f"The value '{name}' is missing.",),
        )


def _same(scope: ShapeScope, term: Term) -> str:
    return f"sameTerm({scope.out}, {term})"


def unique_lang(scope: ShapeScope) -> Iterator[Violation]:
    """Yield a violation of `sh:uniqueLang` for each tag that several values have."""
    if not scope.shape.graph.is_true(scope.shape.node, sh("uniqueLang")):
        return
    value, tag = scope.out, scope.extra
    tagged = (
        f'FILTER(isLiteral({value}) && LANG({value}) != "") BIND(LCASE(LANG({value})) AS {tag})'
    )
    group = (
        f"SELECT {scope.focus} {tag} WHERE {{ {scope.value_pattern(value)} {tagged} }} "
        f"GROUP BY {scope.focus} {tag} HAVING (COUNT(DISTINCT {value}) > 1)"
    )
    text = "Several values are tagged '{?other}'."
    yield Violation(component("UniqueLang"), (group,), shown=(tag,), messages=(text,))


def equals(scope: ShapeScope) -> Iterator[Violation]:
    """Yield the violations of `sh:equals`: values that only one of two properties has."""
    for other in scope.shape.values("equals"):
        focus, out = scope.focus, scope.out
        here = scope.value_pattern(out) if scope.shape.path else f"BIND({focus} AS {out})"
        missing = (
            f"NOT EXISTS {{ {scope.value_pattern(out)} }}"
            if scope.shape.path
            else f"!sameTerm({focus}, {out})"
        )
        there = f"SELECT DISTINCT {focus} {out} WHERE {{ {focus} {other} {out} }}"
        group = (
            f"{{ {{ {here} }} LATERAL {{ FILTER NOT EXISTS {{ {focus} {other} {out} }} }} }} "
            f"UNION {{ {{ {there} }} LATERAL {{ FILTER({missing}) }} }}"
        )
        text = f"Value '{{?value}}' is not shared with '{shown(scope.shape, other)}'."
        yield Violation(component("Equals"), (group,), shown=(out,), messages=(text,))


def less_than(scope: ShapeScope) -> Iterator[Violation]:
    """Yield the violations of `sh:lessThan`."""
    return _ordered(scope, "LessThan", "<", "less than")


def less_than_or_equals(scope: ShapeScope) -> Iterator[Violation]:
    """Yield the violations of `sh:lessThanOrEquals`."""
    return _ordered(scope, "LessThanOrEquals", "<=", "at most")


def _ordered(scope: ShapeScope, name: str, operator: str, words: str) -> Iterator[Violation]:
    for other in scope.shape.values(name[0].lower() + name[1:]):
        limit = scope.extra
        there = f"SELECT DISTINCT {scope.focus} {limit} WHERE {{ {scope.focus} {other} {limit} }}"
        text = f"Value '{{?value}}' is not {words} '{{?other}}', a '{shown(scope.shape, other)}'."
        yield Violation(
            component(name),
            (*scope.value_groups, there),
            f"!{comparison(scope.value, operator, limit)}",
            shown=(limit,),
            at_value=True,
            messages=(text,),
        )


def closed(scope: ShapeScope) -> Iterator[Violation]:
    """Yield a violation of `sh:closed` for every value of a property that is not listed."""
    shape = scope.shape
    if not shape.graph.is_true(shape.node, sh("closed")):
        return
    known = dict.fromkeys(_listed(shape))
    allowed = f"FILTER({scope.path} NOT IN ({', '.join(known)}))" if known else ""
    found = f"{scope.value} {scope.path} {scope.out}"
    group = f"SELECT DISTINCT {found} WHERE {{ {found} {allowed} }}"
    text = "Property '{?path}' is not allowed here."
    yield Violation(
        component("Closed"),
        (*scope.value_groups, group),
        shown=(scope.path, scope.out),
        messages=(text,),
    )


def _listed(shape: Shape) -> Iterator[Term]:
    for each in shape.values("property"):
        yield from (path for path in shape.graph.values(each, sh("path")) if is_iri(path))
    for head in shape.values("ignoredProperties"):
        yield from shape.graph.list(head)
