"""The triples of a CONSTRUCT template, and the part of a query that makes the needed ones."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterable
from typing import NamedTuple

from kinlint.document import FROM
from kinlint.engine.required_terms import ANY_CLASS
from kinlint.light_dataclasses import replace
from kinlint.sparql.ast import Bind, Clause, Element, Group, Triples, Union
from kinlint.sparql.patterns import template
from kinlint.sparql.tokens import is_variable
from kinlint.sparql.variables import variables, words
from kinlint.terms import RDF_TYPE, Term


class Made(NamedTuple):
    """A triple of a template; an object that is a list is one term, `( ?x ?y )`."""

    subject: str
    """Subject, as in the template."""
    predicate: str
    """Predicate, as in the template."""
    object: str
    """Object, as in the template."""

    @property
    def term(self) -> Term | None:
        """The property, or the class that the subject is said to be of; None for a variable."""
        named = self.object if self.predicate == RDF_TYPE else self.predicate
        return None if is_variable(named) else named

    @property
    def items(self) -> tuple[str, ...] | None:
        """The members of an object that is a list; None for one that is not."""
        return tuple(self.object[1:-1].split()) if self.object[0] == "(" else None

    @property
    def variables(self) -> set[str]:
        """The variables of the triple."""
        terms = (self.subject, self.predicate, *(self.items or (self.object,)))
        return set(filter(is_variable, terms))


def made_by(triples: Triples) -> tuple[Made, ...]:
    """Return the triples of a template."""
    return tuple(Made(*each) for each in template(triples.tokens, lists=True))


def variables_of(made: Iterable[Made]) -> set[str]:
    """Return the variables of all triples of *made*."""
    return set[str]().union(*(each.variables for each in made))


def needed(made: Collection[Made], wanted: Collection[Term]) -> list[Made]:
    """Return those of *made* that have a property or class of the *wanted*.

    With them come what explanations say of these nodes: one class, and what they are made of.
    """
    kept = {
        each
        for each in made
        if each.term is None
        or (each.term in wanted and each.term != FROM)
        or (each.predicate == RDF_TYPE and ANY_CLASS in wanted)
    }
    stated = {each.subject for each in kept}
    named = stated.union(*(each.variables for each in kept))
    kinds: dict[str, Made] = {}
    for each in made:
        if each.predicate == RDF_TYPE and each.term is not None and each.subject in stated:
            known = kinds.get(each.subject)
            if known is None or (known.term is not None and each.term < known.term):
                kinds[each.subject] = each
    kept.update(
        kinds.values(), (each for each in made if each.term == FROM and each.subject in named)
    )
    return [each for each in made if each in kept]


def trimmed(group: Group, used: Collection[str]) -> Group:
    """Return *group*, that of a query, without what binds only variables that nobody looks at.

    *used* are the variables that the template has. What is optional adds no solutions that
    differ in those, and neither does what is worked out.
    """
    sure = {
        name
        for each in group.elements
        if isinstance(each, Triples)
        for name in each.tokens
        if is_variable(name)
    }
    while True:
        named = Counter(filter(is_variable, words(group)))

        def idle(part: Element, named: Counter[str] = named) -> bool:
            if isinstance(part, Bind):
                free = {part.variable}
            elif isinstance(part, Clause) and part.head[0].upper() == "OPTIONAL":
                free = variables(part) - sure
            else:
                return False
            if not free.isdisjoint(used):
                return False
            own = Counter(filter(is_variable, words(part)))
            return all(named[name] == own[name] for name in free)

        smaller = _without(group, idle)
        if smaller == group:
            return group
        group = smaller


def _without(group: Group, idle: Callable[[Element], bool]) -> Group:
    """Return *group* without the elements that are *idle*, those of groups within included."""
    left: list[Element] = []
    for each in group.elements:
        if idle(each):
            continue
        if isinstance(each, Union):
            left.append(Union(tuple(_without(branch, idle) for branch in each.branches)))
        elif isinstance(each, Clause):
            left.append(replace(each, group=_without(each.group, idle)))
        else:
            left.append(each)
    return Group(tuple(left))
