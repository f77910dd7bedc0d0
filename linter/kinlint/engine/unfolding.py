"""Unfold lifting queries that all formats share into queries over what files of one format say.

A shared query matches a record of the intermediate vocabulary, and the readings of a format make
such records: unfolding puts the WHERE of a reading in place of the record, so that no record has
to be stored. As views are unfolded in databases; of RDF, see Poggi et al., "Linking Data to
Ontologies", Journal on Data Semantics X, 2008, section 5.3.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import accumulate, count, takewhile

from kinlint.errors import RuleInvalid
from kinlint.light_dataclasses import dataclass, field
from kinlint.sparql.ast import Bind, Clause, Construct, Element, Expression, Filter, Group, Triples
from kinlint.sparql.patterns import Pattern, patterns, template
from kinlint.sparql.tokens import is_variable
from kinlint.sparql.variables import certain, variables, visible, words
from kinlint.terms import Term
from kinlint.vocabulary import INTERMEDIATE

_LENIENT = frozenset({"IF", "COALESCE", "BOUND", "EXISTS", "||", "&&"})
"""Forms that have a value although a part of them has none."""


def is_reading(query: Construct) -> bool:
    """Tell whether *query* makes a record of the intermediate vocabulary."""
    return any(word.startswith(f"<{INTERMEDIATE}") for word in query.template.tokens)


def unfolded(query: Construct, reading: Construct) -> Construct | None:
    """Return what *query* makes of the records that *reading* makes; None if of none.

    *query* matches one record, `?record a ir:Kind ; ir:property ?value`, of which OPTIONAL may
    hold further properties, and works out the rest by BIND and FILTER. Raises `RuleInvalid` for
    any other form, and for a record that has several values for one property.
    """
    return _Unfolding(reading).unfold(query)


@dataclass
class _Unfolding:
    """The unfolding of a shared query by one reading."""

    reading: Construct
    """The query that reads what the shared one makes."""
    values: dict[str, str] = field(default_factory=dict)
    """The terms in place of the variables of the shared query."""

    def unfold(self, query: Construct) -> Construct | None:
        record, values = _record(self.reading)
        kept: list[Element] = []
        lacking: list[str] = []
        for each in query.group.elements:
            if isinstance(each, Triples):
                for pattern in patterns(each.tokens, count()):
                    if not self._matches(pattern, record, values):
                        return None
                    lacking.append(pattern.object)
            elif isinstance(each, Clause):
                self._add_optional(each, record, values)
            else:
                kept.append(each)
        self._rename(query)
        tests = dict.fromkeys(self.values[name] for name in lacking if name in self.values)
        asked = [name for name in tests if is_variable(name)]
        read = _with_certain(self.reading.group, asked)
        bound = [_bound(name) for name in asked if name not in certain(read)]
        made = [self._with_values(each) for each in kept]
        group = Group((*read.elements, *bound, *made))
        return Construct(Triples(self._words(query.template.tokens)), group, ())

    def _matches(self, pattern: Pattern, record: str, values: Mapping[Term, Sequence[str]]) -> bool:
        """Tell whether the record has what *pattern* asks for; its variable then has that value."""
        (predicate,) = pattern.path
        known = values.get(predicate, ())
        self._set(pattern.subject, record)
        if not is_variable(pattern.object):
            return pattern.object in known
        if len(known) > 1:
            raise RuleInvalid(f"a record has several values for {predicate}")
        if known:
            self._set(pattern.object, known[0])
        return bool(known)

    def _set(self, name: str, value: str) -> None:
        if self.values.setdefault(name, value) != value:
            raise RuleInvalid(f"{name} stands for {self.values[name]} and for {value}")

    def _add_optional(
        self, clause: Clause, record: str, values: Mapping[Term, Sequence[str]]
    ) -> None:
        """Take the properties that the record has; what has all of them unbound matches nothing."""
        if clause.head[0].upper() != "OPTIONAL":
            raise RuleInvalid(f"a shared query has {clause.head[0]}")
        for each in clause.group.elements:
            if not isinstance(each, Triples):
                raise RuleInvalid("a shared query has more than triples in OPTIONAL")
            for pattern in patterns(each.tokens, count()):
                self._matches(pattern, record, values)

    def _rename(self, query: Construct) -> None:
        """Rename the other variables of *query* where the reading has variables of these names."""
        taken = variables(self.reading.group)
        free = variables(query.group) | set(filter(is_variable, query.template.tokens))
        for name in sorted(free - self.values.keys()):
            fresh = name
            while fresh in taken:
                fresh += "_"
            self.values[name] = fresh

    def _with_values(self, part: Element) -> Element:
        match part:
            case Filter(expression):
                return Filter(self._expression(expression))
            case Bind(expression, variable):
                return Bind(self._expression(expression), self.values[variable])
            case _:
                raise RuleInvalid(f"a shared query has {type(part).__name__.lower()}")

    def _expression(self, expression: Expression) -> Expression:
        if any(isinstance(each, Group) for each in expression):
            raise RuleInvalid("a shared query has EXISTS")
        found = list(self._words(tuple(words(expression))))
        for at, word in enumerate(found):
            if word.upper() == "BOUND" and not is_variable(found[at + 2]):
                found[at : at + 4] = ["true"]
        return tuple(found)

    def _words(self, tokens: Sequence[str]) -> tuple[str, ...]:
        return tuple(self.values.get(each, each) for each in tokens)


def _record(reading: Construct) -> tuple[str, Mapping[Term, Sequence[str]]]:
    """Return the subject of the template of *reading*, and its values by property."""
    triples = template(reading.template.tokens)
    if len({s for s, _, _ in triples}) != 1:
        raise RuleInvalid("a reading makes one record for each of its solutions")
    unbound = {o for _, _, o in triples if is_variable(o)} - visible(reading.group)
    if unbound:
        raise RuleInvalid(f"a reading binds no {', '.join(sorted(unbound))}")
    values: dict[Term, list[str]] = {}
    for _, predicate, value in triples:
        values.setdefault(predicate, []).append(value)
    return triples[0][0], values


def _with_certain(group: Group, asked: Iterable[str]) -> Group:
    """Return *group* for solutions that bind all variables *asked*, with fewer OPTIONAL in it.

    Where only an OPTIONAL binds what is asked, a solution without its group is none: the left join
    is a join then, which stores answer faster.
    """
    needed = set(asked)
    for each in reversed(group.elements):
        if isinstance(each, Bind) and each.variable in needed:
            needed |= _strict(each.expression)
    found: list[Element] = []
    for each in group.elements:
        others = Group(tuple(other for other in group.elements if other is not each))
        match each:
            case Clause((("OPTIONAL" | "optional"), *_), inner) if needed & certain(
                inner
            ) - visible(others):
                found += inner.elements
            case _:
                found.append(each)
    return Group(tuple(map(_ended, found)))


def _ended(part: Element) -> Element:
    """Return *part* so that triple patterns may follow it."""
    if isinstance(part, Triples) and part.tokens[-1] != ".":
        return Triples((*part.tokens, "."))
    return part


def _strict(expression: Expression) -> set[str]:
    """Return variables without which *expression* has no value; perhaps not all of them."""
    parts = words(expression)
    if parts[0].upper() == "IF":
        depths = accumulate((each == "(") - (each == ")") for each in parts)
        ends = (at for at, depth in enumerate(depths) if depth == 1 and parts[at] == ",")
        parts = parts[2 : next(ends)]
    parts = list(takewhile(lambda each: each.upper() != "IN", parts))
    lenient = _LENIENT.intersection(each.upper() for each in parts)
    return set() if lenient else set(filter(is_variable, parts))


def _bound(name: str) -> Filter:
    return Filter(("(", "BOUND", "(", name, ")", ")"))
