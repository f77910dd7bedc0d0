"""Parts of a file that could not be read, from what its document states about them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from kinlint.document import Document
from kinlint.errors import SourceError
from kinlint.formats.source_layer import src
from kinlint.terms import RDF_TYPE, Term, literal_value
from kinlint.text import Location, Span

UNREAD, OFFSET, MALFORMED = src("unread"), src("offset"), src("MalformedValue")
REASON, WRITTEN, TAG, ATTRIBUTE = (src(x) for x in ("reason", "written", "tag", "attribute"))


class MalformedValue(NamedTuple):
    """Value that is written in another way than its element or attribute demands."""

    name: str
    """The element, with the attribute if it is that of one: `<limit upper>`."""
    text: str
    """The value in quotes, and what is wrong with it."""
    place: Location
    """Place where it is written."""


def refuse_unread(documents: Iterable[Document]) -> None:
    """Raise `SourceError` for the first of *documents* whose text cannot be parsed."""
    for document in documents:
        for node, _, _ in document.saying(UNREAD):
            start = _place(document, node).start
            name, cause = document.source.name, _said(document, node)[REASON]
            raise SourceError(name, cause, start.line, start.column)


def malformed_values(document: Document) -> Iterator[MalformedValue]:
    """Yield the values of *document* that could not be read, in the order of the text."""
    for node, _, kind in document.saying(RDF_TYPE):
        if kind == MALFORMED:
            said = _said(document, node)
            name = " ".join(said[each] for each in (TAG, ATTRIBUTE) if each in said)
            text = f"'{said.get(WRITTEN, '')}'"
            if REASON in said:
                text += f", {said[REASON]}"
            yield MalformedValue(f"<{name}>", text, _place(document, node))


def _said(document: Document, node: Term) -> dict[Term, str]:
    """Return the values of the literal properties of *node*."""
    properties = (REASON, WRITTEN, TAG, ATTRIBUTE)
    return {p: literal_value(o) for s, p, o in document.saying(*properties) if s == node}


def _place(document: Document, node: Term) -> Location:
    offset = next(int(literal_value(o)) for s, _, o in document.saying(OFFSET) if s == node)
    return document.location(Span(offset, offset))
