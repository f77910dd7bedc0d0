"""Each OPTIONAL of a lifting query is about something that every solution before it has.

Where it only shares variables that may be unbound, an element without them is joined to those of
all other elements, in all files: wrong values, and time quadratic in the files.
"""

from collections.abc import Iterator

import pytest

from kinlint.engine.lifting import LIFTED, queries
from kinlint.sparql.ast import Bind, Clause, Element, Group, Union, render
from kinlint.sparql.parser import parse
from kinlint.sparql.tokens import is_variable, tokens
from kinlint.sparql.variables import certain, visible, words


def bound(part: Element) -> frozenset[str]:
    """Variables that every solution of *part* binds; BIND is taken to succeed."""
    match part:
        case Bind(_, variable):
            return frozenset({variable})
        case Union(branches):
            return frozenset.intersection(
                *(frozenset().union(*map(bound, each.elements)) for each in branches)
            )
        case _:
            return certain(part)


def loose(group: Group, known: frozenset[str] = frozenset()) -> Iterator[str]:
    """Yield each OPTIONAL of *group* that shares variables, but none that is surely bound."""
    shared = known
    for each in group.elements:
        inner: list[Group] = []
        if isinstance(each, Clause) and each.head[0].upper() == "OPTIONAL":
            mine = visible(each.group)
            if not mine & known and mine & shared:
                yield render(each)
            inner = [each.group]
        elif isinstance(each, Union):
            inner = list(each.branches)
        for one in inner:
            yield from loose(one, known)
        if not isinstance(each, Bind) or {*filter(is_variable, words(each.expression))} <= known:
            known |= bound(each)
        elif any(word.upper() == "COALESCE" for word in words(each.expression)):
            known |= {each.variable}
        shared |= visible(each)


@pytest.mark.parametrize("form", [each.name for each in LIFTED])
def test_optional_parts_are_about_what_is_there(form: str) -> None:
    found = {each.name: [*loose(each.where)] for each in queries(form)}

    assert not {name: parts for name, parts in found.items() if parts}


def test_one_that_is_not_is_found() -> None:
    """The second OPTIONAL is about any ?b where the first has none."""
    text = "SELECT ?a WHERE { ?a <p:p> ?x . OPTIONAL { ?a <p:q> ?b } OPTIONAL { ?b <p:r> ?c } }"

    assert [*loose(parse(tokens(text, {})).group)] == ["OPTIONAL { ?b <p:r> ?c }"]
