"""Rewrites "no path of any length leads there" so that each start is followed once."""

from __future__ import annotations

from itertools import count

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
from kinlint.sparql.variables import projection, variables, words

_PLAIN = (Triples, Bind, Union, Filter)


def with_closure_as_minus(
    group: Group, bound: frozenset[str], certain: frozenset[str], names: count[int]
) -> Group:
    """Return *group* with `FILTER NOT EXISTS { ?a p* ?b }` as a MINUS, where that means the same.

    As a filter, the closure is followed once for each pair of `?a` and `?b`. One of them must be an
    anchor, of which there are few: bound from outside, by BIND or by an aggregate. Then

        MINUS { { SELECT DISTINCT ?a WHERE { what binds ?a } } LATERAL { ?a p* ?b } }

    follows it once for each anchor. Elements that do not bind the anchor are left out of the
    sub-select: more anchors than the group has only add pairs that are true anyway.
    """
    if not all(isinstance(each, _PLAIN) for each in group.elements):
        return group
    elements = list(group.elements)
    for each in group.elements:
        if isinstance(each, Filter) and (pattern := _unreached(each.expression, names)):
            ends = (pattern.subject, pattern.object)
            anchor, guards = _anchor(elements, ends, bound, certain, star=pattern.path[-1] == "*")
            if anchor is not None:
                at = elements.index(each)
                elements[at : at + 1] = guards
                path = Triples((pattern.subject, *pattern.path, pattern.object))
                lateral = (*anchor, Clause(("LATERAL",), Group((path,)))) if anchor else (path,)
                elements.append(Clause(("MINUS",), Group(lateral)))
    return Group(tuple(elements))


def _unreached(expression: Expression, names: count[int]) -> Pattern | None:
    """Return the pattern of `NOT EXISTS { ?a p* ?b }`, if *expression* is that."""
    match expression:
        case (str(no), str(exists), Group((Triples(tokens),))) if (
            no.upper(),
            exists.upper(),
        ) == ("NOT", "EXISTS"):
            found = patterns(tokens, names)
            if len(found) == 1 and found[0].path[-1] in ("*", "+"):
                return found[0]
    return None


def _anchor(
    elements: list[Element],
    ends: tuple[str, str],
    bound: frozenset[str],
    certain: frozenset[str],
    *,
    star: bool,
) -> tuple[tuple[Element, ...] | None, list[Element]]:
    """Return the elements that bind the anchor among *ends*, and the filters then needed."""
    if not all(is_variable(end) for end in ends) or ends[0] == ends[1]:
        return None, []
    for anchor, other in (ends, ends[::-1]):
        if other not in certain or other in bound:
            continue
        if anchor in bound:
            return (), []
        source, computed = _source(elements, anchor, bound)
        if source is None or (computed and not star):
            continue
        shown = sorted({anchor, *bound})
        select = Select(("SELECT", "DISTINCT", *shown), Group(tuple(source)), ())
        # An anchor that could not be computed reaches `other` by no steps, so `p*` holds.
        guard = [Filter(("(", "BOUND", "(", anchor, ")", ")"))] if computed else []
        return (Union((Group((select,)),)), *guard), list(guard)
    return None, []


def _source(
    elements: list[Element], anchor: str, bound: frozenset[str]
) -> tuple[list[Element] | None, bool]:
    """Return the elements that bind *anchor* to few terms, and whether it may stay unbound."""
    needed = {anchor}
    chosen: list[Element] = []
    computed = few = False
    for each in reversed(elements):
        match each:
            case Bind(expression, variable) if variable in needed:
                if any(isinstance(part, Group) for part in expression):
                    return None, False
                needed |= variables(expression) - bound
                computed = True
                few = few or variables(expression) <= bound
                chosen.append(each)
            case Union((Group((Select() as select,)),)) if needed & set(projection(select)):
                few = few or "GROUP" in [str(word).upper() for word in select.tail]
                computed = True
                chosen.append(each)
            case Union() if needed & variables(each):
                return None, False
            case Triples() if needed & variables(each):
                chosen.append(each)
            case _:
                continue
    blank = any(word.startswith("_:") for each in chosen for word in words(each))
    return (chosen[::-1], computed) if few and not blank else (None, False)
