"""Makes composable models of XML formats, by the CONSTRUCT queries of `shapes/lifting`."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import pyoxigraph as ox

from kinlint import resources
from kinlint.document import LIFTED_AS
from kinlint.engine.store import ASSERTED_GRAPH, Store
from kinlint.engine.template import Made, needed, parsed, trimmed
from kinlint.errors import RuleInvalid
from kinlint.terms import RDF_TYPE, Term, iri, iri_value
from kinlint.vocabulary import (
    ATTRIBUTE,
    EXTENSION,
    KIN,
    LIFTED_GRAPH,
    METAMODELS,
    QUANTITY_KIND,
    QUDT,
    SDF,
    SRC,
    SRDF,
    UNIT,
    URDF,
)

_PREFIX = re.compile(r"(?im)^\s*PREFIX\s+([\w.-]*):\s*<([^<>\s]*)>")
_CONSTRUCT = re.compile(r"\bCONSTRUCT\s*\{")
_NAME = re.compile(r"(?<![\w?$:<\"])([A-Za-z][\w.-]*):([A-Za-z_][\w-]*)")
_VARIABLE = re.compile(r"\?\w+")
_COMMENT = re.compile(r"(?m)^\s*#.*\n?")

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
READ = (URDF, SDF, SRDF, ATTRIBUTE, EXTENSION, SRC)
"""The namespaces that queries match; a name of another one below the template is chosen for it."""


FOUNDATION = frozenset({"bodies", "joints"})
"""Queries that make what everything else is about."""


@dataclass(frozen=True, slots=True)
class Lifting:
    """One query: the `format` it reads, the triples and the terms it `makes`, and its text."""

    format: str
    name: str
    made: tuple[Made, ...]
    makes: frozenset[Term]
    prologue: str
    where: str

    def serves(self, wanted: Collection[Term]) -> bool:
        """Whether it makes something of what is *wanted*."""
        return self.name in FOUNDATION or not self.makes.isdisjoint(wanted)

    def update(self, wanted: Collection[Term] | None = None) -> str:
        """What stores all that it makes, or what of it has a property or class of the *wanted*."""
        made, where = self.part(wanted)
        template = _text(made)
        return (
            f"{self.prologue} INSERT {{ GRAPH {LIFTED_GRAPH} {{ {template} }} }} "
            f"USING {ASSERTED_GRAPH} {where}"
        )

    def part(self, wanted: Collection[Term] | None) -> tuple[Sequence[Made], str]:
        """What of its triples has a property or class of the *wanted*, and where from."""
        if wanted is None:
            return self.made, self.where
        made = needed(self.made, wanted)
        return made, trimmed(self.where, set(_VARIABLE.findall(_text(made))))

    @property
    def prefixes(self) -> dict[str, str]:
        """The namespaces of its prefixes."""
        return dict(_PREFIX.findall(self.prologue))


def _text(made: Iterable[Made]) -> str:
    return "".join([f"{s} {p} {o} .\n" for s, p, o, _ in made])


@lru_cache(maxsize=1)
def queries() -> tuple[Lifting, ...]:
    """All lifting queries, by format and name."""
    files = sorted(resources.data("shapes").glob("lifting/*/*.rq"))
    return tuple(map(_read, files))


def _read(file: Path) -> Lifting:
    text = _COMMENT.sub("", file.read_text(encoding="utf-8"))
    found = _CONSTRUCT.search(text)
    close = text.find("}", found.end()) if found else -1
    if found is None or close < 0:
        raise RuleInvalid(f"{file}: not a CONSTRUCT query")
    template = text[found.end() : close]
    prefixes = dict(_PREFIX.findall(text))
    made = tuple(parsed(template, prefixes))
    domain = {p for p, namespace in prefixes.items() if not namespace.startswith(READ)}
    chosen = [each for each in _NAME.findall(text[close:]) if each[0] in domain]
    names = (each for each in (*_NAME.findall(template), *chosen) if each[0] in prefixes)
    terms = (prefixes[prefix] + local for prefix, local in names)
    named = {iri(term) for term in terms if not term.startswith((UNIT, QUANTITY_KIND))}
    return Lifting(
        format=file.parent.name,
        name=file.stem,
        made=made,
        makes=frozenset(named - EVERYWHERE),
        prologue=text[: found.start()],
        where=text[close + 1 :],
    )


@lru_cache(maxsize=1)
def lifts() -> frozenset[Term]:
    """All properties and classes that lifting may make."""
    return EVERYWHERE.union(*(each.makes for each in queries()))


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


def asked(formats: Iterable[str], wanted: Collection[Term] | None = None) -> Iterator[Lifting]:
    """The queries for *formats* that make something *wanted*; all if nothing says what is."""
    present = {LIFTED_AS.get(each, each) for each in formats}
    if present & FORMATS:
        for each in queries():
            if each.format in present and (wanted is None or each.serves(wanted)):
                yield each


FORMATS = frozenset({"urdf", "sdf", "srdf"})
"""The formats that are lifted."""
