"""Judges what depends on the focus node alone once for it, not for every solution."""

from __future__ import annotations

from itertools import count

from kinlint.sparql.ast import (
    Clause,
    Filter,
    Group,
    Select,
    Triples,
    Union,
)
from kinlint.sparql.patterns import patterns
from kinlint.sparql.variables import variables, visible


def with_invariants_first(group: Group, bound: frozenset[str], names: count[int]) -> Group:
    """Return *group* with its EXISTS filters that see nothing but *bound* evaluated first.

    Such a filter holds for all solutions of *group* or for none, so it may stand before them:

        { SELECT bound WHERE { a pattern } LIMIT 1 } LATERAL { filters } LATERAL { the rest }

    The sub-select spares the filters focus nodes that cannot have a solution.
    """
    own = visible(group) - bound
    early = tuple(each for each in group.elements if _exists(each) and not variables(each) & own)
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


def _exists(element: object) -> bool:
    return isinstance(element, Filter) and any(
        isinstance(part, Group) for part in element.expression
    )
