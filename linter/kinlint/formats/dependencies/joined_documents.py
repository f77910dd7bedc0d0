"""Joins the document of an SRDF to that of the URDF by which it is judged."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from kinlint.addresses import root_of
from kinlint.document import Document
from kinlint.formats.dependencies.companions import paired_among
from kinlint.formats.dependencies.robot_descriptions import may_be_srdf
from kinlint.formats.source_layer import src
from kinlint.formats.srdf.format import SRDF
from kinlint.formats.xml.references import names_in, resolve_references
from kinlint.formats.xml.schema import schema
from kinlint.formats.yaml.format import YAML
from kinlint.light_dataclasses import replace
from kinlint.terms import RDF_TYPE, Triple, iri, literal, literal_value
from kinlint.text import Pairing
from kinlint.vocabulary import SRC

JOINED_TO = iri(f"{SRC}joinedTo")
LOSSES = frozenset(
    iri(f"{SRC}{name}")
    for name in (
        *("Unexpanded", "ExpansionFailure"),
        *("MissingPart", "UnknownArgument", "UnknownVariable"),
    )
)
"""Types of statements which imply that the robot may have parts that were not read."""
UNREAD = frozenset({iri(f"{SRC}unread")})


def join_companions(
    documents: Sequence[Document], configured: Callable[[str], str | None] = lambda _: None
) -> list[Document]:
    """Return *documents*, in which each SRDF says which URDF it is about.

    Where that is not known from its text, it is one of those of *documents*. Documents with unread
    parts stay alone: what is missing there may be in the unread part.
    """
    texts = [document.source for document in documents]
    if any(document.format == YAML for document in documents):
        documents = _configured(documents)
    if not any(map(may_be_srdf, texts)):
        return list(documents)
    pairings = paired_among(texts, configured)
    asked = {*pairings, *(each.partner for each in pairings.values())}
    whole = {
        each.source.name: each
        for each in documents
        if each.source.name in asked and _is_whole(each)
    }
    return [
        _joined(each, whole[pairing.partner], pairing)
        if each.source.name in whole
        and (pairing := pairings.get(each.source.name)) is not None
        and pairing.partner in whole
        else each
        for each in documents
    ]


def _configured(documents: Sequence[Document]) -> Sequence[Document]:
    """Return *documents*, in which YAML files are joined to their robots."""
    from kinlint.formats.dependencies.joined_configurations import join_configurations  # noqa: PLC0415  few runs have any

    whole = {each.source.name for each in documents if _is_whole(each)}
    return join_configurations(documents, whole)


def _is_whole(document: Document) -> bool:
    return not any(
        predicate in UNREAD or (predicate == RDF_TYPE and value in LOSSES)
        for _, predicate, value in document.statements
    )


def _joined(srdf: Document, urdf: Document, pairing: Pairing) -> Document:
    """Return *srdf* with the root of *urdf* that it is joined to, and what it refers to there.

    If that *pairing* is not certain, only with the names that no robot has.
    """
    root, joined = root_of(srdf.graph), root_of(urdf.graph)
    resolved = resolve_references(
        names_in(srdf), schema(SRDF.name), srdf.map.nodes, (joined, urdf.map.nodes)
    )
    found = dict(_known(resolved, pairing))
    if pairing.certain:
        leading = [(root, JOINED_TO, joined), *found]
    else:
        missing = {source for triple, source in found.items() if triple[1] == src("dangling")}
        leading = [triple for triple, source in found.items() if source in missing]
        names = dict.fromkeys((pairing.partner, *pairing.others))
        leading += [(root, src("namesake"), literal(name)) for name in names]
    return replace(srdf, statements=(*srdf.statements, *dict.fromkeys(leading)))


def _known(
    resolved: Iterator[tuple[Triple, Triple]], pairing: Pairing
) -> Iterator[tuple[Triple, Triple]]:
    """Yield of the *resolved* names those that no other robot has."""
    elsewhere = frozenset(pairing.elsewhere)
    yield from (each for each in resolved if literal_value(each[1][2]) not in elsewhere)
