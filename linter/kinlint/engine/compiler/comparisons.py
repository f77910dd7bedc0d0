"""Constraint components that look at several values or at other properties: SHACL 4.4 to 4.8."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from kinlint.engine.compiler.frame import Frame, Violation, component, shown
from kinlint.engine.compiler.literals import comparison, constant
from kinlint.engine.compiler.names import sh
from kinlint.terms import Term, is_iri, literal_value

if TYPE_CHECKING:
    from kinlint.engine.compiler.shape import Shape


def has_value(frame: Frame) -> Iterator[Violation]:
    """`sh:hasValue`."""
    for value in frame.shape.values("hasValue"):
        wanted = constant(value)
        name = shown(frame.shape, value) if is_iri(value) else literal_value(value)
        if frame.shape.path:
            found = f"{{ {frame.reach(frame.out)} }} LATERAL {{ FILTER({_same(frame, wanted)}) }}"
            if not frame.shape.path.may_stay:
                steps = frame.shape.path.steps(frame.focus, wanted, frame.names)
                found = " LATERAL ".join(f"{{ {' '.join(step)} }}" for step in steps)
            missing = f"NOT EXISTS {{ {found} }}"
        else:
            missing = f"!sameTerm({frame.focus}, {wanted})"
        yield Violation(
            component("HasValue"),
            (),
            missing,
            messages=(f"The value '{name}' is missing.",),
        )


def _same(frame: Frame, term: Term) -> str:
    return f"sameTerm({frame.out}, {term})"


def unique_lang(frame: Frame) -> Iterator[Violation]:
    """`sh:uniqueLang`: one violation for each tag that several values have."""
    if not frame.shape.graph.is_true(frame.shape.node, sh("uniqueLang")):
        return
    value, tag = frame.out, frame.extra
    tagged = (
        f'FILTER(isLiteral({value}) && LANG({value}) != "") BIND(LCASE(LANG({value})) AS {tag})'
    )
    group = (
        f"SELECT {frame.focus} {tag} WHERE {{ {frame.reach(value)} {tagged} }} "
        f"GROUP BY {frame.focus} {tag} HAVING (COUNT(DISTINCT {value}) > 1)"
    )
    text = "Several values are tagged '{?other}'."
    yield Violation(component("UniqueLang"), (group,), shown=(tag,), messages=(text,))


def equals(frame: Frame) -> Iterator[Violation]:
    """`sh:equals`: violated by what only one of two properties has."""
    for other in frame.shape.values("equals"):
        focus, out = frame.focus, frame.out
        here = frame.reach(out) if frame.shape.path else f"BIND({focus} AS {out})"
        missing = (
            f"NOT EXISTS {{ {frame.reach(out)} }}"
            if frame.shape.path
            else f"!sameTerm({focus}, {out})"
        )
        there = f"SELECT DISTINCT {focus} {out} WHERE {{ {focus} {other} {out} }}"
        group = (
            f"{{ {{ {here} }} LATERAL {{ FILTER NOT EXISTS {{ {focus} {other} {out} }} }} }} "
            f"UNION {{ {{ {there} }} LATERAL {{ FILTER({missing}) }} }}"
        )
        text = f"Value '{{?value}}' is not shared with '{shown(frame.shape, other)}'."
        yield Violation(component("Equals"), (group,), shown=(out,), messages=(text,))


def less_than(frame: Frame) -> Iterator[Violation]:
    """`sh:lessThan`."""
    return _ordered(frame, "LessThan", "<", "less than")


def less_than_or_equals(frame: Frame) -> Iterator[Violation]:
    """`sh:lessThanOrEquals`."""
    return _ordered(frame, "LessThanOrEquals", "<=", "at most")


def _ordered(frame: Frame, name: str, operator: str, words: str) -> Iterator[Violation]:
    for other in frame.shape.values(name[0].lower() + name[1:]):
        limit = frame.extra
        there = f"SELECT DISTINCT {frame.focus} {limit} WHERE {{ {frame.focus} {other} {limit} }}"
        text = f"Value '{{?value}}' is not {words} '{{?other}}', a '{shown(frame.shape, other)}'."
        yield Violation(
            component(name),
            (*frame.each, there),
            f"!{comparison(frame.value, operator, limit)}",
            shown=(limit,),
            at_value=True,
            messages=(text,),
        )


def closed(frame: Frame) -> Iterator[Violation]:
    """`sh:closed`: violated by every value of a property that the shape does not list."""
    shape = frame.shape
    if not shape.graph.is_true(shape.node, sh("closed")):
        return
    known = dict.fromkeys(_listed(shape))
    allowed = f"FILTER({frame.path} NOT IN ({', '.join(known)}))" if known else ""
    found = f"{frame.value} {frame.path} {frame.out}"
    group = f"SELECT DISTINCT {found} WHERE {{ {found} {allowed} }}"
    text = "Property '{?path}' is not allowed here."
    yield Violation(
        component("Closed"),
        (*frame.each, group),
        shown=(frame.path, frame.out),
        messages=(text,),
    )


def _listed(shape: Shape) -> Iterator[Term]:
    for each in shape.values("property"):
        yield from (path for path in shape.graph.values(each, sh("path")) if is_iri(path))
    for head in shape.values("ignoredProperties"):
        yield from shape.graph.list(head)
