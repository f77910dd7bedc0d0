"""Records of what RDF loses of a document: its text, and the spelling and place of each statement.

A record is JSON, compressed, as one literal beside the statements. It never says what is true of a
model: statements that the graph no longer has do not count, and others count without a place.
"""

from __future__ import annotations

import json
import zlib
from base64 import b64decode, b64encode
from binascii import Error as NoBase64
from collections.abc import Iterable, Sequence
from typing import Any, TypeAlias

from kinlint.document import Document, NodeSpans, SourceMap
from kinlint.endpoint.storable import key
from kinlint.errors import SourceError
from kinlint.formats.records import BY_NAME
from kinlint.light_dataclasses import asdict, dataclass, replace
from kinlint.terms import Term, Triple
from kinlint.text import Pairing, SourceText, Span

Json: TypeAlias = Any
MOST_BYTES = 256 * 2**20
"""Size of the largest record; a stored one that would unpack to more is no record."""


@dataclass(frozen=True)
class StoredDocument:
    """A document as it was loaded into a store."""

    document: Document
    """The document."""
    apart: frozenset[Triple] = frozenset()
    """Statements that no store accepts, such as those with an IRI that is none."""
    looked_up: Sequence[Triple] = ()
    """Statements about the files that it names, as they were where it was loaded."""

    def holding(self, found: Iterable[Triple]) -> StoredDocument:
        """Return the document with the statements *found* in its graph.

        Those that it was loaded with are spelled and ordered as they were.
        """
        there = {key(each): each for each in found}
        keys = [(each, key(each)) for each in self.document.statements]
        kept = [each for each, its in keys if each in self.apart or its in there]
        known = {its for _, its in keys}
        more = sorted(each for its, each in there.items() if its not in known)
        if not more and len(kept) == len(keys):
            return self
        return replace(self, document=replace(self.document, statements=(*kept, *more)))


def written(stored: StoredDocument) -> str:
    """Return the record of *stored*, in the letters of Base64."""
    document = stored.document
    pieces = document.pieces or ((0, document.source),)
    spans = document.map.triples
    told = {
        "texts": [_text(source) for _, source in pieces],
        "pieces": [start for start, _ in pieces] if document.pieces else [],
        "graph": document.graph,
        "format": document.format.name,
        "prefixes": dict(document.prefixes),
        "statements": [[*each, *(spans.get(each) or ())] for each in document.statements],
        "nodes": [
            [node, *whole, *(own or ())] for node, (whole, own) in document.map.nodes.items()
        ],
        "apart": sorted(stored.apart),
        "looked_up": list(stored.looked_up),
    }
    packed = zlib.compress(json.dumps(told, separators=(",", ":")).encode(), 6)
    return b64encode(packed).decode()


def read(name: str, record: str) -> StoredDocument:
    """Return what `written` made a record of. Raises `SourceError` for anything else."""
    try:
        unpacking = zlib.decompressobj()
        packed = b64decode(record, validate=True)
        told = json.loads(unpacking.decompress(packed, MOST_BYTES))
        texts = [_source(each) for each in told["texts"]]
        document = Document(
            source=texts[0],
            graph=told["graph"],
            statements=[(s, p, o) for s, p, o, *_ in told["statements"]],
            map=SourceMap(_spans(told["statements"]), _nodes(told["nodes"])),
            prefixes=told["prefixes"],
            format=BY_NAME[told["format"]],
            pieces=tuple(zip(told["pieces"], texts, strict=bool(told["pieces"]))),
        )
        apart = frozenset((s, p, o) for s, p, o in told["apart"])
        looked_up = [(s, p, o) for s, p, o in told["looked_up"]]
    except (NoBase64, zlib.error, ValueError, KeyError, TypeError, IndexError) as error:
        cause = f"no record of kinlint: {type(error).__name__}; load it again"
        raise SourceError(name, cause) from None
    return StoredDocument(document, apart, looked_up)


def _spans(statements: Sequence[Json]) -> dict[Triple, Span]:
    return {(s, p, o): Span(*span) for s, p, o, *span in statements if span}


def _nodes(nodes: Sequence[Json]) -> dict[Term, NodeSpans]:
    return {
        node: NodeSpans(Span(*spans[:2]), Span(*spans[2:]) if spans[2:] else None)
        for node, *spans in nodes
    }


def _text(source: SourceText) -> Json:
    return {
        "name": source.name,
        "text": source.text,
        "bom": source.bom,
        "misread": [[*span, what] for span, what in source.misread],
        "companion": source.companion,
        "named": source.named,
        "pairing": None if source.pairing is None else asdict(source.pairing),
        "format": source.format and source.format.name,
    }


def _source(told: Json) -> SourceText:
    pairing = told["pairing"]
    if pairing is not None:
        pairing = {
            n: tuple(each) if isinstance(each, list) else each for n, each in pairing.items()
        }
        pairing = Pairing(**pairing)
    return SourceText(
        name=told["name"],
        text=told["text"],
        bom=told["bom"],
        misread=tuple((Span(start, end), what) for start, end, what in told["misread"]),
        companion=told["companion"],
        named=told["named"],
        pairing=pairing,
        format=None if told["format"] is None else BY_NAME[told["format"]],
    )
