"""Reads JSON-LD in tests, and tells whether places are right."""

from __future__ import annotations

import json
from typing import Any

from kinlint.document import Document
from kinlint.formats.jsonld.reader import read
from kinlint.formats.options import ReadOptions
from kinlint.terms import (
    RDF,
    Term,
    Triple,
    iri_value,
    is_blank,
    is_iri,
    literal_datatype,
    literal_value,
)
from kinlint.text import SourceText, Span
from kinlint.vocabulary import SRC

NIL = f"<{RDF}nil>"


def document(content: Any, name: str = "arm.jsonld", **options: Any) -> Document:
    """*content* read as JSON-LD; what is no text is written as JSON first."""
    text = content if isinstance(content, str) else json.dumps(content, indent=2)
    return read(SourceText(name, text), ReadOptions(**options))


def domain(read: Document) -> list[Triple]:
    """The triples that the author wrote."""
    return [triple for triple in read.statements if not _of_source_layer(triple)]


def _of_source_layer(triple: Triple) -> bool:
    return any(SRC in term for term in triple[1:])


def losses(read: Document, kind: str | None = None) -> list[tuple[str, str]]:
    """Kind and text of each loss, in the order of the text."""
    kinds = {
        subject: value.removeprefix(f"<{SRC}").removesuffix(">")
        for subject, _, value in read.statements
        if value.startswith(f"<{SRC}") and is_blank(subject)
    }
    found = [(read.map.nodes[node].whole, name) for node, name in kinds.items()]
    return [
        (name, read.source[span])
        for span, name in sorted(found)
        if name not in ("ContextUse", "TermDefinition", "ClearedKey") and kind in (None, name)
    ]


def details(read: Document, text: str) -> dict[str, list[str]]:
    """What is said about the loss at *text*: plain strings and IRIs, by name."""
    found: dict[str, list[str]] = {}
    for subject, prop, value in read.statements:
        if not is_blank(subject) or not prop.startswith(f"<{SRC}"):
            continue
        if read.source[read.map.nodes[subject].whole] == text:
            plain = iri_value(value) if is_iri(value) else value
            name = iri_value(prop).removeprefix(SRC)
            found.setdefault(name, []).append(
                literal_value(value) if value.startswith('"') else plain
            )
    return found


def says(source: SourceText, span: Span, term: Term) -> bool:
    """Whether the token at *span* is a way to write *term*."""
    token = json.loads(source[span])
    if is_blank(term) or term == NIL:
        return isinstance(token, (dict, list)) or (isinstance(token, str) and token[:2] == "_:")
    if is_iri(term):
        local = token.partition(":")[2] or token
        return iri_value(term).endswith(local)
    if isinstance(token, bool):
        return literal_value(term) == ("true" if token else "false")
    if isinstance(token, (int, float)):
        return float(literal_value(term)) == token
    if literal_datatype(term) == f"{RDF}JSON":
        return bool(json.loads(literal_value(term)) == token)
    return literal_value(term) == token
