"""The queries that differ from one in a single triple pattern or filter that they lack."""

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
    walk,
)
from kinlint.sparql.patterns import patterns
from kinlint.vocabulary import SRC

ONE_FILE = ((f"<{SRC}document>",), (f"<{SRC}describedIn>",))
"""Tell files apart, which no example can show: an example is one file."""


def repeats(query: Select) -> bool:
    """Return whether *query* follows a path any number of times, by `*` or `+`.

    An example would have to tell each number of steps from the others.
    """
    blocks = (part.tokens for part in walk(query) if isinstance(part, Triples))
    found = (pattern.path for block in blocks for pattern in patterns(block, count()))
    return any({"*", "+"}.intersection(path) for path in found)


def mutants(query: Select) -> Iterator[tuple[str, Select]]:
    """Yield *query* without one triple pattern or filter, for each in it, with the removed text.

    The steps of a path are patterns of their own.
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
