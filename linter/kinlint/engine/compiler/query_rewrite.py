"""Rewrites queries for Oxigraph, whose planner does not know what is bound around a group.

Four rewrites, none needed for a right answer. They spare Oxigraph work, most of it such
that grows with the square of the model (oxigraph#885). Whatever they do not fully understand stays
as it stands.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import count

from kinlint.engine.compiler.lateral_joins import with_lateral_joins
from kinlint.engine.compiler.listed_properties import with_listed_properties
from kinlint.engine.compiler.path_rewrite import with_closure_as_minus
from kinlint.light_dataclasses import replace
from kinlint.sparql.ast import (
    Bind,
    Clause,
    Element,
    Expression,
    Filter,
    Group,
    Select,
    Triples,
    Union,
)
from kinlint.sparql.patterns import Pattern, patterns
from kinlint.sparql.tokens import is_variable
from kinlint.sparql.variables import certain, projection, variables, visible


def rewritten_for_oxigraph(select: Select, bound: frozenset[str]) -> Select:
    """Return *select* with cheaper EXISTS; the variables *bound* have a value from outside."""
    names = count(1000)
    return with_listed_properties(
        replace(
            select,
            group=with_invariants_first(_group(select.group, bound, names), bound, names),
            tail=_expression(select.tail, bound | certain(select.group), names),
        )
    )


def _group(group: Group, bound: frozenset[str], names: count[int]) -> Group:
    within = bound | certain(group)
    elements = tuple(_element(each, within, bound, names) for each in group.elements)
    return with_lateral_joins(with_closure_as_minus(Group(elements), bound, certain(group), names))


def _element(
    element: Element, within: frozenset[str], bound: frozenset[str], names: count[int]
) -> Element:
    match element:
        case Filter(expression):
            return Filter(_expression(expression, within, names))
        case Bind(expression, _):
            return replace(element, expression=_expression(expression, within, names))
        case Union(branches):
            return Union(tuple(_group(branch, bound, names) for branch in branches))
        case Clause(head, group) if head[0].upper() == "OPTIONAL":
            return Clause(head, _group(group, bound, names))
        case Select(_, group, _):
            shown = bound & frozenset(projection(element))
            return replace(element, group=_group(group, shown, names))
        case _:
            return element


def _expression(expression: Expression, bound: frozenset[str], names: count[int]) -> Expression:
    """Return *expression* with every group in it, which can only follow EXISTS, rewritten."""
    return tuple(
        _exists(part, bound, names) if isinstance(part, Group) else part for part in expression
    )


def _exists(body: Group, bound: frozenset[str], names: count[int]) -> Group:
    """Return *body* with its patterns, or those of each branch of its UNION, in the best order."""
    inner = _group(body, bound, names)
    match inner.elements:
        case (Union(branches), *filters) if len(branches) > 1 and _are_filters(filters):
            alternatives = (Group((*each.elements, *filters)) for each in branches)
            return Group((Union(tuple(_chained(each, bound, names) for each in alternatives)),))
        case _:
            return _chained(inner, bound, names)


def _are_filters(elements: Iterable[Element]) -> bool:
    return all(isinstance(each, Filter) for each in elements)


def _chained(body: Group, bound: frozenset[str], names: count[int]) -> Group:
    """Return `{ A . B . FILTER F }` as `{ {A} LATERAL {F} LATERAL {B} }`, best order first.

    Each pattern then starts from terms that are known. A filter comes as soon as the patterns have
    bound all it may see of theirs, so it sees what it saw before.
    """
    if not all(isinstance(each, (Triples, Filter)) for each in body.elements):
        return body
    todo: list[Pattern] = []
    for each in body.elements:
        if isinstance(each, Triples):
            todo += patterns(each.tokens, names)
    waiting = [each for each in body.elements if isinstance(each, Filter)]
    own = frozenset().union(*(pattern.variables for pattern in todo))
    if len(todo) < 2 or not own & bound:  # noqa: PLR2004 - one pattern needs no order
        return body
    steps: list[Element] = []
    done: set[str] = set()
    while todo or waiting:
        ready = [each for each in waiting if variables(each) & own <= done]
        steps += ready
        waiting = [each for each in waiting if each not in ready]
        if todo:
            best = min(todo, key=lambda pattern: _cost(pattern, bound | done))
            todo.remove(best)
            done |= best.variables
            steps.append(Triples((best.subject, *best.path, best.object)))
    first, *rest = (Group((step,)) for step in steps)
    return Group((Union((first,)), *(Clause(("LATERAL",), step) for step in rest)))


def _cost(pattern: Pattern, bound: frozenset[str]) -> int:
    """Return how many matches of *pattern* to expect, in rough classes."""

    def known(term: str) -> bool:
        return term in bound or not is_variable(term)

    subject, value = known(pattern.subject), known(pattern.object)
    free_path = is_variable(pattern.path[0]) and pattern.path[0] not in bound
    if not (subject or value):
        return 90
    if subject and value:
        return 10 + 5 * pattern.closes
    variable = pattern.subject if subject else pattern.object
    rank = 20 if subject else 30
    return rank + 30 * (not is_variable(variable)) + 15 * pattern.closes + 5 * free_path


def with_invariants_first(group: Group, bound: frozenset[str], names: count[int]) -> Group:
    """Return *group* with its EXISTS filters that see nothing but *bound* evaluated first.

    Such a filter holds for all solutions of *group* or for none, so it may stand before them:

        { SELECT bound WHERE { a pattern } LIMIT 1 } LATERAL { filters } LATERAL { the rest }

    The sub-select spares the filters focus nodes that cannot have a solution.
    """
    own = visible(group) - bound
    early = tuple(
        each for each in group.elements if _has_exists(each) and not variables(each) & own
    )
    rest = tuple(each for each in group.elements if each not in early)
    first = next((each for each in rest if isinstance(each, Triples)), None)
    if not early or first is None:
        return group
    found = patterns(first.tokens, names)
    best = next((each for each in found if each.variables & bound and not each.closes), found[0])
    block = Group((Triples((best.subject, *best.path, best.object)),))
    some = Select(("SELECT", *sorted(bound)), block, ("LIMIT", "1"))
    return Group(
        (
            Union((Group((some,)),)),
            Clause(("LATERAL",), Group(early)),
            Clause(("LATERAL",), Group(rest)),
        )
    )


def _has_exists(element: object) -> bool:
    return isinstance(element, Filter) and any(
        isinstance(part, Group) for part in element.expression
    )
