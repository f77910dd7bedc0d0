"""The queries that differ from one in a single place: a part that they lack, or a path's steps."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import count

from kinlint.sparql.ast import (
    Bind,
    Clause,
    Element,
    Expression,
    Filter,
    Group,
    Select,
    Triples,
    Union,
    render,
)
from kinlint.sparql.patterns import Pattern, patterns
from kinlint.terms import RDF
from kinlint.vocabulary import SRC

ONE_FILE = ((f"<{SRC}document>",), (f"<{SRC}describedIn>",))
"""Tell files apart, which no example can show: an example is one file."""


OTHER_STEPS = {"*": ("?", "+"), "+": ("",)}
"""Modifiers of a path that allow fewer numbers of steps: one at most, or one at least."""
REST = f"<{RDF}rest>"
"""A step to the rest of a list: which places of a list its examples show says nothing of a rule."""


def mutants(query: Select) -> Iterator[tuple[str, Select]]:
    """Yield *query* with one change, for each that there is, with the text that is not there.

    A triple pattern or filter is left out; the parts of a sequence path are patterns of their own.
    A path that repeats, by `*` or `+`, takes no second step, or one by `*` not none.
    """
    yield from ((gone, Select(new, query.group, query.tail)) for gone, new in _inside(query.head))
    yield from ((gone, Select(query.head, new, query.tail)) for gone, new in _groups(query.group))
    yield from ((gone, Select(query.head, query.group, new)) for gone, new in _inside(query.tail))


def _groups(group: Group) -> Iterator[tuple[str, Group]]:
    for at, element in enumerate(group.elements):
        for gone, left in (*_deleted(element), *_changed(element)):
            yield gone, Group((*group.elements[:at], *left, *group.elements[at + 1 :]))


def _deleted(element: Element) -> Iterator[tuple[str, tuple[Element, ...]]]:
    if isinstance(element, Filter):
        yield render(element), ()
    if isinstance(element, Triples):
        found = patterns(element.tokens, count(9000))
        for at, pattern in enumerate(found):
            left = " . ".join(each.text for each in (*found[:at], *found[at + 1 :]))
            if pattern.path not in ONE_FILE:
                yield pattern.text, (Triples((left,)),) if left else ()
            for changed in _other_steps(pattern):
                left = " . ".join(each.text for each in (*found[:at], changed, *found[at + 1 :]))
                yield f"{pattern.text} and not {changed.text}", (Triples((left,)),)


def _other_steps(pattern: Pattern) -> Iterator[Pattern]:
    """Yield *pattern* with another number of steps for each part of its path that repeats."""
    subject, path, value = pattern
    for at, word in enumerate(path):
        for other in OTHER_STEPS.get(word, ()) if path[at - 1] != REST else ():
            steps = (*path[:at], other, *path[at + 1 :])
            yield Pattern(subject, tuple(filter(None, steps)), value)


def _changed(element: Element) -> Iterator[tuple[str, tuple[Element, ...]]]:
    match element:
        case Filter(expression):
            yield from ((gone, (Filter(new),)) for gone, new in _inside(expression))
        case Bind(expression, variable):
            yield from ((gone, (Bind(new, variable),)) for gone, new in _inside(expression))
        case Union(branches):
            for at, branch in enumerate(branches):
                for gone, new in _groups(branch):
                    yield gone, (Union((*branches[:at], new, *branches[at + 1 :])),)
        case Clause(head, group):
            yield from ((gone, (Clause(head, new),)) for gone, new in _groups(group))
        case Select():
            yield from ((gone, (new,)) for gone, new in mutants(element))


def _inside(expression: Expression) -> Iterator[tuple[str, Expression]]:
    for at, each in enumerate(expression):
        if isinstance(each, Group):
            for gone, new in _groups(each):
                yield gone, (*expression[:at], new, *expression[at + 1 :])
