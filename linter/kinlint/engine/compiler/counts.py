"""Constraint components that count value nodes: SHACL 4.2 and 4.7.3."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from kinlint.engine.compiler.frame import Frame, Violation, component, shown
from kinlint.engine.compiler.names import sh
from kinlint.terms import XSD, is_literal, literal_datatype, literal_value

if TYPE_CHECKING:
    from kinlint.terms import Term


def min_count(frame: Frame) -> Iterator[Violation]:
    """`sh:minCount`."""
    for least in _numbers(frame, "minCount"):
        if least < 1:
            continue
        message = f"There are fewer than {least} values." if least > 1 else "There is no value."
        yield Violation(
            component("MinCount"),
            _fewer(frame, frame.out, frame.reach(frame.out), least),
            messages=(message,),
        )


def max_count(frame: Frame) -> Iterator[Violation]:
    """`sh:maxCount`."""
    for most in _numbers(frame, "maxCount"):
        message = f"There are more than {most} values." if most else "There is a value."
        groups = _more(frame, frame.out, frame.reach(frame.out), most)
        yield Violation(component("MaxCount"), groups, messages=(message,))


def qualified_min(frame: Frame) -> Iterator[Violation]:
    """`sh:qualifiedMinCount`."""
    for least, end, found, name in _qualified(frame, "qualifiedMinCount"):
        if least > 0:
            text = f"There are fewer than {least} values that conform to '{name}'."
            groups = _fewer(frame, end, found, least)
            yield Violation(component("QualifiedMinCount"), groups, messages=(text,))


def qualified_max(frame: Frame) -> Iterator[Violation]:
    """`sh:qualifiedMaxCount`."""
    for most, end, found, name in _qualified(frame, "qualifiedMaxCount"):
        text = f"There are more than {most} values that conform to '{name}'."
        groups = _more(frame, end, found, most)
        yield Violation(component("QualifiedMaxCount"), groups, messages=(text,))


def _fewer(frame: Frame, end: str, found: str, least: int) -> tuple[str, ...]:
    """Groups that hold if *found* binds *end* to fewer than *least* terms."""
    if least == 1:
        return (f"FILTER NOT EXISTS {{ {found} }}",)
    number = frame.fresh()
    counted = f"SELECT {frame.focus} (COUNT(DISTINCT {end}) AS {number})"
    inner = f"{counted} WHERE {{ {found} }} GROUP BY {frame.focus}"
    return (f"OPTIONAL {{ {inner} }} FILTER(COALESCE({number}, 0) < {least})",)


def _more(frame: Frame, end: str, found: str, most: int) -> tuple[str, ...]:
    """Groups that hold if *found* binds *end* to more than *most* terms."""
    if most == 0:
        return (f"FILTER EXISTS {{ {found} }}",)
    having = f"HAVING (COUNT(DISTINCT {end}) > {most})"
    return (f"SELECT {frame.focus} WHERE {{ {found} }} GROUP BY {frame.focus} {having}",)


def _qualified(frame: Frame, name: str) -> Iterator[tuple[int, str, str, str]]:
    shape = frame.shape
    wanted = shape.values("qualifiedValueShape")
    for number in _numbers(frame, name) if wanted else ():
        for qualifier in wanted:
            end = frame.fresh()
            conditions = [frame.conforms(qualifier, end)]
            if shape.graph.is_true(shape.node, sh("qualifiedValueShapesDisjoint")):
                others = _siblings(frame, qualifier)
                conditions += [f"!{frame.conforms(other, end)}" for other in others]
            reached = f"{{ {frame.reach(end)} }}"
            found = f"{reached} LATERAL {{ FILTER({' && '.join(conditions)}) }}"
            yield number, end, found, shown(shape, qualifier)


def _siblings(frame: Frame, qualifier: Term) -> list[Term]:
    """The other qualified value shapes of the parents of a shape: SHACL 4.7.3."""
    graph = frame.shape.graph
    found = {
        sibling: None
        for parent in graph.referrers(sh("property"), frame.shape.node)
        for each in graph.values(parent, sh("property"))
        for sibling in graph.values(each, sh("qualifiedValueShape"))
        if sibling != qualifier
    }
    return list(found)


def _numbers(frame: Frame, name: str) -> Iterator[int]:
    shape = frame.shape
    for value in shape.values(name):
        if not shape.path:
            if name.startswith("qualified"):
                continue
            raise shape.graph.invalid(shape.node, f"a node shape cannot have sh:{name}")
        if not is_literal(value) or literal_datatype(value) != f"{XSD}integer":
            raise shape.graph.invalid(shape.node, f"sh:{name} is not an xsd:integer: {value}")
        yield int(literal_value(value))
