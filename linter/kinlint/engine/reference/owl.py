"""Closes a graph with owlrl: the oracle of the compiled axioms."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from rdflib import Graph
from rdflib.term import Node

from kinlint.engine.expressions import NOTHING
from kinlint.engine.literal_spelling import normal
from kinlint.engine.ontology_index import Schema
from kinlint.engine.reference.rdflib_terms import graph, node, term
from kinlint.terms import (
    RDF,
    RDF_TYPE,
    XSD,
    Term,
    Triple,
    is_blank,
    is_iri,
    is_literal,
    literal_value,
)
from kinlint.vocabulary import OWL, RDFS

COMPLAINTS = "http://www.daml.org/2002/03/agents/agent-ont#"
"""The namespace in which owlrl complains about literals that are not in canonical form."""

SCHEMA = tuple(f"<{namespace}" for namespace in (OWL, RDFS, RDF, XSD, COMPLAINTS))
"""The beginnings of terms about terms."""

AXIOMS = (OWL, RDFS)
"""The beginnings of the properties of axioms."""
META = (OWL, RDF)
"""The beginnings of the types of classes and properties."""

MOST = f"<{OWL}maxCardinality>"

EQUALITY = (
    f"<{OWL}FunctionalProperty>",
    f"<{OWL}InverseFunctionalProperty>",
    f"<{OWL}hasKey>",
    f"<{OWL}sameAs>",
    MOST,
    f"<{OWL}maxQualifiedCardinality>",
)
"""Axioms that equate things. Rules report what breaks them; nothing is inferred from them."""


def owlrl_complaints(
    triples: Iterable[Triple], vocabulary_files: Sequence[Path] = ()
) -> frozenset[str]:
    """Return the inconsistencies of *triples* and the vocabulary, in owlrl's own words.

    It is asked about axioms that equate nothing. Values that are literals it names as it likes.
    """
    closed = _expanded(_unequated({*triples, *Schema.read(vocabulary_files).triples}))
    return frozenset(str(text) for text in closed.objects(None, node(f"<{COMPLAINTS}error>")))


def owlrl_closure(triples: Iterable[Triple], vocabulary_files: Sequence[Path] = ()) -> set[Triple]:
    """Return what OWL 2 RL adds to *triples* and the vocabulary, as the store spells it.

    Left out is what `compile_axioms` leaves out: statements about classes, properties and literals,
    memberships in anonymous classes, in datatypes and in built-in classes other than owl:Nothing,
    and equality.
    """
    stated = _unequated({*triples, *Schema.read(vocabulary_files).triples})
    schema = {s for s, p, o in stated if p.startswith(SCHEMA) and (p != RDF_TYPE or _is_meta(o))}
    closed = _expanded(stated)
    known = {(s, p, normal(o)) for s, p, o in stated}
    found = ((term(s), term(p), normal(term(o))) for s, p, o in closed)
    return {each for each in found if each not in known and _is_wanted(each, schema)}


def _unequated(stated: set[Triple]) -> set[Triple]:
    """Return *stated* less the axioms that equate things, which a cardinality of zero does not."""
    none = {s for s, p, o in stated if p == MOST and literal_value(o) == "0"}
    return {each for each in stated if each[0] in none or not {each[1], each[2]} & {*EQUALITY}}


def _expanded(stated: Iterable[Triple]) -> Graph:
    """Return the closure of *stated*, in which nothing is equated.

    owlrl would say of each term that it equals itself, which takes most of its time. All rules but
    those of equality begin with a triple of the schema.
    """
    from owlrl import DeductiveClosure, OWLRL_Semantics  # noqa: PLC0415

    class Unequated(OWLRL_Semantics):  # type: ignore[misc]
        def rules(self, triple: tuple[Node, Node, Node], cycle_num: int) -> None:
            _, predicate, value = map(str, triple)
            if predicate.startswith(AXIOMS) or value.startswith(META):
                super().rules(triple, cycle_num)

        def _equality(self, triple: tuple[Node, Node, Node], cycle_num: int) -> None:
            pass

    closed = graph(stated, "SimpleMemory")
    DeductiveClosure(Unequated, axiomatic_triples=False, datatype_axioms=False).expand(closed)
    return closed


def _is_meta(kind: Term) -> bool:
    return kind.startswith(SCHEMA)


def _is_wanted(triple: Triple, schema: set[Term]) -> bool:
    subject, predicate, value = triple
    if is_literal(subject) or subject in schema or subject.startswith(SCHEMA):
        return False
    if predicate == RDF_TYPE:
        return value == NOTHING or (is_iri(value) and not _is_meta(value))
    return not predicate.startswith(SCHEMA) and not is_blank(predicate)
