"""Prefixes that files of one model define differently."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping

from kinlint.facts.fact_statements import fact
from kinlint.facts.identifier_slips import split
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.formats.source_layer import src
from kinlint.terms import Term, Triple, is_iri, literal

NONE = literal("")
"""The empty prefix."""


def disagreements(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield for each definition of a prefix the namespace that more files define it as.

    Of two as common, it is the one in which more nodes are described, else the first by name. The
    empty prefix is each file's own.
    """
    terms, documents = scan.table(src("term")), scan.table(src("document"))
    prefixes: dict[Term, dict[Term, list[Term]]] = {}
    for definition, namespaces in scan.table(src("namespace")).items():
        for prefix in terms.values(definition):
            meanings = prefixes.setdefault(prefix, {})
            meanings.setdefault(namespaces[0], []).append(definition)
    differing = [
        each for prefix, each in sorted(prefixes.items()) if prefix != NONE and len(each) > 1
    ]
    described = _described(scan) if differing else {}
    for meanings in differing:
        files = {
            meaning: len({each for one in found for each in documents.values(one)})
            for meaning, found in meanings.items()
        }
        common = min(meanings, key=lambda each: (-files[each], -described.get(each, 0), each))
        for meaning, found in sorted(meanings.items()):
            if meaning != common:
                yield from ((one, fact("is-elsewhere"), common) for one in sorted(found))


def _described(scan: PredicateIndex) -> Mapping[Term, int]:
    """Return the number of nodes that files describe in each namespace, a literal."""
    return Counter(literal(split(node)[0]) for node in scan.described_nodes() if is_iri(node))
