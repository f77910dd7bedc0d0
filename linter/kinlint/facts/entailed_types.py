"""Classes that nodes are of only by inference."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.facts.fact_statements import fact
from kinlint.facts.metamodel_terms import kin
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.terms import Triple, is_iri


def entailed_types(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield the inferred types of classes that the ontology wants stated with others."""
    kinds = {kind for _, several in scan.table(kin("statedWith")).items() for kind in several}
    for kind in sorted(filter(is_iri, kinds)):
        yield from ((node, fact("entailed-type"), kind) for node in sorted(scan.inferred(kind)))
