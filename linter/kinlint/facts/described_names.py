"""The nodes that files describe, and the namespaces in which they do."""

from __future__ import annotations

from kinlint.facts.predicate_index import PredicateIndex
from kinlint.formats.source_layer import src
from kinlint.terms import Term, literal_value


def described_nodes(scan: PredicateIndex) -> set[Term]:
    """Return the nodes that a document describes."""
    return {node for document in scan.documents for node in document.map.nodes}


def own_namespaces(scan: PredicateIndex) -> set[str]:
    """Return the namespaces in which a document describes something."""
    owned = scan.table(src("ownNamespace"))
    return {literal_value(space) for _, spaces in owned.items() for space in spaces}
