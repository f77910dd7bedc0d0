"""Starts a query from the nodes that can violate it, where these are targets anyway."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import count
from typing import TYPE_CHECKING

from kinlint.engine.compiler.shacl_terms import SUBCLASS, TYPE
from kinlint.engine.compiler.shape_scope import THIS
from kinlint.light_dataclasses import replace
from kinlint.sparql.ast import Bind, Clause, Element, Filter, Group, Select, Triples
from kinlint.sparql.patterns import patterns
from kinlint.sparql.variables import variables, words

if TYPE_CHECKING:
    from kinlint.engine.compiler.target import Target
    from kinlint.terms import Triple

_AGGREGATES = {"COUNT", "SUM", "MIN", "MAX", "AVG", "SAMPLE", "GROUP_CONCAT"}
_CUTS = {"LIMIT", "OFFSET", "ORDER"}


def implying_premises(target: Target, premises: Sequence[Triple]) -> tuple[Triple, ...]:
    """Return those of *premises*, which every violation matches, that make `$this` one of *target*.

    Empty if it takes more to be one.
    """
    classes = {value for _, predicate, value in target.ways if predicate == TYPE}
    said = {predicate for subject, predicate, _ in target.ways if subject == THIS} - {TYPE}
    meant = {predicate for subject, predicate, _ in target.ways if subject != THIS}
    for each in premises:
        subject, path, value = each
        if path == TYPE and subject == THIS:
            if value in classes:
                return (each,)
            above = ((value, f"{SUBCLASS}*", kind) for kind in classes)
            if found := next((pattern for pattern in above if pattern in premises), None):
                return (each, found)
        steps = set(path.split("|"))
        if (subject == THIS and steps <= said) or (value == THIS and steps <= meant):
            return (each,)
    return ()


def narrowed(target: Target, premises: Sequence[Triple]) -> Target:
    """Return *target*, looked for by what of *premises* makes a node one."""
    found = implying_premises(target, premises)
    if not found:
        return target
    text = " . ".join(" ".join(each) for each in found)
    return replace(target, all=f"{{ SELECT DISTINCT {THIS} WHERE {{ {text} }} }}")


def runs_without_focus(select: Select) -> bool:
    """Tell whether *select* finds the same if nothing binds `$this` before.

    So it is where its own patterns bind it first and hang together, and everything after these
    looks at single solutions.
    """
    first, *others = select.group.elements or (Filter(()),)
    return (
        isinstance(first, Triples)
        and _connected(first)
        and all(map(_alone, others))
        and _each(select)
    )


def _connected(block: Triples) -> bool:
    """Tell whether each pattern of *block* shares a variable with earlier ones, first `$this`."""
    known = {THIS}
    for each in patterns(block.tokens, count(4000)):
        if each.closes or not each.variables & known:
            return False
        known |= each.variables
    return True


def _alone(element: Element) -> bool:
    match element:
        case Filter() | Bind() | Clause(("LATERAL",), _):
            return True
        case Clause((word,), Group(elements)) if word.upper() == "OPTIONAL":
            return all(isinstance(each, (Triples, Filter)) for each in elements)
        case _:
            return False


def _each(select: Select) -> bool:
    """Tell whether the solutions of each focus node stay separate from those of others."""
    tail = [word.upper() for word in words(select.tail)]
    if not tail:
        return _AGGREGATES.isdisjoint(word.upper() for word in words(select.head))
    grouped = variables(select.tail[: tail.index("HAVING")] if "HAVING" in tail else select.tail)
    return tail[0] == "GROUP" and THIS in grouped and _CUTS.isdisjoint(tail)
