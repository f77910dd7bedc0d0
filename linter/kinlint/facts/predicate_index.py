"""Index of a closed model by predicate: each is read once, whatever the number of nodes."""

from __future__ import annotations

import math
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from typing import TypeAlias

import pyoxigraph as ox

from kinlint.document import Document
from kinlint.engine.store import Store, statement, token
from kinlint.formats.source_layer import src
from kinlint.terms import (
    RDF,
    RDF_TYPE,
    XSD,
    Term,
    iri,
    iri_value,
    is_iri,
    is_literal,
    literal_value,
)
from kinlint.vocabulary import INFERRED_GRAPH

Place: TypeAlias = tuple[int, int, Term]

FIRST = iri(f"{RDF}first")
REST = iri(f"{RDF}rest")
NIL = iri(f"{RDF}nil")
NUMERIC = frozenset(f"^^<{XSD}{name}>" for name in ("double", "float", "decimal", "integer"))


def numeric(term: Term) -> float | None:
    """Return the number a literal stands for, by value; None for what is no finite number."""
    text, _, datatype = term.rpartition('"')
    if datatype not in NUMERIC or not is_literal(term):
        return None
    text = text[1:]
    try:
        number = float(text)
    except ValueError:
        return None
    return number if math.isfinite(number) and "_" not in text else None


def number_of(values: Iterable[Term]) -> float | None:
    """Return the number that all *values* stand for; None if that is not exactly one."""
    distinct = {numeric(each) for each in values}
    return distinct.pop() if len(distinct) == 1 else None


class Table:
    """Values of one property. Most subjects have one, which costs no list."""

    def __init__(self) -> None:
        self.one: dict[Term, Term] = {}
        self.several: dict[Term, list[Term]] = {}

    def add(self, subject: Term, value: Term) -> None:
        """Add a value that *subject* does not have yet."""
        if subject in self.one:
            self.several[subject] = [self.one.pop(subject), value]
        elif subject in self.several:
            self.several[subject].append(value)
        else:
            self.one[subject] = value

    def values(self, subject: Term) -> Sequence[Term]:
        """Return all values of *subject*."""
        value = self.one.get(subject)
        return self.several.get(subject, ()) if value is None else (value,)

    def items(self) -> Iterator[tuple[Term, Sequence[Term]]]:
        """Yield the subjects, each with all its values."""
        for subject, value in self.one.items():
            yield subject, (value,)
        yield from self.several.items()

    def __contains__(self, subject: Term) -> bool:
        return subject in self.one or subject in self.several

    def __bool__(self) -> bool:
        return bool(self.one or self.several)


