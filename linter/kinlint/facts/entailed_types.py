"""Classes that nodes are of only by inference."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.facts.fact_statements import fact
from kinlint.facts.metamodel_terms import kin
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.formats.source_layer import DESCRIBED, src
from kinlint.terms import Term, Triple, iri, is_iri
from kinlint.vocabulary import RDFS

UNREAD = (src("UnresolvedContext"), src("InvalidContext"))
"""Kinds of contexts that could not be read."""


def entailed_types(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield the inferred types of published classes that the ontology wants stated.

    Nothing is said of a node whose types an unread context may state, nor of a class that the
    release of the contexts in use does not have.
    """
    kinds = {kind for _, several in scan.table(kin("statedWith")).items() for kind in several}
    published = scan.table(iri(f"{RDFS}isDefinedBy"))
    kinds |= {
        kind
        for side in ("domain", "range")
        for _, several in scan.table(iri(f"{RDFS}{side}")).items()
        for kind in several
        if published.values(kind)
    }
    inferred = {kind: scan.inferred(kind) for kind in sorted(filter(is_iri, kinds))}
    if not any(inferred.values()):
        return
    described, releases = scan.table(DESCRIBED), scan.table(kin("inRelease"))
    uncertain, used = _uncertain(scan), _releases(scan)
    for kind, nodes in inferred.items():
        known = set(releases.values(kind))
        for node in sorted(nodes):
            documents = described.values(node)
            lacking = any(
                known and used.get(each) and known.isdisjoint(used[each]) for each in documents
            )
            if not lacking and uncertain.isdisjoint(documents):
                yield node, fact("entailed-type"), kind


def _uncertain(scan: PredicateIndex) -> set[Term]:
    """Return the documents with a context that could not be read."""
    documents = scan.table(src("document"))
    problems = (problem for kind in UNREAD for problem in scan.instances(kind))
    return {each for problem in problems for each in documents.values(problem)}


def _releases(scan: PredicateIndex) -> dict[Term, set[Term]]:
    """Return the releases of the contexts that each document names."""
    releases = scan.table(src("release"))
    return {
        document: {each for use in uses for each in releases.values(use)}
        for document, uses in scan.table(src("usesContext")).items()
    }
