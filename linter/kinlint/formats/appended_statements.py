"""Writes statements at the end of a text in Turtle, N-Triples or N-Quads."""

from __future__ import annotations

import re

from kinlint.document import Document
from kinlint.edits import Delta, Edit, NotExpressible
from kinlint.terms import Term, iri_value, is_blank
from kinlint.text import Span
from kinlint.vocabulary import DOCUMENT_BASE, KL

LINE_END = re.compile(r"\r\n?|\n")


def append_statements(document: Document, change: Delta) -> Edit:
    """Return the edit that writes the statements of *change* at the end of *document*.

    Their blank nodes, `_:new` and a number, get labels that are unused there.

    Raises NotExpressible for a node that has no name in the text.
    """
    text = document.source.text
    subjects: dict[Term, list[str]] = {}
    prefix = next((name for name, known in document.prefixes.items() if known == KL), None)

    def word(term: Term) -> str:
        if term.startswith(f"<{KL}") and prefix is not None:
            return f"{prefix}:{term[len(KL) + 1 : -1]}"
        if term.startswith(f"<{DOCUMENT_BASE}"):
            return f"<{iri_value(term)[len(DOCUMENT_BASE) :]}>"
        return f"_:kinlint{_free(text)}x{term[5:]}" if term.startswith("_:new") else term

    for s, p, o in change.added:
        if is_blank(s) and not s.startswith("_:new"):
            raise NotExpressible("it is about a node without an IRI")
        subjects.setdefault(s, []).append(f"{word(s)} {word(p)} {word(o)} .")
    found = LINE_END.search(text)
    end = found[0] if found else "\n"
    lines = [line for each in subjects.values() for line in each]
    opening = end if text and text[-1] not in "\r\n" else ""
    return Edit(Span(len(text), len(text)), opening + "".join(f"{line}{end}" for line in lines))


def _free(text: str) -> int:
    """Return a number that no label of ours in *text* has."""
    taken = {int(number) for number in re.findall(r"_:kinlint(\d+)x", text)}
    return max(taken, default=0) + 1