class PredicateIndex:
    """Statements of a store, predicate by predicate. Every table is read once and then kept."""

    def __init__(self, store: Store) -> None:
        self.store = store
        self._tables: dict[Term, Table] = {}
        self._numbers: dict[Term, dict[Term, float]] = {}
        self._instances: dict[Term, frozenset[Term]] = {}

    def part(self, _name: str, *_below: str) -> PredicateIndex:
        """Return the index that a part of the computation reads, which uses the parts *below*."""
        return self

    def table(self, predicate: Term) -> Table:
        """Return all values of *predicate*, by subject."""
        if predicate not in self._tables:
            node = ox.NamedNode(iri_value(predicate))
            self._tables[predicate] = table = Table()
            quads = self.store.oxigraph.quads_for_pattern(None, node, None, None)
            for subject, value in sorted(
                [(str(each.subject), token(each.object)) for each in quads]
            ):
                table.add(subject, value)
        return self._tables[predicate]

    def statements(self, node: Term) -> Mapping[Term, list[Term]]:
        """Return all statements about an IRI, by property."""
        found: dict[Term, list[Term]] = {}
        if is_iri(node):
            subject = statement((node, RDF_TYPE, NIL)).subject
            for quad in self.store.oxigraph.quads_for_pattern(subject, None, None, None):
                found.setdefault(token(quad.predicate), []).append(token(quad.object))
            for values in found.values():
                values.sort()
        return found

    def described_nodes(self) -> set[Term]:
        """Return the nodes that a document describes."""
        return {node for document in self.documents for node in document.map.nodes}

    def own_namespaces(self) -> set[str]:
        """Return the namespaces in which a document describes most of its names."""
        owned = self.table(src("ownNamespace"))
        return {literal_value(space) for _, spaces in owned.items() for space in spaces}

    def single(self, predicate: Term) -> Mapping[Term, Term]:
        """Return the value of *predicate* for the subjects that have exactly one."""
        return self.table(predicate).one

    def numbers(self, predicate: Term) -> Mapping[Term, float]:
        """Return the number that *predicate* has for the subjects with exactly one."""
        if predicate not in self._numbers:
            table = self.table(predicate)
            found = {subject: numeric(value) for subject, value in table.one.items()}
            for subject, values in table.several.items():
                found[subject] = number_of(values)
            self._numbers[predicate] = {
                subject: number for subject, number in found.items() if number is not None
            }
        return self._numbers[predicate]

    def lists(self, predicate: Term, length: int) -> Mapping[Term, tuple[float, ...]]:
        """Return the list of *length* numbers that *predicate* has, where there is one."""
        found: dict[Term, tuple[float, ...]] = {}
        for subject, heads in self.table(predicate).items():
            distinct = {self._row(head, length) for head in heads}
            if len(distinct) == 1 and (row := distinct.pop()) is not None:
                found[subject] = row
        return found

    def _row(self, head: Term, length: int) -> tuple[float, ...] | None:
        items = self.items(head, length + 1)
        if items is None or len(items) != length:
            return None
        row = tuple(number for item in items if (number := numeric(item)) is not None)
        return row if len(row) == length else None

    def items(self, head: Term, most: int = sys.maxsize) -> tuple[Term, ...] | None:
        """Return the items of the list at *head*, at most *most*.

        None for what is no proper list.
        """
        cells = self.cells(head, most)
        return None if cells is None else tuple(self._first[cell] for cell in cells)

    def cells(self, head: Term, most: int = sys.maxsize) -> tuple[Term, ...] | None:
        """Return the nodes that hold the items of the list at *head*, in the order of `items`."""
        found: dict[Term, None] = {}
        while head != NIL and len(found) < most:
            rest = self._rest.get(head)
            if rest is None or head not in self._first or head in found:
                return None
            found[head] = None
            head = rest
        return tuple(found)

    @cached_property
    def _first(self) -> Mapping[Term, Term]:
        return self.single(FIRST)

    @cached_property
    def _rest(self) -> Mapping[Term, Term]:
        return self.single(REST)

    def instances(self, kind: Term) -> frozenset[Term]:
        """Return the nodes that are of class *kind*, stated or inferred."""
        if kind not in self._instances:
            quads = self.store.oxigraph.quads_for_pattern(
                None, ox.NamedNode(iri_value(RDF_TYPE)), ox.NamedNode(iri_value(kind)), None
            )
            self._instances[kind] = frozenset(token(quad.subject) for quad in quads)
        return self._instances[kind]

    def inferred(self, kind: Term) -> frozenset[Term]:
        """Return the nodes that are of class *kind* only by inference."""
        quads = self.store.oxigraph.quads_for_pattern(
            None,
            ox.NamedNode(iri_value(RDF_TYPE)),
            ox.NamedNode(iri_value(kind)),
            ox.NamedNode(iri_value(INFERRED_GRAPH)),
        )
        return frozenset(token(quad.subject) for quad in quads)

    def all_values(self, node: Term) -> frozenset[Term]:
        """Return the values of all statements about *node*."""
        subject = statement((node, RDF_TYPE, NIL)).subject
        quads = self.store.oxigraph.quads_for_pattern(subject, None, None, None)
        return frozenset(token(quad.object) for quad in quads)

    def place(self, node: Term) -> Place:
        """Return a key that sorts nodes by where they are described first; others come last."""
        index = self._home.get(node)
        if index is None:
            return sys.maxsize, 0, node
        return index, self.documents[index].map.nodes[node].whole.start, node

    @cached_property
    def _home(self) -> Mapping[Term, int]:
        """Index of the first document that describes each node."""
        homes: dict[Term, int] = {}
        for index in reversed(range(len(self.documents))):
            homes.update(dict.fromkeys(self.documents[index].map.nodes, index))
        return homes

    @cached_property
    def documents(self) -> tuple[Document, ...]:
        """Documents of the store, in its order."""
        return tuple(self.store.documents.values())
