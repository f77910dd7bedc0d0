"""Reads OWL 2 RL axioms from Turtle and compiles them into rules over triples."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path

from kinlint.engine.axioms import Axiom, name
from kinlint.engine.expressions import Expressions
from kinlint.engine.ontology_index import INVERSE, Schema
from kinlint.engine.regularity import check_regular
from kinlint.engine.strata import stratified
from kinlint.terms import Term, is_iri
from kinlint.vocabulary import OWL, RDFS

DEFINITIONS = ("intersectionOf", "unionOf", "onProperty")


def compile_axioms(files: Iterable[Path]) -> tuple[Axiom, ...]:
    """Return the axioms of ontology *files* that conclude triples, in order of evaluation.

    Read are, by OWL 2 Profiles 4.3: cax-sco, cax-eqc, prp-spo1, prp-spo2, prp-eqp, prp-dom,
    prp-rng, prp-inv, prp-symp, prp-trp, cls-int, cls-uni, cls-svf, cls-avf and cls-hv, with class
    expressions nested to any depth and no membership in anonymous classes. Nothing is concluded
    about equality, datatypes or the schema itself, and disjointness is left to rules.

    Raises `RuleInvalid` for a file that is no Turtle and for property chains without the order that
    `check_regular` asks of them.
    """
    schema = Schema.read(files)
    check_regular(schema)
    distinct: dict[object, Axiom] = {}
    for axiom in (*_properties(schema), *_typings(schema), *_classes(schema)):
        if axiom.head not in axiom.body:
            distinct.setdefault((axiom.body, axiom.head), axiom)
    return stratified(list(distinct.values()))


def _properties(schema: Schema) -> Iterator[Axiom]:
    """Yield the axioms by which a relation between two things implies other relations."""
    for part, whole in schema.pairs(f"<{RDFS}subPropertyOf>"):
        yield _renamed(schema, part, whole, f"{schema.phrase(part)} implies {name(whole)}")
    for one, other in schema.pairs(f"<{OWL}equivalentProperty>"):
        label = f"{name(one)} means the same as {name(other)}"
        yield _renamed(schema, one, other, label)
        yield _renamed(schema, other, one, label)
    for one, other in schema.pairs(INVERSE):
        if is_iri(one) and is_iri(other):
            label = f"{name(one)} is the inverse of {name(other)}"
            yield Axiom(label, (("?x", other, "?y"),), ("?y", one, "?x"))
            yield Axiom(label, (("?x", one, "?y"),), ("?y", other, "?x"))
    for each in schema.instances(f"<{OWL}SymmetricProperty>"):
        yield Axiom(f"{name(each)} is symmetric", (("?x", each, "?y"),), ("?y", each, "?x"))
    for each in schema.instances(f"<{OWL}TransitiveProperty>"):
        twice = (("?x", each, "?y"), ("?y", each, "?z"))
        yield Axiom(f"{name(each)} is transitive", twice, ("?x", each, "?z"))
    for whole, items in schema.pairs(f"<{OWL}propertyChainAxiom>"):
        parts = schema.list(items)
        nodes = ["?x", *(f"?y{index}" for index in range(1, len(parts))), "?z"]
        arcs = zip(parts, nodes, nodes[1:], strict=False)
        body = tuple(schema.arc(part, start, end) for part, start, end in arcs)
        label = f"{', then '.join(map(schema.phrase, parts))} makes {name(whole)}"
        yield Axiom(label, body, ("?x", whole, "?z"))


def _typings(schema: Schema) -> Iterator[Axiom]:
    """Yield the axioms by which a relation between two things implies their classes."""
    expressions = Expressions(schema)
    for each, kind in schema.pairs(f"<{RDFS}domain>"):
        label = f"whatever has {name(each)}"
        yield from expressions.conclusions(kind, "?x", (("?x", each, "?y"),), label)
    for each, kind in schema.pairs(f"<{RDFS}range>"):
        label = f"every value of {name(each)}"
        yield from expressions.conclusions(kind, "?y", (("?x", each, "?y"),), label)


def _classes(schema: Schema) -> Iterator[Axiom]:
    """Yield the axioms by which membership in a class implies others."""
    expressions = Expressions(schema)
    for part, whole in schema.pairs(f"<{RDFS}subClassOf>"):
        yield from expressions.implication(part, whole)
    for one, other in schema.pairs(f"<{OWL}equivalentClass>"):
        yield from expressions.implication(one, other)
        yield from expressions.implication(other, one)
    for keyword in DEFINITIONS:
        for defined, _ in schema.pairs(f"<{OWL}{keyword}>"):
            if is_iri(defined):
                yield from expressions.definition(defined)


def _renamed(schema: Schema, part: Term, whole: Term, label: str) -> Axiom:
    return Axiom(label, (schema.arc(part, "?x", "?y"),), schema.arc(whole, "?x", "?y"))
