"""Provenance of lifted values: the attribute or text of the element where they are written.

Nothing is kept while lifting. A query whose values somebody asks for is asked once more for what
its derivations read (`kinlint.engine.derivation`), and answers for all that it made.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator, Mapping, Sequence
from fnmatch import fnmatchcase
from functools import cache, cached_property
from itertools import islice
from typing import NamedTuple, TypeAlias

import pyoxigraph as ox

from kinlint import resources
from kinlint.addresses import document_of
from kinlint.document import Document
from kinlint.engine.derivation import (
    Choice,
    Combination,
    Derivation,
    Derivations,
    First,
    Negation,
    Read,
    Stated,
    derivations,
)
from kinlint.engine.lifting import asked, is_lifted_as
from kinlint.engine.literal_spelling import normal
from kinlint.engine.store import ASSERTED_GRAPH, Store, token
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import RDF, Term, Triple, iri, iri_value, is_blank, is_iri, is_literal
from kinlint.vocabulary import ATTRIBUTE, INHERITED, KINLINT, SRC

FIRST, REST = iri(f"{RDF}first"), iri(f"{RDF}rest")
TEXT = f"{SRC}text"
COMPONENT = re.compile(r"-[1-9][0-9]*$")
"""End of the property of one of several numbers of an attribute."""
WORKED_OUT = "lifting/worked-out.tsv"
"""The table, below shapes/, of what readers work out, and from what."""

Row: TypeAlias = Mapping[str, Term]
"""A solution: terms by variables, these with `?`."""


class Written(NamedTuple):
    """A triple of a document, spelled as there."""

    document: Document
    """Document that contains the triple."""
    triple: Triple
    """Triple, its numbers spelled as there."""


@dataclass(frozen=True, slots=True)
class Trace:
    """The origin of a lifted value."""

    written: tuple[Written, ...] = ()
    """The triples of documents that the value follows from; none for a default."""
    sign: int = 0
    """1 if the value is the one that is written, -1 if its negative, 0 if neither."""


NOWHERE = Trace()


@dataclass
class Provenance:
    """The origins of what was lifted in a store, as it is when they are first asked for."""

    store: Store
    """The store."""
    _solutions: dict[str, Mapping[tuple[str, Term], Sequence[Row]]] = field(default_factory=dict)

    def trace(self, triple: Triple) -> Trace:
        """Return what *triple* was made of, or the items of a list that is its object.

        Nothing for what was not lifted.
        """
        subject, predicate, value = triple[0], triple[1], normal(triple[2])
        if is_blank(subject):
            found = [
                self._member(owner, each, number)
                for owner, each, number in self._holders(subject, predicate)
            ]
        else:
            found = [
                self._evaluated(member, row)
                for stated, derived in self.derivations(predicate)
                for row in self._rows(derived, stated.made.subject, subject)
                for member in _members(stated, value, row)
            ]
        return _merged([each for each in found if each.written])

    def property(self, subject: Term, predicate: Term) -> Trace:
        """Return what all values of *predicate* that *subject* has were made of."""
        values = self.store.values(subject, predicate)
        return _merged([self.trace((subject, predicate, each)) for each in values])

    def read_from(self, element: Term, property_: Term) -> tuple[str, str]:
        """Return the path from *element* and the attribute that *property_* is first read from.

        No attribute is the text of the element.
        """
        if sources := self._sources(element, property_):
            return sources[0]
        if property_.startswith(f"<{TEXT}"):
            return "", ""
        return "", COMPONENT.sub("", property_[:-1].rpartition("#")[2])

    def derivations(self, predicate: Term) -> Sequence[tuple[Stated, Derivations]]:
        """Return what makes values of *predicate*, each with the derivations of its query."""
        return self._by_predicate.get(predicate, ())

    def all_read(self) -> Iterator[tuple[Term, Term]]:
        """Yield the elements and properties of all that lifted values were made of."""
        found = (each for stated in self._by_predicate.values() for each in stated)
        for stated, derived in found:
            for (name, _), rows in self._answers(derived).items():
                if name == stated.made.subject:
                    traces = [self._evaluated(each, row) for row in rows for each in stated.members]
                    yield from ((s, p) for each in traces for _, (s, p, _) in each.written)

    @cached_property
    def _by_predicate(self) -> Mapping[Term, Sequence[tuple[Stated, Derivations]]]:
        found: dict[Term, list[tuple[Stated, Derivations]]] = {}
        formats = {document.format for document in self.store.documents.values()}
        for query in asked(formats):
            derived = derivations(query)
            for each in derived.stated:
                found.setdefault(each.made.predicate, []).append((each, derived))
        return found

    def _rows(self, derived: Derivations, variable: str, subject: Term) -> Sequence[Row]:
        """Return the solutions in which *variable* is *subject*."""
        return self._answers(derived).get((variable, subject), ())

    def _answers(self, derived: Derivations) -> Mapping[tuple[str, Term], Sequence[Row]]:
        """Return the solutions of a query, by the subjects of what is made of them."""
        if derived.select not in self._solutions:
            graph = ox.NamedNode(iri_value(ASSERTED_GRAPH))
            solutions = self.store.oxigraph.query(derived.select, default_graph=graph)
            assert isinstance(solutions, ox.QuerySolutions)
            names = [str(variable) for variable in solutions.variables]
            subjects = sorted({each.made.subject for each in derived.stated})
            form, documents = derived.lifting.format, self.store.documents
            found: dict[tuple[str, Term], list[Row]] = {}
            for solution in solutions:
                terms = zip(names, solution, strict=True)
                row = {name: token(term) for name, term in terms if term is not None}
                for name in subjects:
                    if name in row and is_lifted_as(row[name], form, documents):
                        found.setdefault((name, row[name]), []).append(row)
            self._solutions[derived.select] = found
        return self._solutions[derived.select]

    def _evaluated(self, derivation: Derivation, row: Row) -> Trace:
        """Return what the value comes from that *derivation* gives in the solution *row*."""
        match derivation:
            case Read():
                return self._read(derivation, row)
            case First(parts):
                part = next((part for probe, part in parts if not probe or probe in row), None)
                return self._evaluated(part, row) if part is not None else NOWHERE
            case Choice(test, then, otherwise):
                if test not in row:
                    return NOWHERE
                chosen = then if row[test].startswith('"true"') else otherwise
                return self._evaluated(chosen, row)
            case Negation(part):
                found = self._evaluated(part, row)
                return Trace(found.written, -found.sign)
            case Combination(parts, alike):
                found = _merged([self._evaluated(each, row) for each in parts])
                return found if alike else Trace(found.written)

    def _read(self, read: Read, row: Row) -> Trace:
        element, value = row.get(read.element), row.get(read.value)
        if element is None or value is None:
            return NOWHERE
        return _merged([self._said((element, each, value)) for each in read.properties])

    def _said(self, triple: Triple) -> Trace:
        """Return the origin of a *triple* that a query read."""
        element, property_, value = triple
        if sources := self._sources(element, property_):
            found = (each for path, name in sources for each in self._below(element, path, name))
            return _merged([Trace(tuple(found))])
        if not is_literal(value):
            return NOWHERE
        written = tuple(Written(*each) for each in self.store.written(*triple))
        return Trace(written, 1) if written else self.trace(triple)

    def _sources(self, element: Term, property_: Term) -> Sequence[tuple[str, str]]:
        """Return the elements and attributes that a reader works out *property_* from."""
        document = self.store.documents.get(document_of(element))
        if document is None or not property_.startswith(f"<{SRC}"):
            return ()
        form, name = document.format.lifted_as, property_[len(SRC) + 1 : -1]
        return [
            (path, attribute)
            for known, pattern, path, attribute in _worked_out()
            if known == form and fnmatchcase(name, pattern)
        ]

    def _below(self, element: Term, path: str, attribute: str) -> Iterator[Written]:
        """Yield the numbers or the words of the *attribute* or else the text of an element.

        Those that it inherits count where they are written.

        It is *element* itself, or what *path* leads to: by tags, and properties that readers state.
        """
        starts = (
            (f"<{ATTRIBUTE}{attribute}", f"<{INHERITED}{attribute}") if attribute else (f"<{TEXT}",)
        )
        nodes = [element]
        for step in path.split("/") if path else ():
            nodes = [each for node in nodes for each in self._next(node, step)]
        for node in nodes:
            for property_, value in self.store.predicate_objects(node):
                if any(_says(property_, start) for start in starts):
                    yield from (Written(*e) for e in self.store.written(node, property_, value))

    def _next(self, element: Term, step: str) -> list[Term]:
        return [
            value
            for way, value in self.store.predicate_objects(element)
            if is_iri(value) and way.startswith(f"<{KINLINT}") and way.endswith(f"#{step}>")
        ]

    def _holders(self, cell: Term, predicate: Term) -> Iterator[tuple[Term, Term, int]]:
        """Yield what has a list with *cell* in it, by which property, and the place of the cell."""
        if predicate != FIRST:
            return
        place = 0
        while True:
            above = list(self.store.leading_to(cell))
            if not above:
                return
            for subject, way in above:
                if way != REST:
                    yield subject, way, place
            before = [subject for subject, way in above if way == REST]
            if not before:
                return
            cell, place = before[0], place + 1

    def _member(self, owner: Term, predicate: Term, place: int) -> Trace:
        """Return the origin of the item at *place* of the list that *owner* has."""
        return _merged(
            [
                self._evaluated(stated.members[place], row)
                for stated, derived in self.derivations(predicate)
                if place < len(stated.members)
                for row in self._rows(derived, stated.made.subject, owner)
            ]
        )


def _says(property_: Term, start: str) -> bool:
    """Tell whether *property_* is that of *start*, or of one of several numbers of it."""
    return property_.startswith(start) and property_[len(start)] in "->"


def _members(stated: Stated, value: Term, row: Row) -> Sequence[Derivation]:
    """Return how *value* comes about if the solution *row* makes a triple of *stated* with it.

    The value may be a list, or one member of it.
    """
    items = stated.made.items or (stated.made.object,)
    if stated.made.items is not None and is_blank(value):
        return stated.members
    pairs = zip(items, stated.members, strict=True)
    same = (member for name, member in pairs if row.get(name) == value)
    return tuple(islice(same, 1))


def _merged(traces: Sequence[Trace]) -> Trace:
    written = {
        (each.document.graph, each.triple): each for trace in traces for each in trace.written
    }
    signs = {trace.sign for trace in traces if trace.written}
    return Trace(tuple(written.values()), signs.pop() if len(signs) == 1 else 0)


@cache
def _worked_out() -> Sequence[tuple[str, str, str, str]]:
    """Return formats, properties, paths to elements and attributes of what readers work out."""
    file = resources.data("shapes") / WORKED_OUT
    with file.open(encoding="utf-8", newline="") as stream:
        rows = csv.DictReader(stream, delimiter="\t")
        names = ("format", "property", "element", "attribute")
        return [tuple(row[name] for name in names) for row in rows]  # type: ignore[misc]
