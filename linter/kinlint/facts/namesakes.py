"""Names in namespaces in which no file describes anything, and what others describe by them."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Iterator

from kinlint.facts.fact_statements import fact
from kinlint.facts.identifier_slips import names_by_iri
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.suggestion import LOOKED_UP
from kinlint.terms import Term, Triple, iri, iri_value, is_iri

ENDS = "#/:"
"""The characters of which a namespace ends in one."""
SCHEME = re.compile(r"^https?://")
"""The parts of a namespace that may differ between two spellings of it."""


def namesakes(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield names of namespaces in which nothing is described, with those of others that are.

    Where two namespaces have only one name in common, they have to be spelt alike; a name that a
    hundred namespaces have in common says nothing.
    """
    own = scan.own_namespaces()
    described: dict[str, list[str]] = defaultdict(list)
    for node in sorted(scan.described_nodes()):
        space, name = _split(node)
        if name and space in own:
            described[name].append(space)
    told: set[Triple] = set()
    for document in scan.documents:
        if not names_by_iri(document.format):
            continue
        foreign = {
            parts: value
            for _, _, value in document.statements
            if is_iri(value) and (parts := _split(value))[0] not in own and parts[1] in described
        }
        shared = Counter(
            (space, known)
            for space, name in foreign
            if len(described[name]) <= LOOKED_UP
            for known in described[name]
        )
        for (space, name), value in foreign.items():
            for known in described[name]:
                if shared[space, known] > 1 or (
                    shared[space, known] and _stem(space) == _stem(known)
                ):
                    told.add((value, fact("namesake"), iri(known + name)))
    yield from sorted(told)


def _split(node: Term) -> tuple[str, str]:
    """Return the namespace and the name of an IRI, or no name."""
    text = iri_value(node) if is_iri(node) else ""
    end = max(text.rfind(each) for each in ENDS) + 1
    return text[:end], text[end:]


def _stem(space: str) -> str:
    return SCHEME.sub("", space).rstrip(ENDS).lower()
