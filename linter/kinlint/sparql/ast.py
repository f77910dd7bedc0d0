"""The abstract syntax tree of SPARQL: groups, patterns, filters and sub-selects.

Only structure is read. Expressions stay tokens, with the groups of EXISTS among them, so what
is not rewritten is written back as it stood.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TypeAlias

from kinlint.light_dataclasses import dataclass


@dataclass(frozen=True)
class Group:
    """`{ … }` with elements joined in order."""

    elements: tuple[Element, ...]
    """The elements."""


@dataclass(frozen=True)
class Triples:
    """Triple patterns between dots, as tokens."""

    tokens: tuple[str, ...]
    """The tokens."""


@dataclass(frozen=True)
class Filter:
    """`FILTER` and its expression."""

    expression: Expression
    """The condition."""


@dataclass(frozen=True)
class Bind:
    """`BIND(expression AS variable)`."""

    expression: Expression
    """The value."""
    variable: str
    """The variable that is bound to it."""


@dataclass(frozen=True)
class Union:
    """A group, or several with UNION between them."""

    branches: tuple[Group, ...]
    """The groups."""


@dataclass(frozen=True)
class Clause:
    """A keyword with a group: OPTIONAL, MINUS, GRAPH, SERVICE, LATERAL."""

    head: tuple[str, ...]
    """The keyword, and the name for GRAPH and SERVICE."""
    group: Group
    """The group."""


@dataclass(frozen=True)
class Values:
    """A VALUES clause, as tokens."""

    tokens: tuple[str, ...]
    """The tokens."""


@dataclass(frozen=True)
class Select:
    """A query or sub-select."""

    head: Expression
    """The tokens from its verb up to WHERE."""
    group: Group
    """Its WHERE."""
    tail: Expression
    """Its modifiers."""


@dataclass(frozen=True)
class Construct:
    """`CONSTRUCT { template } WHERE { … }`; `tail` are its modifiers."""

    template: Triples
    """Triples to make of each solution."""
    group: Group
    """Its WHERE."""
    tail: Expression
    """Its modifiers."""


@dataclass(frozen=True)
class Update:
    """`DELETE { removed } INSERT { added } WHERE { … }`: SPARQL 1.1 Update, section 3.1.3."""

    removed: Triples
    """Template of the triples to delete."""
    added: Triples
    """Template of the triples to insert."""
    group: Group
    """Its WHERE."""


Expression: TypeAlias = tuple["str | Group", ...]
Element: TypeAlias = Triples | Filter | Bind | Union | Clause | Values | Select
Query: TypeAlias = Select | Construct | Update


def render(part: Group | Element | Expression | Query | str) -> str:
    """Return *part* as SPARQL."""
    match part:
        case str():
            text = part
        case tuple():
            text = "".join(_spaced(each) for each in part).rstrip()
        case Group(elements):
            text = "{ " + " ".join(render(each) for each in elements) + " }"
        case Triples(tokens) | Values(tokens):
            text = " ".join(tokens)
        case Filter(expression):
            text = f"FILTER {render(expression)}"
        case Bind(expression, variable):
            text = f"BIND( {render(expression)} AS {variable} )"
        case Union(branches):
            text = " UNION ".join(render(branch) for branch in branches)
        case Clause(head, group):
            text = f"{' '.join(head)} {render(group)}"
        case _:
            text = _query(part)
    return text


def _query(part: Query) -> str:
    match part:
        case Select(head, group, tail):
            text = f"{render(head)} WHERE {render(group)} {render(tail)}"
        case Construct(template, group, tail):
            text = f"CONSTRUCT {{ {render(template)} }} WHERE {render(group)} {render(tail)}"
        case Update(removed, added, group):
            changes = (("DELETE", removed), ("INSERT", added))
            verbs = [f"{verb} {{ {render(each)} }}" for verb, each in changes if each.tokens]
            text = f"{' '.join(verbs)} WHERE {render(group)}"
    return text.rstrip()


def _spaced(part: str | Group) -> str:
    """Return *part* with a space after it, but where Oxigraph takes none before a parenthesis."""
    text = render(part)
    return text if text.upper() in ("CONCAT", "COALESCE") else text + " "


def walk(part: Group | Element | Expression) -> Iterator[Group | Element]:
    """Yield *part* and every group and element in it, expressions included."""
    match part:
        case tuple():
            inner: tuple[Group | Element | Expression | str, ...] = part
        case Group(elements):
            inner = elements
            yield part
        case Filter(expression):
            inner = expression
            yield part
        case Bind(expression, _):
            inner = expression
            yield part
        case Union(branches):
            inner = branches
            yield part
        case Clause(_, group):
            inner = (group,)
            yield part
        case Select(head, group, tail):
            inner = (*head, group, *tail)
            yield part
        case _:
            inner = ()
            yield part
    for each in inner:
        if not isinstance(each, str):
            yield from walk(each)


def joined(group: Group) -> Iterator[Element]:
    """Yield the elements of *group* and of those whose solutions are joined to it."""
    for each in group.elements:
        yield each
        if isinstance(each, Union):
            for branch in each.branches:
                yield from joined(branch)
        elif isinstance(each, Clause) and each.head[0].upper() == "OPTIONAL":
            yield from joined(each.group)
