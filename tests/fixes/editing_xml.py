"""Changes of documents in XML, as tests write them."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from kinlint.document import Document
from kinlint.edits import Delta, Edit, applied
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.formats.xml.editing import element_tree
from kinlint.formats.xml.editing.editor import Editor
from kinlint.terms import XSD, Term, iri, iri_value, literal
from kinlint.text import SourceText
from kinlint.vocabulary import ATTRIBUTE, EXTENSION, SDF, SRC, SRDF, URDF

Triples = list[tuple[Any, ...]]
"""Triples for short: of `#/link/a`, `at:xyz-1`, `_:new`, numbers, literals, other text."""

SPACES = {
    "at": ATTRIBUTE, "src": SRC, "urdf": URDF, "srdf": SRDF, "sdf": SDF, "ext": EXTENSION,
}  # fmt: skip


def term(document: Document, written: Any) -> Term:
    """What is *written* for short; nothing is the document."""
    if isinstance(written, float):
        return literal(f"{written:E}".replace("E+", "E"), f"{XSD}double")
    text = str(written)
    if not text:
        return document.graph
    if text.startswith(('"', "_:")):
        return text
    if text.startswith("#"):
        return iri(iri_value(document.graph) + text)
    prefix, colon, name = text.partition(":")
    if colon and prefix in SPACES:
        return iri(SPACES[prefix] + name)
    return literal(text)


def delta(document: Document, removed: Triples, added: Triples) -> Delta:
    """The change of *document* that is written for short; of what goes the value may be missing."""

    def found(subject: str, predicate: str, *value: Any) -> list[tuple[Term, Term, Term]]:
        s, p = term(document, subject), term(document, predicate)
        return [
            each
            for each in document.statements
            if each[:2] == (s, p) and (not value or each[2] == term(document, value[0]))
        ]

    gone = [triple for each in removed for triple in found(*each)]
    assert len(gone) >= len(removed), "what goes is not there"
    come = [tuple(term(document, part) for part in each) for each in added]
    return Delta(tuple(gone), tuple(come))  # type: ignore[arg-type]


def edited(document: Document, change: Delta) -> dict[str, SourceText]:
    """The texts of *document* that *change* changes, by their names."""
    return written(document, Editor(document, ReadOptions()).edits(change))


def written(document: Document, edits: Iterable[Edit]) -> dict[str, SourceText]:
    """The texts of *document* that *edits* change, by their names."""
    found: dict[str, tuple[SourceText, list[Edit]]] = {}
    for edit in edits:
        place = document.location(edit.span)
        found.setdefault(place.source.name, (place.source, []))[1].append(
            Edit(place.span, edit.text)
        )
    return {
        name: replace(source, text=applied(source.text, own))
        for name, (source, own) in found.items()
    }


def change(text: str, removed: Triples, added: Triples, name: str = "arm.urdf") -> str:
    """*text* after a change, which reading it again has shown to be made."""
    options = ReadOptions()
    source = SourceText(name, text)
    document = read(source, options)
    wanted = delta(document, removed, added)
    texts = edited(document, wanted)
    assert list(texts) == [name]
    after = read(texts[name], options)
    assert element_tree.tree(after) == element_tree.changed(document, wanted)
    return texts[name].text
