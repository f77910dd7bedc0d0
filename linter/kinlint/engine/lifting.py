"""Lift XML formats to composable models, by the CONSTRUCT queries of `shapes/lifting`."""

from __future__ import annotations

import json
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import cached_property, lru_cache
from typing import Any

import pyoxigraph as ox

from kinlint.document import Document
from kinlint.engine.compiled_lifting import RECALLED
from kinlint.engine.construct_template import Made, needed, trimmed, variables_of
from kinlint.engine.required_terms import ANY_CLASS
from kinlint.engine.store import ASSERTED_GRAPH, Store
from kinlint.errors import RuleInvalid
from kinlint.file_format import Format
from kinlint.formats.records import LIFTED
from kinlint.light_dataclasses import dataclass
from kinlint.phases import part
from kinlint.sparql.ast import Group, render
from kinlint.sparql.ast_json import from_json
from kinlint.terms import RDF_TYPE, Term, iri, iri_value
from kinlint.vocabulary import KIN, LIFTED_GRAPH, METAMODELS, QUDT, SRC

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

FOUNDATION = frozenset({"bodies", "joints"})
"""Shared queries that make what everything else is about."""


@dataclass(frozen=True, eq=False)
class Lifting:
    """A lifting query, its WHERE ready when it is first looked at."""

    format: str
    """The format that it reads."""
    name: str
    """The name of its file, or of a reading and the shared query that is unfolded by it."""
    made: tuple[Made, ...]
    """The triples of its template."""
    makes: frozenset[Term]
    """The properties and classes that it states, but for those that nodes of many kinds have."""
    stored: Any
    """Its WHERE as JSON."""

    @classmethod
    def from_json(
        cls, form: str, name: str, made: Iterable[Any], makes: Iterable[Term], stored: Any
    ) -> Lifting:
        """Return the query for *form* that `compile_queries` has compiled to the other values."""
        template = tuple(Made(*each) for each in made)
        return cls(form, name, template, frozenset(makes) - EVERYWHERE, stored)

    @cached_property
    def where(self) -> Group:
        """The group that it matches."""
        group: Group = from_json(self.stored)
        return group

    def serves(self, wanted: Collection[Term]) -> bool:
        """Tell whether the query makes anything that is *wanted*."""
        shared = self.name.rpartition("/")[2]
        return shared in FOUNDATION or not self.makes.isdisjoint(wanted)

    def update(
        self, wanted: Collection[Term] | None = None, foreign: frozenset[Term] = frozenset()
    ) -> str:
        """Return what stores all that it makes, or what of it `part` returns for *wanted*.

        Nothing is made of *foreign* documents.
        """
        return _update(
            self, None if wanted is None else self._decisive.intersection(wanted), foreign
        )

    @cached_property
    def _decisive(self) -> frozenset[Term]:
        """The terms that decide, by being wanted or not, which triples of the template are made."""
        return frozenset({ANY_CLASS, *(each.term for each in self.made if each.term is not None)})

    def part(self, wanted: Collection[Term] | None) -> tuple[Sequence[Made], Group]:
        """Return the triples that have a property or class of the *wanted*, and their WHERE."""
        if wanted is None:
            return self.made, self.where
        made = needed(self.made, wanted)
        return made, self.where_for(frozenset(variables_of(made)))

    def where_for(self, used: frozenset[str]) -> Group:
        """Return the group that it matches, less what serves other variables than those *used*."""
        return _trimmed(self, used)


@lru_cache(maxsize=1024)
def _trimmed(lifting: Lifting, used: frozenset[str]) -> Group:
    return trimmed(lifting.where, used)


@lru_cache(maxsize=512)
def _update(lifting: Lifting, wanted: frozenset[Term] | None, foreign: frozenset[Term]) -> str:
    made, where = lifting.part(wanted)
    template = " ".join(f"{s} {p} {o} ." for s, p, o in made)
    matched = render(where)
    if foreign and made:
        home = f'COALESCE(STRBEFORE(STR({made[0].subject}), "#"), "")'
        others = ", ".join(f'"{iri_value(each)}"' for each in sorted(foreign))
        matched = f"{{ {matched} FILTER ({home} NOT IN ({others})) }}"
    return (
        f"INSERT {{ GRAPH {LIFTED_GRAPH} {{ {template} }} }} USING {ASSERTED_GRAPH} WHERE {matched}"
    )


@lru_cache(maxsize=len(LIFTED))
def queries(form: str) -> tuple[Lifting, ...]:
    """Return the lifting queries of the format *form*, by name, unfolded."""
    stored = json.loads(RECALLED[form]) if form in RECALLED else _compile(form)
    return tuple(Lifting.from_json(form, *each) for each in stored)


def _compile(form: str) -> Any:
    from kinlint.engine.lifting_compiler import compile_queries  # noqa: PLC0415

    return compile_queries(form)


def compiled_queries() -> dict[str, str]:
    """Return the queries of each format as JSON, for `RECALLED` of another process."""
    return {each.name: json.dumps(_compile(each.name), separators=(",", ":")) for each in LIFTED}


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
    homes = {graph: document.format for graph, document in store.documents.items()}
    lifted = {each.name for each in LIFTED}.intersection(each.lifted_as for each in homes.values())
    foreign = {
        form: frozenset(g for g, other in homes.items() if other.lifted_as in lifted - {form})
        for form in lifted
    }
    for each in asked(homes.values(), wanted):
        try:
            with part("lifting queries", f"{each.format}/{each.name}.rq"):
                store.oxigraph.update(each.update(kept, foreign[each.format]))
        except SyntaxError as error:
            raise RuleInvalid(f"shapes/lifting/{each.format}/{each.name}.rq: {error}") from error


def is_lifted_as(node: Term, form: str, documents: Mapping[Term, Document]) -> bool:
    """Tell whether queries for the format *form* are for *node*, an element or what is made of it.

    They are where none of *documents*, by their graphs, says otherwise.
    """
    home = documents.get(f"{node.partition('#')[0]}>")
    return home is None or home.format.lifted_as == form


def makes(
    formats: Iterable[Format],
    wanted: Collection[Term] | None = None,
    kept: Collection[Term] | None = None,
) -> frozenset[Term]:
    """Return the properties and classes that `lift` states; `rdf:type` if it may be any class."""
    parts = (needed(each.made, kept) if kept else each.made for each in asked(formats, wanted))
    return frozenset(each.term or each.predicate for part in parts for each in part)


def asked(formats: Iterable[Format], wanted: Collection[Term] | None = None) -> Iterator[Lifting]:
    """Yield the queries for *formats* that make something *wanted*; all if that is None."""
    present = {each.lifted_as for each in formats}
    for form in LIFTED:
        if form.name in present:
            yield from (
                each for each in queries(form.name) if wanted is None or each.serves(wanted)
            )
