"""Lift XML formats to composable models, by the CONSTRUCT queries of `shapes/lifting`."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache, lru_cache
from pathlib import Path

import pyoxigraph as ox

from kinlint import resources
from kinlint.contexts.prefixes import customary
from kinlint.engine.store import ASSERTED_GRAPH, Store
from kinlint.engine.template import Made, made_by, needed, trimmed
from kinlint.engine.unfolding import is_reading, unfolded
from kinlint.errors import RuleInvalid
from kinlint.file_format import Format
from kinlint.formats.records import ELEMENTS, LIFTED
from kinlint.sparql.ast import Construct, Group, render
from kinlint.sparql.parser import parse_construct
from kinlint.sparql.scope import words
from kinlint.sparql.tokens import NotSparql
from kinlint.terms import RDF_TYPE, Term, iri, iri_value
from kinlint.vocabulary import (
    ATTRIBUTE,
    EXTENSION,
    INTERMEDIATE,
    KIN,
    LIFTED_GRAPH,
    METAMODELS,
    QUANTITY_KIND,
    QUDT,
    SRC,
    UNIT,
)

_IRI = re.compile(r"<[^<>]+>")
_REL = f"{METAMODELS}geometry/spatial-relations#"
_GEOM = f"{METAMODELS}geometry/structural-entities#"
_COORD = f"{METAMODELS}geometry/coordinates#"
EVERYWHERE = frozenset(
    {
        RDF_TYPE,
        *map(iri, (f"{SRC}from", f"{QUDT}unit", f"{QUDT}hasQuantityKind")),
        *map(iri, (f"{_REL}of", f"{_REL}with-respect-to", f"{_COORD}as-seen-by")),
        *map(iri, (f"{_GEOM}simplices", f"{KIN}of-joint")),
    }
)
"""Properties that nodes of many classes have, so that asking for them asks for no query."""
READ = (*ELEMENTS, ATTRIBUTE, EXTENSION, SRC)
"""The namespaces that queries match; a name of another one below the template is chosen for it."""

FOUNDATION = frozenset({"bodies", "joints"})
"""Queries that make what everything else is about."""


@dataclass(frozen=True, slots=True, eq=False)
class Lifting:
    """One query."""

    format: str
    """The format that it reads."""
    name: str
    """The name of its file, or of a reading and the shared query that is unfolded by it."""
    made: tuple[Made, ...]
    """The triples of its template."""
    makes: frozenset[Term]
    """The properties and classes that it states, but for those that nodes of many kinds have."""
    where: Group
    """What it matches."""

    def serves(self, wanted: Collection[Term]) -> bool:
        """Whether it makes something of what is *wanted*."""
        return self.name in FOUNDATION or not self.makes.isdisjoint(wanted)

    def update(self, wanted: Collection[Term] | None = None) -> str:
        """Return what stores all that it makes, or what of it `part` returns for *wanted*."""
        return _update(self, None if wanted is None else frozenset(wanted))

    def part(self, wanted: Collection[Term] | None) -> tuple[Sequence[Made], Group]:
        """Return the triples that have a property or class of the *wanted*, and their WHERE."""
        if wanted is None:
            return self.made, self.where
        made = needed(self.made, wanted)
        return made, trimmed(self.where, _variables(made))


def _variables(made: Iterable[Made]) -> set[str]:
    return set[str]().union(*(each.variables for each in made))


SHARED = "shared"
"""The directory of the queries that make the composable model of what readings make."""


@lru_cache(maxsize=512)
def _update(lifting: Lifting, wanted: frozenset[Term] | None) -> str:
    made, where = lifting.part(wanted)
    template = " ".join(f"{s} {p} {o} ." for s, p, o in made)
    return (
        f"INSERT {{ GRAPH {LIFTED_GRAPH} {{ {template} }} }} "
        f"USING {ASSERTED_GRAPH} WHERE {render(where)}"
    )


@lru_cache(maxsize=len(LIFTED))
def queries(form: str) -> tuple[Lifting, ...]:
    """Return the lifting queries of the format *form*, by name.

    In place of a reading come the shared queries that make something of its records.
    """
    return tuple(each for file in _files(form) for each in _queries(form, file))


def _queries(form: str, file: Path) -> Iterator[Lifting]:
    query = _parsed(file)
    if not is_reading(query):
        yield _lifting(form, file.stem, query)
        return
    for shared in _files(SHARED):
        if (made := unfolded(_parsed(shared), query)) is not None:
            each = _lifting(form, f"{file.stem}/{shared.stem}", made)
            yield replace(each, where=trimmed(each.where, _variables(each.made)))


def _files(directory: str) -> list[Path]:
    return sorted(resources.data("shapes").glob(f"lifting/{directory}/*.rq"))


@cache
def _parsed(file: Path) -> Construct:
    prefixes = {**customary(), "ir": INTERMEDIATE}
    try:
        return parse_construct(file.read_text(encoding="utf-8"), prefixes)
    except NotSparql as error:
        raise RuleInvalid(f"{file}: {error}") from error


def _lifting(form: str, name: str, query: Construct) -> Lifting:
    made = made_by(query.template)
    stated = {term for each in made for term in (each.predicate, each.term) if term}
    chosen = {
        each
        for each in words(query.group)
        if _IRI.fullmatch(each) and not each[1:].startswith(READ)
    }
    named = {each for each in stated | chosen if not each[1:].startswith((UNIT, QUANTITY_KIND))}
    return Lifting(form, name, made, frozenset(named - EVERYWHERE), query.group)


def lifts(formats: Iterable[Format]) -> frozenset[Term]:
    """Return all properties and classes that lifting files of *formats* may make."""
    return EVERYWHERE.union(*(each.makes for each in asked(formats)))


def lift(
    store: Store,
    wanted: Collection[Term] | None = None,
    kept: Collection[Term] | None = None,
) -> None:
    """Add what the documents of *store* mean to its graph of lifted statements.

    With *wanted*, only by those queries that make one of these terms; of what they make, with
    *kept*, only what has one of these properties, or is of one of these classes, with what it was
    lifted from. Raises `RuleInvalid` for a query that is no SPARQL.
    """
    store.oxigraph.clear_graph(ox.NamedNode(iri_value(LIFTED_GRAPH)))
    for each in asked({document.format for document in store.documents.values()}, wanted):
        try:
            store.oxigraph.update(each.update(kept))
        except SyntaxError as error:
            raise RuleInvalid(f"shapes/lifting/{each.format}/{each.name}.rq: {error}") from error


def asked(formats: Iterable[Format], wanted: Collection[Term] | None = None) -> Iterator[Lifting]:
    """Yield the queries for *formats* that make something *wanted*; all if nothing says what is."""
    present = {each.lifted_as for each in formats}
    for form in LIFTED:
        if form.name in present:
            yield from (
                each for each in queries(form.name) if wanted is None or each.serves(wanted)
            )
