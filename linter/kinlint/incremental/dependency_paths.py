"""Dependency paths of a query: from each of its patterns to the target node."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from itertools import count

from kinlint.engine.constraint import PLAIN
from kinlint.light_dataclasses import dataclass
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
from kinlint.terms import Term

REQUIRED = frozenset({"LATERAL", "GRAPH"})


@dataclass(frozen=True, slots=True)
class Path:
    """The edges that a property path takes."""

    terms: frozenset[Term] | None
    """The properties of the edges; None for any."""
    plain: bool
    """True if the path takes one edge from subject to object; else any number in any direction."""

    @classmethod
    def from_words(cls, words: Sequence[str]) -> Path:
        """Return the edges of the path that is spelled by *words*."""
        named = frozenset(word for word in words if PLAIN.fullmatch(word))
        if is_variable(words[0]):
            return cls(None, plain=True)
        plain = all(word == "|" or word in named for word in words)
        return cls(None if "!" in words else named, plain=plain)


@dataclass(frozen=True, slots=True)
class Edge:
    """A pattern of a query between two of its variables or terms."""

    subject: str
    """Variable or term."""
    path: Path
    """Path from subject to object."""
    object: str
    """Variable or term."""


@dataclass(frozen=True, slots=True)
class PatternPath:
    """A pattern of a query, and how the target is reached from it."""

    edge: Edge
    """The pattern."""
    from_object: bool
    """True if the way begins at the object of the pattern; else at its subject."""
    steps: tuple[tuple[Path, bool], ...] | None
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
        reader.read(group, (), _Scope())
    except _Unseen:
        return None
    return tuple(_sight(edge, context, root) for edge, context in reader.found)


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
        self.found: list[tuple[Edge, tuple[Edge, ...]]] = []
        self._numbers = count(1000, 1000)
        self._scopes: list[_Scope] = []

    def read(self, group: Group, outer: tuple[Edge, ...], scope: _Scope) -> None:
        """Collect those of *group*, in which what *outer* has holds."""
        self._scopes.append(scope)
        own, inner = list[Edge](), list[tuple[Group, _Scope]]()
        self._require(group, scope, own, inner)
        context = (*outer, *own)
        self.found += [(edge, context) for edge in own]
        for each, within in inner:
            self.read(each, context, within)

    def _require(
        self, group: Group, scope: _Scope, own: list[Edge], inner: list[tuple[Group, _Scope]]
    ) -> None:
        """Sort what *group* needs to hold from the groups in it that it does without."""
        for each in group.elements:
            match each:
                case Triples(words):
                    own += self._edges(words, scope)
                case Select():
                    within = self._within(each, scope)
                    self._require(each.group, within, own, inner)
                    parts = (*each.head, *each.tail)
                    inner += [(part, within) for part in parts if isinstance(part, Group)]
                case Union((branch,)):
                    self._require(branch, scope, own, inner)
                case Union(branches):
                    inner += [(branch, scope) for branch in branches]
                case Clause(head, part) if head[0].upper() in REQUIRED:
                    self._require(part, scope, own, inner)
                case Clause(_, part):
                    inner.append((part, scope))
                case Filter(expression) | Bind(expression, _):
                    inner += [(part, scope) for part in expression if isinstance(part, Group)]
                case _:
                    pass

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


def _sight(edge: Edge, context: Sequence[Edge], root: str) -> PatternPath:
    """Return the shortest way from *edge* to *root* by what *context* has."""
    waiting = deque[tuple[str, tuple[tuple[Path, bool], ...], bool]]()
    for end, from_object in ((edge.subject, False), (edge.object, True)):
        if is_variable(end):
            waiting.append((end, (), from_object))
    seen = {end for end, _, _ in waiting}
    while waiting:
        at, steps, from_object = waiting.popleft()
        if at == root:
            return PatternPath(edge, from_object, steps)
        for other in context:
            if other is edge:
                continue
            for start, end, back in (
                (other.subject, other.object, False),
                (other.object, other.subject, True),
            ):
                if start == at and is_variable(end) and end not in seen:
                    seen.add(end)
                    waiting.append((end, (*steps, (other.path, back)), from_object))
    return PatternPath(edge, from_object=False, steps=None)
