"""Edits JSON-LD in tests, and holds what the edited text says to what it should say."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import Any

from pyld import jsonld

from kinlint.document import Document
from kinlint.edits import Delta, Edit, applied
from kinlint.formats.jsonld.editing.editor import Editor
from kinlint.formats.jsonld.reader import read
from kinlint.formats.options import ReadOptions
from kinlint.terms import Triple
from kinlint.text import SourceText
from kinlint.vocabulary import SRC

OPTIONS = ReadOptions()
NAME = "arm.jsonld"


def document(content: Any) -> Document:
    text = content if isinstance(content, str) else json.dumps(content, indent=2)
    return read(SourceText(NAME, text), OPTIONS)


def domain(read_document: Document) -> list[Triple]:
    """The triples that the author wrote."""
    return [t for t in read_document.statements if not any(SRC in term for term in t[1:])]


def canonical(triples: Iterable[Triple]) -> str:
    """Triples without regard to the names of blank nodes and the spelling of doubles."""
    nquads = "".join(f"{' '.join(triple)} .\n" for triple in triples)
    nquads = re.sub(r'"([^"\\]*)"(?=\^\^<[^>]*#double>)', _valued, nquads)
    form = "application/n-quads"
    options = {"algorithm": "URDNA2015", "inputFormat": form, "format": form}
    return str(jsonld.normalize(nquads, options))


def _valued(match: re.Match[str]) -> str:
    try:
        return f'"{float(match[1]) + 0.0!r}"'
    except ValueError:
        return match[0]


def changed(before: Sequence[Triple], delta: Delta) -> list[Triple]:
    """What *before* is after *delta*."""
    gone = set(delta.removed)
    return [*dict.fromkeys([*(t for t in before if t not in gone), *delta.added])]


def edited(before: Document, delta: Delta, editor: Editor | None = None) -> str:
    """The text after *delta*, which says exactly what it should say."""
    edits = (editor or Editor(before, OPTIONS)).edits(delta)
    check_edits(before.source.text, edits)
    text = applied(before.source.text, edits)
    after = document(text)
    assert canonical(domain(after)) == canonical(changed(domain(before), delta)), text
    return text


def check_edits(text: str, edits: Sequence[Edit]) -> None:
    """Edits ascend and are apart, and each changes something."""
    for edit in edits:
        assert 0 <= edit.span.start <= edit.span.end <= len(text)
        assert text[edit.span.start : edit.span.end] != edit.text
    for one, other in pairwise(edits):
        assert one.span.end < other.span.start, edits
