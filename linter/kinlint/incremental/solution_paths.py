"""Paths between variables of a query, through what holds wherever one of them is bound."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence

from kinlint.engine.constraint import PLAIN
from kinlint.light_dataclasses import dataclass, replace
from kinlint.sparql.ast import Expression
from kinlint.sparql.tokens import is_variable
from kinlint.terms import Term


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


Steps = tuple[tuple[Path, bool], ...]
"""The paths taken, and whether each is taken from object to subject."""


@dataclass(frozen=True, slots=True)
class Alias:
    """A variable that is bound to what one of others is bound to."""

    variable: str
    """The variable."""
    origins: tuple[str, ...]
    """The others, of which the first that is bound counts."""


@dataclass(frozen=True, slots=True)
class Context:
    """Patterns and bindings that hold in each solution of a group."""

    edges: tuple[Edge, ...] = ()
    """Patterns that hold."""
    aliases: tuple[Alias, ...] = ()
    """Variables that repeat others."""
    unions: tuple[tuple[Context, ...], ...] = ()
    """Alternatives, of each of which one holds."""
    optional: tuple[Context, ...] = ()
    """Contexts of optional groups: each holds where a variable is bound that only it binds."""

    def __add__(self, other: Context) -> Context:
        return Context(
            self.edges + other.edges,
            self.aliases + other.aliases,
            self.unions + other.unions,
            self.optional + other.optional,
        )

    def has(self, variable: str) -> bool:
        """Tell whether a pattern that holds has *variable*."""
        return any(variable in (each.subject, each.object) for each in self.edges)

    def binds(self, variable: str) -> bool:
        """Tell whether *variable* is bound for certain."""
        return (
            self.has(variable)
            or any(all(each.binds(variable) for each in union) for union in self.unions)
            or any(
                alias.variable == variable and any(map(self._without(alias).binds, alias.origins))
                for alias in self.aliases
            )
        )

    def _without(self, alias: Alias) -> Context:
        return replace(self, aliases=tuple(each for each in self.aliases if each is not alias))

    def paths(self, start: str, root: str) -> Sequence[Steps] | None:
        """Return paths that lead from *start* to *root*, one of them in each solution.

        None if there are none.
        """
        reached: dict[str, Steps] = {start: ()}
        waiting = deque([start])
        while waiting:
            at = waiting.popleft()
            if at == root:
                return [reached[at]]
            for path, end, back in self._from(at):
                if is_variable(end) and end not in reached:
                    reached[end] = (*reached[at], (path, back))
                    waiting.append(end)
        for at, steps in reached.items():
            for alternatives in self._alternatives(at):
                found = [each.paths(name, root) for name, each in alternatives]
                if found and None not in found:
                    return [(*steps, *rest) for some in found for rest in some or ()]
        return None

    def _from(self, at: str) -> Iterator[tuple[Path, str, bool]]:
        for edge in self.edges:
            if edge.subject == at:
                yield edge.path, edge.object, False
            if edge.object == at:
                yield edge.path, edge.subject, True

    def _alternatives(self, variable: str) -> Iterator[list[tuple[str, Context]]]:
        """Yield lists of variables that *variable* is one of, each with what holds where it is."""
        for alias in self.aliases:
            if alias.variable == variable and self.binds(variable):
                rest = self._without(alias)
                yield [each for name in alias.origins for each in rest._where_bound(name)]  # noqa: SLF001
        for union in self.unions:
            if all(each.binds(variable) for each in union):
                others = tuple(each for each in self.unions if each is not union)
                rest = replace(self, unions=others)
                yield [(variable, rest + each) for each in union]

    def _where_bound(self, variable: str) -> list[tuple[str, Context]]:
        """Return *variable* with what holds where it is bound, for each group that may bind it."""
        optional = [each for each in self.optional if each.has(variable)]
        if self.binds(variable) or not optional:
            return [(variable, self)]
        return [(variable, self + each) for each in optional]


def first_bound(expression: Expression) -> tuple[str, ...]:
    """Return the variables of which *expression* is the first that is bound; none for any other."""
    words = [each for each in expression if isinstance(each, str)]
    if len(words) == len(expression) == 1 and is_variable(words[0]):
        return (words[0],)
    if len(words) < len(expression) or words[:1] != ["COALESCE"]:
        return ()
    variables, commas = words[2:-1:2], words[3:-1:2]
    simple = all(map(is_variable, variables)) and all(each == "," for each in commas)
    return tuple(variables) if simple else ()
