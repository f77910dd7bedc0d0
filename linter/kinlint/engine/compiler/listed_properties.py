"""Gives patterns the properties that a condition lists, so that only those are looked up."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import count

from kinlint.engine.constraint import PLAIN
from kinlint.light_dataclasses import replace
from kinlint.sparql.ast import Clause, Element, Expression, Filter, Group, Select, Triples, Union
from kinlint.sparql.ast import Values as Given
from kinlint.sparql.patterns import patterns
from kinlint.sparql.tokens import is_variable

_LISTED = 6
"""Number of tokens of the shortest condition: `( ?p IN ( :a`."""


def with_listed_properties(select: Select) -> Select:
    """Return *select* with VALUES before `?s ?p ?o` where `FILTER (?p IN (…))` stands beside it.

    Oxigraph would match all statements about `?s` first. The condition stays. Groups of EXISTS are
    left as they are.
    """
    return replace(select, group=_group(select.group))


def _group(group: Group) -> Group:
    listed = dict(filter(None, map(_listed, group.elements)))
    elements: list[Element] = []
    for each in map(_element, group.elements):
        named = sorted(_predicates(each) & listed.keys())
        elements += (Given(("VALUES", name, "{", *listed.pop(name), "}")) for name in named)
        elements.append(each)
    return Group(tuple(elements))


def _element(element: Element) -> Element:
    match element:
        case Union(branches):
            return Union(tuple(map(_group, branches)))
        case Clause(head, group) if head[0].upper() in ("OPTIONAL", "LATERAL"):
            return Clause(head, _group(group))
        case Select():
            return with_listed_properties(element)
        case _:
            return element


def _predicates(element: Element) -> set[str]:
    """Return the variables of *element* that stand for properties."""
    if not isinstance(element, Triples):
        return set()
    found = patterns(element.tokens, count(2000))
    return {each.path[0] for each in found if len(each.path) == 1 and is_variable(each.path[0])}


def _listed(element: Element) -> tuple[str, Sequence[str]] | None:
    """Return the variable of which *element* requires that it is one of some IRIs, and these."""
    if not isinstance(element, Filter) or len(element.expression) < _LISTED:
        return None
    bracket, name, word, opening, *rest = element.expression
    plain = bracket == opening == "(" and isinstance(name, str) and is_variable(name)
    if not plain or not isinstance(word, str) or word.upper() != "IN" or ")" not in rest:
        return None
    end = rest.index(")")
    iris = dict.fromkeys(each for each in rest[:end] if isinstance(each, str) and each != ",")
    if not all(map(PLAIN.fullmatch, iris)) or not _is_conjunct(rest[end + 1 :]):
        return None
    return str(name), [*iris]


def _is_conjunct(rest: Expression | Sequence[object]) -> bool:
    """Tell whether all alternatives in *rest*, what follows a condition, are within brackets."""
    depth = 0
    for each in rest:
        if each == "||" and not depth:
            return False
        depth += (each == "(") - (each == ")")
    return True
