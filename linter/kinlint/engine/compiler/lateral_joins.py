"""Lateral joins: blocks after a BIND or UNION that start from the bindings before them."""

from __future__ import annotations

from kinlint.sparql.ast import Bind, Clause, Element, Filter, Group, Triples, Union
from kinlint.sparql.variables import variables, visible

_BLOCK = (Triples, Filter)


def with_lateral_joins(group: Group) -> Group:
    """Return *group* with LATERAL before patterns that would else be matched from nothing.

    Oxigraph orders the patterns of one block well, but joins one block with another by matching
    both. For patterns, LATERAL is the same join; for branches of UNION, where nothing in them looks
    at variables that they do not bind themselves, or binds one that is bound already. A block that
    shares a blank node with another is left as it is.
    """
    elements: list[Element] = []
    seen: set[str] = set()
    apart = False
    for at, each in enumerate(group.elements):
        rest = (*group.elements[:at], *group.elements[at + 1 :])
        shares = not seen.isdisjoint(visible(each)) and _labels(each).isdisjoint(_labels(rest))
        if shares and _may_wait(each, seen, apart=apart):
            elements.append(Clause(("LATERAL",), Group((each,))))
        else:
            elements.append(each)
        apart = apart or not isinstance(each, _BLOCK)
        seen |= visible(each)
    return Group(tuple(elements))


def _labels(elements: Element | tuple[Element, ...]) -> set[str]:
    """Return the blank nodes that the blocks among *elements* name, which no other group can."""
    blocks = elements if isinstance(elements, tuple) else (elements,)
    words = (word for each in blocks if isinstance(each, Triples) for word in each.tokens)
    return {word for word in words if word.startswith("_:")}


def _may_wait(element: Element, seen: set[str], *, apart: bool) -> bool:
    """Tell whether *element* means the same if what stands before it, *seen*, is bound already."""
    if isinstance(element, Union):
        return all(_closed(branch, seen) for branch in element.branches)
    return apart and isinstance(element, Triples)


def _closed(branch: Group, seen: set[str]) -> bool:
    """Tell whether *branch* needs nothing that is bound before it.

    It is patterns, conditions on what these bind, and values new to *seen*.
    """
    own = {name for each in branch.elements if _is_block(each) for name in visible(each)}
    bound: set[str] = set()
    for each in branch.elements:
        match each:
            case Filter(expression):
                known = variables(expression) <= own | visible(branch) - seen
            case Bind(expression, variable):
                known = variables(expression) <= bound and variable not in seen
            case _:
                known = _is_block(each)
        if not known:
            return False
        bound |= visible(each)
    return True


def _is_block(element: Element) -> bool:
    match element:
        case Triples() | Clause(("LATERAL",), Group((Triples(),))):
            return True
        case _:
            return False
