"""Prefixes that files of one model define differently."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator

from kinlint.facts.fact_statements import fact
from kinlint.facts.identifier_slips import split
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.formats.source_layer import src
from kinlint.terms import Term, Triple, iri, iri_value, is_iri, literal, literal_value

NONE = literal("")
"""The empty prefix."""


def disagreements(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield for each definition of a prefix the namespace that more files define it as.

    Of two as common, it is the one in which more nodes are described, else the first by name. The
    empty prefix is each file's own. It comes with the names that would meet if all files defined it
    alike; if there are none, with a prefix by which other files describe most of the namespace, or
    which the same file defines as it, too.
    """
    terms, documents = scan.table(src("term")), scan.table(src("document"))
    prefixes: dict[Term, dict[Term, list[Term]]] = {}
    for definition, namespaces in scan.table(src("namespace")).items():
        for prefix in terms.values(definition):
            meanings = prefixes.setdefault(prefix, {})
            meanings.setdefault(namespaces[0], []).append(definition)
    differing = [
        prefix for prefix, each in sorted(prefixes.items()) if prefix != NONE and len(each) > 1
    ]
    if not differing:
        return
    described, missed = _described(scan), MissedNames(scan)
    for prefix in differing:
        meanings = prefixes[prefix]
        files = {
            meaning: len({each for one in found for each in documents.values(one)})
            for meaning, found in meanings.items()
        }
        common = min(meanings, key=lambda each: (-files[each], -described[each], each))
        for meaning, found in sorted(meanings.items()):
            if meaning == common:
                continue
            yield from ((one, fact("is-elsewhere"), common) for one in sorted(found))
            met = list(missed.names(sorted(found), meaning, common))
            yield from met
            if met:
                continue
            for other in sorted(each for each in prefixes if meaning in prefixes[each]):
                if other != prefix and missed.is_theirs(found, prefixes[other][meaning], meaning):
                    yield from ((one, fact("called-elsewhere"), other) for one in sorted(found))


def _described(scan: PredicateIndex) -> Counter[Term]:
    """Return the number of nodes that files describe in each namespace, a literal."""
    return Counter(literal(split(node)[0]) for node in scan.described_nodes() if is_iri(node))


class MissedNames:
    """Names of files that would meet those of others if a prefix meant the same in all of them."""

    def __init__(self, scan: PredicateIndex) -> None:
        self._described = scan.described_nodes()
        self._values = {value for each in scan.documents for _, _, value in each.statements}
        self._documents = {each.graph: each for each in scan.documents}
        self._homes = scan.table(src("document"))

    def names(self, definitions: Iterable[Term], own: Term, common: Term) -> Iterator[Triple]:
        """Yield what a file that defines a prefix as *own* describes or refers to in *common*."""
        before, after = literal_value(own), literal_value(common)
        for one in definitions:
            found = set[Term]()
            for home in self._homes.values(one):
                for subject, _, value in self._documents[home].statements:
                    for name in (subject, value):
                        if is_iri(name) and iri_value(name).startswith(before):
                            meant = iri(after + iri_value(name)[len(before) :])
                            if self._meet(name, meant):
                                found.add(meant)
            yield from ((one, fact("meant-elsewhere"), name) for name in sorted(found))

    def is_theirs(self, own: Iterable[Term], their: Iterable[Term], meaning: Term) -> bool:
        """Tell whether the namespace *meaning* is that of another prefix.

        Files that define *their* prefix as it describe most of it, or a file with the *own* prefix
        has that one, too.
        """
        homes, others = (
            {each for one in definitions for each in self._homes.values(one)}
            for definitions in (own, their)
        )
        if homes & others:
            return True
        return self._described_by(others, meaning) > 2 * self._described_by(homes, meaning) > 0

    def _described_by(self, homes: Iterable[Term], own: Term) -> int:
        """Return how many names of the namespace *own* the files *homes* describe."""
        return sum(
            is_iri(node) and split(node)[0] == literal_value(own)
            for home in homes
            for node in self._documents[home].map.nodes
        )

    def _meet(self, name: Term, meant: Term) -> bool:
        if name in self._described:
            return meant in self._values and meant not in self._described
        return meant in self._described
