"""Names that files refer to and none of them describes, by namespace."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping
from typing import NamedTuple

from kinlint.facts.fact_statements import MEMBER, fact, fact_node, integer
from kinlint.facts.identifier_slips import ROLES, names_by_iri, only_near, split
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.formats.source_layer import src
from kinlint.suggestion import LOOKED_UP
from kinlint.terms import Term, Triple, iri, is_iri, literal
from kinlint.vocabulary import KINLINT, METAMODELS, QUDT, RDFS, SRC

ELSEWHERE = re.compile(
    r"<https?://(www\.w3\.org/(ns/(shacl|dcat)|2002/07/owl|2000/01/rdf-schema)"
    r"|xmlns\.com/|purl\.org/|schema\.org/)"
)
"""Properties whose values are described by other means than models."""
FILE = re.compile(r"\.\w+>$")
"""The end of the name of a file, which is described by being there."""
LAST = re.compile(r"[^#/:]+[#/:]$")
"""The last part of a namespace."""
METAMODEL = f"<{METAMODELS}", f"<{KINLINT}"
PUBLISHED = METAMODELS, QUDT, "http://qudt.org/vocab/"
"""Namespaces whose names are terms."""


class Mention(NamedTuple):
    """The first statement of a file that refers to a name."""

    subject: Term
    """The node that refers to it."""
    predicate: Term
    """The property by which it does."""


def undescribed_names(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield for each namespace with undescribed names a node about them.

    It has the names as members, their number and that of the described ones, and the first with the
    node and the property that refer to it; of a namespace that is not a file's own, one of a file
    that differs from it in the last part. Of a namespace in which no file describes anything it
    has what metamodels ask for. Names that resemble described ones are slips of the pen and not
    among them.
    """
    nodes = scan.described_nodes()
    found = _mentions(scan, nodes)
    if not found:
        return
    described: dict[str, list[str]] = {}
    for space, name in map(split, sorted(filter(is_iri, nodes))):
        described.setdefault(space, []).append(name)
    own = scan.own_namespaces()
    beside: dict[str, list[str]] = {}
    for each in sorted(own):
        beside.setdefault(_above(each), []).append(each)
    for number, (space, names) in enumerate(found.items(), 1):
        known = described.get(space, ())
        slips = {name for name in list(names)[:LOOKED_UP] if only_near(split(name)[1], known)}
        left = [name for name in names if name not in slips]
        if left:
            subject, predicate = names[left[0]]
            node = fact_node("undescribed", number)
            yield node, fact("undescribed-in"), literal(space)
            yield node, fact("size"), integer(len(left))
            yield node, fact("described"), integer(len(known))
            yield node, fact("first"), left[0]
            yield node, fact("subject"), subject
            yield node, fact("property"), predicate
            yield from ((node, MEMBER, name) for name in left)
            if space not in own:
                neighbours = beside.get(_above(space), ())[:1]
                yield from ((node, fact("beside"), literal(each)) for each in neighbours)


def _mentions(
    scan: PredicateIndex, described: Collection[Term]
) -> Mapping[str, Mapping[Term, Mention]]:
    """Return the first mention of each name that is not *described*, by namespace."""
    named = scan.table(src("name"))
    terms = scan.table(iri(f"{RDFS}isDefinedBy"))
    graphs = {name for _, names in named.items() for name in names}
    own = scan.own_namespaces()
    found: dict[str, dict[Term, Mention]] = {}
    for document in scan.documents:
        if not names_by_iri(document.format):
            continue
        for subject, predicate, value in document.statements:
            if not is_iri(value) or any(value in each for each in (described, graphs, terms)):
                continue
            if predicate in ROLES or FILE.search(value) or _is_apart(predicate):
                continue
            space = split(value)[0]
            if space.startswith(PUBLISHED) or not (space in own or predicate.startswith(METAMODEL)):
                continue
            names = found.setdefault(space, {})
            names.setdefault(value, Mention(subject, predicate))
    return found


def _above(space: str) -> str:
    """Return the namespace *space* without its last part."""
    return LAST.sub("", space)


def _is_apart(predicate: Term) -> bool:
    return predicate.startswith(f"<{SRC}") or ELSEWHERE.match(predicate) is not None
