"""Restricts a lifting query to some values of one of its variables."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count

from kinlint.formats.records import ELEMENTS
from kinlint.incremental.dependency_paths import Path, PatternPath, paths_to
from kinlint.light_dataclasses import dataclass
from kinlint.sparql.ast import Group, Triples
from kinlint.sparql.patterns import patterns
from kinlint.sparql.tokens import is_variable


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
