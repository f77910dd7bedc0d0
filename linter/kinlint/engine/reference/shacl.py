"""Judges a model with pySHACL: the oracle of the default engine, and its deputy."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache
from pathlib import Path

import pyshacl
from rdflib import Graph, URIRef

from kinlint.document import Document
from kinlint.engine.compiler.query_permissions import check_permissions
from kinlint.engine.compiler.shape import messages, read_shape
from kinlint.engine.compiler.shapes_graph import ShapesGraph, Source, read
from kinlint.engine.compiler.sparql_constraints import (
    FEATURE,
    SPEAKS_OF,
    because,
    consumers,
    formats,
    named_for,
    severity,
    severity_for,
)
from kinlint.engine.constraint import Constraint
from kinlint.engine.ontology_index import Schema
from kinlint.engine.reference.owl import owlrl_closure
from kinlint.engine.reference.rdflib_terms import graph, term
from kinlint.engine.reference.recording import Record, recorded
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.errors import RuleInvalid
from kinlint.terms import Term, Triple, iri_value, is_blank, is_iri
from kinlint.vocabulary import SH

RESULT = URIRef(f"{SH}result")
PATH = f"<{SH}path>"
ADVANCED = {f"<{SH}{name}>" for name in ("target", "expression", "rule", "SPARQLFunction")}
"""Terms of SHACL Advanced Features, which pySHACL reads when told to."""


def check(
    documents: Iterable[Document],
    shape_files: Sequence[Source],
    vocabulary_files: Sequence[Path] = (),
    constraints: Iterable[Constraint] = (),
    computed: Iterable[Triple] = (),
) -> list[Result]:
    """Return the violations of the shapes in *shape_files* that pySHACL finds in *documents*.

    What follows from the vocabulary is inferred by owlrl; *computed* is what was lifted from other
    formats, and the facts. For the rest see `check_store`.
    """
    store = Store()
    store.load(documents)
    store.load_vocabulary(vocabulary_files)
    store.state(computed)
    stated = list(_statements(store))
    inferred = owlrl_closure(stated, vocabulary_files)
    return list(_judge([*stated, *inferred], shape_files, constraints))


def check_store(
    store: Store, shape_files: Sequence[Source], constraints: Iterable[Constraint] = ()
) -> list[Result]:
    """Return the violations of the shapes in *shape_files* that pySHACL finds in *store*, as it is.

    Results belong to those *constraints* that are meant, or to new ones that say the same. For
    blank shapes to have the names that the compiler gives them, *shape_files* must be the files it
    was given, in its order. Raises `RuleInvalid` for shapes that pySHACL cannot run.
    """
    return list(_judge(_statements(store), shape_files, constraints))


def check_deferred(
    store: Store, shape_files: Sequence[Source], constraints: Iterable[Constraint]
) -> list[Result]:
    """Return the violations in *store* of those *constraints* that the compiler deferred."""
    deferred = [each for each in constraints if each.deferred is not None]
    if not deferred:
        return []
    found = _judge(_statements(store), shape_files, deferred)
    return [result for result in found if result.constraint.deferred is not None]


def _statements(store: Store) -> Iterator[Triple]:
    """Yield the statements of *store*, documents in their own spelling."""
    for document in store.documents.values():
        yield from document.statements
    yield from Schema.read(store.vocabulary).triples
    yield from store.lifted()
    yield from store.inferred()
    yield from store.facts()


def _judge(
    data: Iterable[Triple], shape_files: Sequence[Source], constraints: Iterable[Constraint]
) -> Iterator[Result]:
    known: dict[tuple[Term, str], list[Constraint]] = {}
    for each in constraints:
        known.setdefault((each.shape, each.component), []).append(each)
    try:
        with recorded() as records:
            shapes, shapes_graph = _shapes(tuple(shape_files))
            _, report, text = pyshacl.validate(
                graph(data),
                shacl_graph=shapes_graph,
                inplace=True,
                inference="none",
                advanced=_is_advanced(shapes),
            )
    except RuleInvalid:
        raise
    except Exception as error:
        # pySHACL and rdflib have no common class for what they refuse.
        raise RuleInvalid(f"pySHACL cannot run these shapes: {error}") from error
    if not isinstance(report, Graph):
        raise RuleInvalid(f"pySHACL cannot run these shapes: {text}")
    for node in report.objects(None, RESULT):
        new = _constraint(shapes, records[node])
        meant = known.get((new.shape, new.component), ())
        same = [each for each in meant if each.messages == new.messages] or meant
        yield _result(same[0] if same else new, records[node])


@lru_cache(maxsize=8)
def _shapes(files: tuple[Source, ...]) -> tuple[ShapesGraph, Graph]:
    """Return the shapes of *files* as the compiler sees them and as pySHACL does."""
    shapes = read(files)
    check_permissions(shapes)
    return shapes, graph(triple for file in shapes.files for triple in file.triples)


def _is_advanced(shapes: ShapesGraph) -> bool:
    return any(not ADVANCED.isdisjoint(triple) for file in shapes.files for triple in file.triples)


def _constraint(shapes: ShapesGraph, record: Record) -> Constraint:
    shape = read_shape(shapes, term(record.shape))
    source = term(record.source) if record.source is not None else None
    said = messages(shapes, source) if source is not None else ()
    own = severity(shapes, source) if source is not None else ""
    path = shapes.one(shape.node, PATH)
    return Constraint(
        owner=shape.owner,
        shape=shape.node,
        component=iri_value(term(record.component)),
        severity=own or shape.severity,
        messages=said or shape.messages,
        because=because(shapes, source) if source is not None else "",
        path=path if path is not None and is_iri(path) else None,
        formats=formats(shapes, source) if source is not None else (),
        consumers=consumers(shapes, source) if source is not None else (),
        severity_for=severity_for(shapes, source) if source is not None else (),
        feature=named_for(shape, source, FEATURE) if source is not None else "",
        speaks_of=named_for(shape, source, SPEAKS_OF) if source is not None else "",
    )


def _result(constraint: Constraint, record: Record) -> Result:
    focus = term(record.focus)
    value = term(record.value) if record.value is not None else None
    path = term(record.path) if record.path is not None else None
    bindings = {name: term(node) for name, node in record.bindings.items()}
    if value is not None:
        bindings["value"] = value
    return Result(
        constraint=constraint,
        focus=focus,
        path=None if path is None or is_blank(path) else path,
        value=value,
        bindings=bindings | {"this": focus},
    )
