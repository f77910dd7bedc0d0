"""Checks one closed graph with one catalogue, by the default engine and by pySHACL."""

from __future__ import annotations

import sys
import threading
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, TypeAlias

import pyshacl
from rdflib import RDF, Graph
from rdflib.namespace import SH
from rdflib.plugins.sparql import evaluate

from benchmarks.stages import parsed
from benchmarks.timing import interleaved
from kinlint.catalogue.rulebook import Rulebook
from kinlint.document import Document
from kinlint.engine.closure import close
from kinlint.engine.compiler.shapes_graph import read as read_shapes
from kinlint.engine.constraint import Constraint
from kinlint.engine.evaluate import check
from kinlint.engine.literal_spelling import normal
from kinlint.engine.ontology_index import Schema
from kinlint.engine.reference.rdflib_terms import graph, term
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.facts.computation import facts
from kinlint.terms import Term, iri, is_blank

DEPTH = 1_000_000
"""Python's recursion limit for pySHACL: rdflib walks a path of n steps with n nested calls."""

STACK = 1 << 30
"""The bytes of stack that so deep a recursion may need."""

GROUPS = (evaluate, "evalAggregateJoin")

Key: TypeAlias = tuple[Term, Term, Term | None, Term | None]
"""What counts of a result: shape, focus, path and value."""


@dataclass(frozen=True)
class Subject:
    """A closed model and a catalogue, in the form that each engine takes them."""

    store: Store
    constraints: tuple[Constraint, ...]
    data: Graph
    shapes: Graph

    @classmethod
    def of(cls, document: Document, rulebook: Rulebook) -> Subject:
        """*document* with what follows from it, to be judged by all of *rulebook*."""
        store = Store()
        store.load([document])
        store.load_vocabulary(rulebook.vocabulary)
        close(store, rulebook.axioms)
        store.state(facts(store))
        statements = (
            *document.statements,
            *Schema.read(store.vocabulary).triples,
            *store.inferred(),
            *store.facts(),
        )
        files = read_shapes(rulebook.shapes).files
        blank = {each.shape for each in rulebook.constraints if is_blank(each.shape)}
        shapes = (
            (_name(s) if s in blank else s, p, _name(o) if o in blank else o)
            for file in files
            for s, p, o in file.triples
        )
        return cls(store, rulebook.constraints, graph(statements), graph(shapes))

    def ours(self) -> list[Result]:
        """What the compiled catalogue finds in the store."""
        return list(check(self.store, self.constraints))

    def theirs(self) -> Graph:
        """The report of pySHACL, called as its users call it."""
        with _grouping():
            _, report, text = pyshacl.validate(self.data, shacl_graph=self.shapes)
        assert isinstance(report, Graph), text
        return report


def compared(joints: int, rulebook: Rulebook, runs: int) -> tuple[float, float]:
    """The median seconds in which each engine checks a spoiled chain of *joints*.

    Raises `AssertionError` if they do not find the same.
    """
    subject = Subject.of(parsed(joints), rulebook)
    theirs: list[Graph] = []
    seconds: list[float] = []

    def measure() -> None:
        actions = (subject.ours, lambda: theirs.append(subject.theirs()))
        seconds.extend(interleaved(actions, runs))

    deeply(measure)
    found, meant = our_keys(subject.ours()), their_keys(theirs[0])
    assert found == meant, f"only ours: {found - meant}; only pySHACL's: {meant - found}"
    one, other = seconds
    return one, other


def our_keys(results: Iterable[Result]) -> Counter[Key]:
    """What counts of each of *results*."""
    return Counter(
        _key(_name(each.constraint.shape), each.focus, each.path, each.value) for each in results
    )


def their_keys(report: Graph) -> Counter[Key]:
    """What counts of each result in a SHACL *report*."""
    found: Counter[Key] = Counter()
    for result in report.subjects(RDF.type, SH.ValidationResult):
        shape, focus, path, value = (
            None if (said := report.value(result, name)) is None else term(said)
            for name in (SH.sourceShape, SH.focusNode, SH.resultPath, SH.value)
        )
        assert shape is not None
        assert focus is not None
        # The path of a shape that is no predicate is a blank node; ours leaves it out.
        found[_key(shape, focus, None if path and is_blank(path) else path, value)] += 1
    return found


def deeply(act: Callable[[], None]) -> None:
    """Do *act* where recursion may go as deep as rdflib goes along the path of a long chain."""
    limit, stack = sys.getrecursionlimit(), threading.stack_size(STACK)
    sys.setrecursionlimit(DEPTH)
    failed: list[Exception] = []

    def attempt() -> None:
        try:
            act()
        except Exception as error:  # noqa: BLE001  a thread would only print it
            failed.append(error)

    try:
        thread = threading.Thread(target=attempt)
        thread.start()
        thread.join()
    finally:
        sys.setrecursionlimit(limit)
        threading.stack_size(stack)
    if failed:
        raise failed[0]


@contextmanager
def _grouping() -> Iterator[None]:
    """Corrects rdflib, at no cost: GROUP BY makes no group of nothing (SPARQL 1.1, 18.5.1).

    The empty one that it makes joins with everything: violations that nobody else finds.
    """
    original = getattr(*GROUPS)

    def groups(context: Any, part: Any) -> Iterator[Any]:
        rows = original(context, part)
        return rows if part.p.expr is None else (row for row in rows if len(row))

    setattr(*GROUPS, groups)
    try:
        yield
    finally:
        setattr(*GROUPS, original)


def _name(shape: Term) -> Term:
    """An IRI for a blank shape: pySHACL renames blank nodes in its report."""
    return iri(f"urn:shape:{shape[2:]}") if is_blank(shape) else shape


def _key(shape: Term, focus: Term, path: Term | None, value: Term | None) -> Key:
    """Blank nodes are equal here: pySHACL renames them in its report."""
    focus = "_:" if is_blank(focus) else focus
    if value is not None:
        value = "_:" if is_blank(value) else normal(value)
    return shape, focus, path, value
