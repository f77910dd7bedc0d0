"""Restricts a lifting query to some values of one of its variables."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count

from kinlint.formats.records import ELEMENTS
from kinlint.incremental.dependency_paths import PatternPath, paths_to
from kinlint.incremental.solution_paths import Path
from kinlint.light_dataclasses import dataclass
from kinlint.sparql.ast import Clause, Element, Group, Triples, Union, Values
from kinlint.sparql.patterns import patterns
from kinlint.sparql.tokens import is_variable

GIVEN = "<kinlint:given>"
"""Stands in queries for the values that a variable may have."""


@dataclass(frozen=True, slots=True)
class Restriction:
    """A variable that each solution binds, and how each pattern of the query leads to it."""

    root: str
    """The variable."""
    pattern_paths: tuple[PatternPath, ...]
    """Path from each pattern to the variable."""


def find_restriction(group: Group) -> Restriction | None:
    """Return the variable of the query *group* to which the most of its patterns lead.

    It is one for elements; of several, the last: fewer solutions have the same. None where
    solutions depend on each other, or where nothing says that a variable is bound in each.
    """
    first = group.elements[0] if group.elements else None
    if not isinstance(first, Triples):
        return None
    found: Restriction | None = None
    fewest = 0
    for root in _elements(first):
        pattern_paths = paths_to(group, root)
        if pattern_paths is None:
            return None
        lost = sum(each.steps is None for each in pattern_paths)
        if found is None or lost <= fewest:
            found, fewest = Restriction(root, pattern_paths), lost
    return found


def _elements(first: Triples) -> Iterator[str]:
    """The variables for elements in the patterns *first*, which are bound in each solution."""
    for number, pattern in enumerate(patterns(first.tokens, count())):
        terms = Path.from_words(pattern.path).terms or frozenset()
        if not number and is_variable(pattern.subject):
            yield pattern.subject
        if is_variable(pattern.object) and any(term[1:].startswith(ELEMENTS) for term in terms):
            yield pattern.object


def restricted(group: Group, root: str) -> Group:
    """Return *group* with a place for the values that *root* may have, in all groups it joins.

    A store that evaluates such a group by itself does so for these values alone.
    """
    found = [_restricted(each, root) for each in group.elements]
    return Group((Values(("VALUES", root, "{", GIVEN, "}")), *found))


def _restricted(element: Element, root: str) -> Element:
    match element:
        case Union(branches):
            return Union(tuple(_within(each, root) for each in branches))
        case Clause(head, group) if head[0].upper() == "OPTIONAL":
            return Clause(head, _within(group, root))
        case _:
            return element


def _within(group: Group, root: str) -> Group:
    """Return a group inside of another, restricted where each solution of it binds *root*."""
    plain = (each for each in group.elements if isinstance(each, Triples))
    if any(root in each.tokens for each in plain):
        return restricted(group, root)
    return Group(tuple(_restricted(each, root) for each in group.elements))
