"""Tokens and variables of the parts of a query: named, possibly bound, certainly bound."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import count, pairwise
from typing import Any

from kinlint.light_dataclasses import replace
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
    Values,
    walk,
)
from kinlint.sparql.patterns import Pattern, patterns
from kinlint.sparql.tokens import is_variable


def words(part: Group | Element | Expression) -> list[str]:
    """Return every token of *part*, in the order of the text."""
    found: list[str] = []
    _collect(part, found)
    return found


def _collect(part: Group | Element | Expression | str, found: list[str]) -> None:
    match part:
        case str():
            if part:
                found.append(part)
        case Triples(tokens) | Values(tokens):
            found += filter(None, tokens)
        case _:
            for each in _inner(part):
                _collect(each, found)


def _inner(part: Any) -> Iterable[Group | Element | str]:
    """Return what *part*, no token and no block of tokens, consists of."""
    inner: Iterable[Group | Element | str] = part
    match part:
        case Group(parts) | Union(parts) | Filter(parts):
            inner = parts
        case Bind(expression, variable):
            inner = (*expression, variable)
        case Clause(head, group):
            inner = (*head, group)
        case Select(head, group, tail):
            inner = (*head, group, *tail)
    return inner


def iris(part: Group | Element | Expression) -> Iterator[str]:
    """Yield each IRI of *part*, as often as it stands there, datatypes and functions too.

    What a query projects, groups and sorts by is left out: it looks at nothing there.
    """
    for each in walk(part):
        match each:
            case Triples(found) | Values(found) | Filter(found) | Bind(found, _) | Clause(found, _):
                words = (word for word in found if isinstance(word, str) and len(word) > 1)
                yield from (word for word in words if word[0] == "<" and word[-1] == ">")
            case _:
                pass


def triple_patterns(part: Group | Element | Expression) -> list[Pattern]:
    """Return the triple patterns of *part*, wherever they stand."""
    names = count(5000)
    blocks = (each.tokens for each in walk(part) if isinstance(each, Triples))
    return [pattern for block in blocks for pattern in patterns(block, names)]


def variables(part: Group | Element | Expression) -> set[str]:
    """Return every variable that occurs in *part*."""
    return {word for word in words(part) if is_variable(word)}


def projection(select: Select) -> list[str]:
    """Return the variables that *select* projects, in order; those of `*` sorted."""
    head = [word for word in select.head[1:] if not isinstance(word, Group)]
    if "*" in head and "(" not in head:
        return sorted(visible(select.group))
    found: list[str] = []
    depth = 0
    for at, word in enumerate(head):
        depth += (word == "(") - (word == ")")
        if is_variable(word) and (depth == 0 or (depth == 1 and head[at - 1].upper() == "AS")):
            found.append(word)
    return found


def visible(part: Group | Element) -> set[str]:
    """Return the variables that may be bound where *part* ends: SPARQL 18.2.1."""
    match part:
        case Group(parts) | Union(parts):
            return {name for each in parts for name in visible(each)}
        case Triples() | Values():
            return variables(part)
        case Bind(_, variable):
            return {variable}
        case Clause(head, group) if head[0].upper() != "MINUS":
            return {word for word in head if is_variable(word)} | visible(group)
        case Select():
            return set(projection(part))
        case _:
            return set()


def assigned(part: Group | Element | Expression) -> set[str]:
    """Return the variables to which *part* gives values itself: by AS, or by VALUES."""
    found = words(part)
    names = {name for word, name in pairwise(found) if word.upper() == "AS"}
    for each in (part, *walk(part)):
        if isinstance(each, Bind):
            names.add(each.variable)
        elif isinstance(each, Values):
            head = each.tokens[: each.tokens.index("{")]
            names.update(word for word in head if is_variable(word))
    return names


def certain(part: Group | Element) -> frozenset[str]:
    """Return variables that every solution of *part* binds; perhaps not all of them."""
    match part:
        case Group(elements):
            return frozenset().union(*(certain(each) for each in elements))
        case Triples():
            return frozenset(variables(part))
        case Union(branches):
            return frozenset.intersection(*(certain(branch) for branch in branches))
        case Select(_, group, _):
            return frozenset(projection(part)) & certain(group)
        case _:
            return frozenset()


def with_names(select: Select, names: list[str]) -> Select:
    """Return *select* with `*` spelled out as *names*."""
    return replace(select, head=tuple(" ".join(names) if w == "*" else w for w in select.head))
