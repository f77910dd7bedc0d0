"""Nodes that contradict an axiom of the ontology, so that rules judge only those."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinlint.engine.expressions import NOTHING
from kinlint.facts.fact_statements import fact
from kinlint.facts.predicate_index import PredicateIndex, numeric
from kinlint.terms import Term, Triple, is_iri
from kinlint.vocabulary import OWL, RDFS

EXCLUDED = fact("excluded-type")
"""Property from a node to a class it is of that is disjoint with another of its classes."""

CONTRADICTED = fact("contradicted")
"""Property from a node to a class or property whose axioms its statements break."""


def contradictions(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield what OWL 2 RL calls inconsistent, but for equality, datatypes and negative assertions.

    By OWL 2 Profiles 4.3: cax-dw, cax-adc, prp-irp, prp-asyp, prp-pdw, prp-adp, cls-nothing2,
    cls-com and cls-maxc1.
    """
    found = {(node, EXCLUDED, kind) for node, kind in _excluded(scan)}
    found |= {(node, CONTRADICTED, axiom) for node, axiom in _contradicted(scan)}
    yield from sorted(found)


def _excluded(scan: PredicateIndex) -> Iterator[tuple[Term, Term]]:
    for kinds in _disjoint(scan, "disjointWith", "AllDisjointClasses"):
        seen: frozenset[Term] = frozenset()
        for kind in kinds:
            members = _members(scan, kind)
            yield from ((node, kind) for node in seen & members)
            seen |= members


def _contradicted(scan: PredicateIndex) -> Iterator[tuple[Term, Term]]:
    for each in (*_kind(scan, "IrreflexiveProperty"), *_kind(scan, "AsymmetricProperty")):
        yield from ((node, each) for node, value in _pairs(scan, each) if node == value)
    for each in _kind(scan, "AsymmetricProperty"):
        arcs = frozenset(_pairs(scan, each))
        yield from ((node, each) for node, value in arcs if (value, node) in arcs)
    for properties in _disjoint(scan, "propertyDisjointWith", "AllDisjointProperties"):
        seen: frozenset[tuple[Term, Term]] = frozenset()
        for each in properties:
            arcs = frozenset(_pairs(scan, each))
            yield from ((node, each) for node, _ in seen & arcs)
            seen |= arcs
    yield from ((node, NOTHING) for node in scan.instances(NOTHING))
    yield from _bounded(scan)


def _bounded(scan: PredicateIndex) -> Iterator[tuple[Term, Term]]:
    """Yield nodes with a property that their class excludes, or of a class and its complement."""
    most = scan.table(f"<{OWL}maxCardinality>")
    none = {bound for bound, values in most.items() if numeric(values[0]) == 0}
    for keyword in (f"<{RDFS}subClassOf>", f"<{OWL}equivalentClass>"):
        for kind, bounds in scan.table(keyword).items():
            for bound in bounds:
                if bound in none:
                    for each in scan.table(f"<{OWL}onProperty>").values(bound):
                        having = (node for node, _ in _pairs(scan, each))
                        yield from ((n, each) for n in _members(scan, kind).intersection(having))
                for other in scan.table(f"<{OWL}complementOf>").values(bound):
                    yield from ((n, kind) for n in _members(scan, kind) & _members(scan, other))
    for kind, others in scan.table(f"<{OWL}complementOf>").items():
        for other in others:
            yield from ((n, kind) for n in _members(scan, kind) & _members(scan, other))


def _disjoint(scan: PredicateIndex, pair: str, several: str) -> Iterator[Iterable[Term]]:
    """Yield the groups of classes, or of properties, that exclude each other."""
    for one, others in scan.table(f"<{OWL}{pair}>").items():
        yield from ((one, other) for other in others)
    members = scan.table(f"<{OWL}members>")
    for group in scan.instances(f"<{OWL}{several}>"):
        for head in members.values(group):
            yield scan.items(head) or ()


def _kind(scan: PredicateIndex, kind: str) -> frozenset[Term]:
    return scan.instances(f"<{OWL}{kind}>")


def _members(scan: PredicateIndex, kind: Term) -> frozenset[Term]:
    return scan.instances(kind) if is_iri(kind) else frozenset()


def _pairs(scan: PredicateIndex, relation: Term) -> Iterator[tuple[Term, Term]]:
    for subject, values in scan.table(relation).items() if is_iri(relation) else ():
        yield from ((subject, value) for value in values)
