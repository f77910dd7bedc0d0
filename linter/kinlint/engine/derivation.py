"""Derivations of the values that a lifting query makes, read off the query.

The object of a template triple is bound by a pattern of the WHERE, `?limit at:lower ?lower`, or
worked out from such variables by BIND. Both are known before anything is read.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property, lru_cache
from itertools import count
from typing import TypeAlias

from kinlint.document import FROM
from kinlint.engine.construct_template import Made, trimmed
from kinlint.engine.lifting import Lifting
from kinlint.formats.records import ELEMENTS
from kinlint.light_dataclasses import dataclass, field
from kinlint.sparql.ast import Bind, Expression, Group, Triples, joined, render
from kinlint.sparql.expression_tokens import arguments, end, unwrapped
from kinlint.sparql.patterns import Pattern, patterns, spelled_out
from kinlint.sparql.tokens import is_variable
from kinlint.sparql.variables import variables
from kinlint.terms import RDF_TYPE, Term

_ELEMENTS = tuple(f"<{each}" for each in ELEMENTS)


@dataclass(frozen=True, slots=True)
class Read:
    """A value that a pattern binds."""

    element: str
    """The variable for the node that has the value."""
    properties: tuple[Term, ...]
    """The properties that it may have it by."""
    value: str
    """The variable for the value."""


@dataclass(frozen=True, slots=True)
class First:
    """COALESCE: the first of several derivations that has a value."""

    parts: tuple[tuple[str, Derivation], ...]
    """Each with the variable that is bound if it has one, "" for one that always has."""


@dataclass(frozen=True, slots=True)
class Choice:
    """IF."""

    test: str
    """The variable that is bound to the condition."""
    then: Derivation
    """The value if the condition holds."""
    otherwise: Derivation
    """The value if it does not."""


@dataclass(frozen=True, slots=True)
class Negation:
    """The negative of a number."""

    part: Derivation
    """The number."""


@dataclass(frozen=True, slots=True)
class Combination:
    """A value worked out from all of its parts, in a way that is not analysed."""

    parts: tuple[Derivation, ...] = ()
    """The values that it is worked out from."""
    alike: bool = False
    """True if each part is the value, where it has one: of joined patterns, or of branches."""


Derivation: TypeAlias = Read | First | Choice | Negation | Combination
CONSTANT = Combination()


@dataclass(frozen=True, slots=True)
class Stated:
    """A template triple whose object, or a member of it, is read somewhere."""

    made: Made
    """The template triple."""
    members: tuple[Derivation, ...]
    """The derivation of the object, or of each member of a list."""


@dataclass
class Derivations:
    """The derivations of the values of one lifting query."""

    lifting: Lifting
    """The lifting query."""
    probes: dict[str, str] = field(default_factory=dict)
    """The expressions that a run has to work out, by the variables that stand for them."""

    @cached_property
    def stated(self) -> Sequence[Stated]:
        """The template triples that some text has the value of."""
        found = []
        values = (each for each in self.lifting.made if each.predicate not in {FROM, RDF_TYPE})
        for made in values:
            members = tuple(self._term(each) for each in made.items or (made.object,))
            if any(reads(each) for each in members):
                found.append(Stated(made, members))
        return found

    @cached_property
    def select(self) -> str:
        """The query for the variables of all derivations, and of the triples that they make."""
        names = set[str]()
        for each in self.stated:
            names.update(each.made.variables, *map(_named, each.members))
        plain = names - self.probes.keys()
        worked = [f"({text} AS {name})" for name, text in self.probes.items() if name in names]
        used = plain.union(*(_variables(self.probes[each]) for each in names - plain))
        where = render(trimmed(self._where, used))
        return f"SELECT {' '.join((*sorted(plain), *worked))} WHERE {where}"

    def leading_to(self, variable: str) -> frozenset[Term]:
        """Return the properties that lead to the elements that *variable* may be."""
        chosen = (
            self.leading_to(word)
            for each in self.assignments
            if each.variable == variable
            for word in variables(each.expression)
        )
        found = (way for each in self.patterns if each.object == variable for way in each.path)
        return frozenset(way for way in found if way.startswith(_ELEMENTS)).union(*chosen)

    def holder(self, variable: str) -> tuple[str, Term] | None:
        """Return the variable for the element around *variable*, and the property between them.

        None for a root. Of the elements that COALESCE chooses from, the first counts.
        """
        for each in self.assignments:
            chosen = self._expression(each.expression) if each.variable == variable else None
            if isinstance(chosen, First) and is_variable(chosen.parts[0][0]):
                return self.holder(chosen.parts[0][0])
        for found in self.patterns:
            if found.object == variable and found.path[0].startswith(_ELEMENTS):
                return found.subject, found.path[0]
        return None

    def _term(self, term: str) -> Derivation:
        return self._variable(term) if is_variable(term) else CONSTANT

    def _variable(self, name: str) -> Derivation:
        """Return how the variable *name* is bound."""
        bound = (self._expression(e.expression) for e in self.assignments if e.variable == name)
        read = [
            Read(each.subject, properties, name)
            for each in self.patterns
            if each.object == name and is_variable(each.subject) and (properties := _valued(each))
        ]
        found = tuple(dict.fromkeys((*bound, *read)))
        return found[0] if len(found) == 1 else Combination(found, alike=bool(found))

    def _expression(self, expression: Expression) -> Derivation:
        words = unwrapped(expression)
        verb = str(words[0]).upper()
        if len(words) == 1:
            return self._term(str(words[0]))
        if verb == "-" and len(unwrapped(words[1:])) == 1:
            return Negation(self._expression(words[1:]))
        if verb in {"IF", "COALESCE"} and end(words, 1) == len(words):
            return self._call(verb, arguments(words[2:-1]))
        return Combination(tuple(self._parts(words)))

    def _call(self, verb: str, given: Sequence[Expression]) -> Derivation:
        if verb == "COALESCE":
            return First(tuple((self._probe(each), self._expression(each)) for each in given))
        condition, then, otherwise = given
        return Choice(
            self._noted(f"IF ({render(condition)}, true, false)"),
            self._expression(then),
            self._expression(otherwise),
        )

    def _parts(self, words: Expression) -> Iterator[Derivation]:
        """Yield how each variable and each choice in an expression comes about."""
        at = 0
        while at < len(words):
            word = words[at]
            if isinstance(word, str) and word.upper() in {"IF", "COALESCE"}:
                after = end(words, at + 1)
                yield self._expression(words[at:after])
                at = after
                continue
            if isinstance(word, str) and is_variable(word):
                yield self._variable(word)
            at += 1

    def _probe(self, argument: Expression) -> str:
        """Return the variable that is bound if *argument* has a value; "" for a constant."""
        words = unwrapped(argument)
        named = self._noted(render(argument)) if len(words) > 1 else str(words[0])
        return named if variables(words) else ""

    def _noted(self, text: str) -> str:
        """Return the variable that stands for the expression *text*."""
        names = {each: name for name, each in self.probes.items()}
        name = names.get(text) or f"?p_{len(names)}"
        self.probes[name] = text
        return name

    @cached_property
    def _where(self) -> Group:
        """The WHERE of the query, with a variable for each node on a path."""
        return spelled_out(self.lifting.where, count())

    @cached_property
    def assignments(self) -> Sequence[Bind]:
        """The BINDs of the query, those of joined groups included."""
        return [each for each in joined(self._where) if isinstance(each, Bind)]

    @cached_property
    def patterns(self) -> Sequence[Pattern]:
        """The triple patterns of the query, filters left out."""
        return [
            pattern
            for each in joined(self._where)
            if isinstance(each, Triples)
            for pattern in patterns(each.tokens, count())
        ]


@lru_cache(maxsize=128)
def derivations(lifting: Lifting) -> Derivations:
    """Return how the values of the query *lifting* come about."""
    return Derivations(lifting)


def reads(derivation: Derivation) -> Sequence[Read]:
    """Return what *derivation* may be read from, conditions left out."""
    match derivation:
        case Read():
            return (derivation,)
        case First(parts):
            inner = tuple(each for _, each in parts)
        case Choice(_, then, otherwise):
            inner = (then, otherwise)
        case Negation(part):
            inner = (part,)
        case Combination(parts):
            inner = parts
    return [read for each in inner for read in reads(each)]


def _named(derivation: Derivation) -> set[str]:
    """Return the variables that tell how a value comes about."""
    match derivation:
        case Read(element, _, value):
            return {element, value}
        case First(parts):
            probes = {probe for probe, _ in parts if probe}
            return probes.union(*(_named(each) for _, each in parts))
        case Choice(test, then, otherwise):
            return {test}.union(*map(_named, (then, otherwise)))
        case Negation(part):
            return _named(part)
        case Combination(parts):
            return set[str]().union(*map(_named, parts))


def _variables(text: str) -> set[str]:
    return {word for word in text.split() if is_variable(word)}


def _valued(pattern: Pattern) -> tuple[Term, ...]:
    """Return the properties by which *pattern* may match a value; none where it is an element's."""
    if pattern.path[::2] != tuple(word for word in pattern.path if word[0] == "<"):
        return ()
    return tuple(each for each in pattern.path[::2] if not each.startswith(_ELEMENTS))
