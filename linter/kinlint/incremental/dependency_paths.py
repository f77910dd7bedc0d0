"""Dependency paths of a query: from each of its patterns to the target node."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache
from itertools import count

from kinlint.incremental.solution_paths import Alias, Context, Edge, Path, Steps, first_bound
from kinlint.light_dataclasses import dataclass, replace
from kinlint.sparql.ast import (
    Bind,
    Clause,
    Filter,
    Group,
    Select,
    Triples,
    Union,
)
from kinlint.sparql.parser import parse
from kinlint.sparql.patterns import patterns
from kinlint.sparql.tokens import is_variable, tokens
from kinlint.sparql.variables import projection

REQUIRED = frozenset({"LATERAL", "GRAPH"})


@dataclass(frozen=True, slots=True)
class PatternPath:
    """A pattern of a query, and how the target is reached from it."""

    edge: Edge
    """The pattern."""
    from_object: bool
    """True if the way begins at the object of the pattern; else at its subject."""
    steps: Steps | None
    """The paths taken, and whether each is taken from object to subject; None for no way."""


@lru_cache(maxsize=512)
def pattern_paths(select: str) -> tuple[PatternPath, ...] | None:
    """Return how each pattern of *select* leads to its target; None where that does not matter.

    Where the target node is chosen by others than its own triples, each triple concerns all.
    """
    query = parse(tokens(select, {}))
    root = _root(query)
    return None if root is None else paths_to(query.group, root)


def paths_to(group: Group, root: str) -> tuple[PatternPath, ...] | None:
    """Return how each pattern of *group* leads to *root*; None where that does not matter."""
    reader = _Reader(root)
    try:
        reader.read(group, Context(), _Scope())
    except _Unseen:
        return None
    return tuple(each for edge, context in reader.found for each in _sights(edge, context, root))


class _Unseen(Exception):
    """A query takes some of many solutions, whatever its target."""


def _root(query: Select) -> str | None:
    """The variable inside *query* that it projects as `?root`."""
    words = [word for word in query.head if isinstance(word, str)]
    at = words.index("?root")
    alias = at > 1 and words[at - 1].upper() == "AS"
    return words[at - 2] if alias and is_variable(words[at - 2]) else None


class _Scope:
    """Names of the variables of a sub-select outside it; hidden ones have none.

    The names of the whole query are its own.
    """

    def __init__(self, outer: _Scope | None = None, shown: Iterable[str] = ()) -> None:
        self._outer = outer
        self._known = {each: outer.name(each) for each in shown} if outer is not None else {}

    def name(self, variable: str) -> str:
        """Return the name of *variable* that no other one has in the whole query."""
        if self._outer is None:
            return variable
        return self._known.setdefault(variable, f"{variable} {id(self)}")

    def name_end(self, end: str) -> str:
        """Return the name of a variable, or a term itself."""
        return self.name(end) if is_variable(end) else end


class _Reader:
    """Collects the patterns of a query, each with all that hold where it does."""

    def __init__(self, root: str) -> None:
        self.root = root
        self.found: list[tuple[Edge, Context]] = []
        self._numbers = count(1000, 1000)
        self._scopes: list[_Scope] = []

    def read(self, group: Group, outer: Context, scope: _Scope) -> None:
        """Collect those of *group*, in which what *outer* has holds."""
        self._scopes.append(scope)
        inner: list[tuple[Group, _Scope]] = []
        own = self._required(group, scope, inner)
        context = outer + own
        self.found += [(edge, context) for edge in own.edges]
        for each, within in inner:
            self.read(each, context, within)

    def _required(self, group: Group, scope: _Scope, inner: list[tuple[Group, _Scope]]) -> Context:
        """Return what *group* needs to hold; add what it does without to the *inner* groups."""
        own = Context()
        for each in group.elements:
            match each:
                case Triples(words):
                    own += Context(edges=tuple(self._edges(words, scope)))
                case Filter(expression) | Bind(expression, _):
                    inner += [(part, scope) for part in expression if isinstance(part, Group)]
                    own += Context(aliases=tuple(_aliases(each, scope)))
                case Select() | Union() | Clause():
                    own += self._joined(each, scope, inner)
                case _:
                    pass
        return own

    def _joined(
        self, part: Select | Union | Clause, scope: _Scope, inner: list[tuple[Group, _Scope]]
    ) -> Context:
        """Return what *part* with its groups needs to hold, as `_required` does."""
        match part:
            case Select(head, group, tail):
                within = self._within(part, scope)
                inner += [(each, within) for each in (*head, *tail) if isinstance(each, Group)]
                return self._required(group, within, inner)
            case Union((branch,)):
                return self._required(branch, scope, inner)
            case Union(branches):
                inner += [(branch, scope) for branch in branches]
                return Context(unions=(tuple(self._required(b, scope, []) for b in branches),))
            case Clause(head, group) if head[0].upper() in REQUIRED:
                return self._required(group, scope, inner)
            case Clause(head, group):
                inner.append((group, scope))
                optional = head[0].upper() == "OPTIONAL"
                return Context(optional=(self._required(group, scope, []),) if optional else ())

    def _within(self, select: Select, scope: _Scope) -> _Scope:
        shown = projection(select)
        words = [word.upper() for word in select.tail if isinstance(word, str)]
        if "LIMIT" in words and self.root not in map(scope.name, shown):
            raise _Unseen
        within = _Scope(scope, shown)
        self._scopes.append(within)
        return within

    def _edges(self, words: tuple[str, ...], scope: _Scope) -> Iterator[Edge]:
        for pattern in patterns(words, count(next(self._numbers))):
            yield Edge(
                scope.name_end(pattern.subject),
                Path.from_words(pattern.path),
                scope.name_end(pattern.object),
            )


def _aliases(part: Filter | Bind, scope: _Scope) -> Iterator[Alias]:
    """Yield the variable that *part* binds to one of others, if it does."""
    if isinstance(part, Bind) and (names := first_bound(part.expression)):
        yield Alias(scope.name(part.variable), tuple(map(scope.name, names)))


def _sights(edge: Edge, context: Context, root: str) -> Iterator[PatternPath]:
    """Yield the shortest ways from *edge* to *root* by what *context* has.

    One, or several of which one is there in each solution.
    """
    others = replace(context, edges=tuple(each for each in context.edges if each is not edge))
    ends = (end for end in ((edge.subject, False), (edge.object, True)) if is_variable(end[0]))
    found = [
        (len(ways), sum(map(len, ways)), from_object, ways)
        for end, from_object in ends
        if (ways := others.paths(end, root)) is not None
    ]
    if not found:
        yield PatternPath(edge, from_object=False, steps=None)
        return
    *_, from_object, ways = min(found, key=lambda each: each[:3])
    for steps in dict.fromkeys(ways):
        yield PatternPath(edge, from_object, steps)
