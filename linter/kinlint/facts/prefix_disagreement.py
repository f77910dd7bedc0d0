"""Prefixes that files of one model define differently."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.facts.fact_statements import fact
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.formats.source_layer import src
from kinlint.terms import Term, Triple


def disagreements(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield for each definition of a prefix the namespace that more files define it as.

    Of two as common, it is the one in which a file describes something, else the first by name.
    """
    terms, documents = scan.table(src("term")), scan.table(src("document"))
    prefixes: dict[Term, dict[Term, list[Term]]] = {}
    for definition, namespaces in scan.table(src("namespace")).items():
        for prefix in terms.values(definition):
            meanings = prefixes.setdefault(prefix, {})
            meanings.setdefault(namespaces[0], []).append(definition)
    owned = {name for _, names in scan.table(src("ownNamespace")).items() for name in names}
    for _, meanings in sorted(prefixes.items()):
        if len(meanings) > 1:
            files = {
                meaning: len({each for one in found for each in documents.values(one)})
                for meaning, found in meanings.items()
            }
            common = min(meanings, key=lambda each: (-files[each], each not in owned, each))
            for meaning, found in sorted(meanings.items()):
                if meaning != common:
                    yield from ((one, fact("common-namespace"), common) for one in sorted(found))
