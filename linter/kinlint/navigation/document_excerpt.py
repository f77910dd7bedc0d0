"""Excerpts: all that a document states, or what an element of a large JSON-LD file states."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from collections.abc import Set as AbstractSet
from functools import cached_property
from typing import Any

from kinlint.document import Document, NodeSpans
from kinlint.errors import SourceError
from kinlint.formats.json_text.json_parser import parse
from kinlint.navigation.statement_index import StatementIndex
from kinlint.terms import Term, Triple
from kinlint.text import Span


class Excerpt:
    """*nodes* and *triples* of *document* with their places, in a JSON text that *read* returns.

    *losses* are the nodes that stand for what the text does beyond stating something. *names* are
    the places of the names of nodes that are described elsewhere, too.
    """

    def __init__(  # noqa: PLR0913, PLR0917
        self,
        document: Document,
        nodes: Mapping[Term, NodeSpans],
        triples: Mapping[Triple, Span],
        losses: AbstractSet[Term],
        read: Callable[[], Any],
        names: Mapping[Span, Term] | None = None,
    ) -> None:
        self.document, self.nodes, self.triples, self.losses = document, nodes, triples, losses
        self.names: Mapping[Span, Term] = names or {}
        self._read = read

    @cached_property
    def value(self) -> Any:
        """The JSON value; None if the text is no JSON."""
        try:
            return self._read()
        except SourceError:
            return None


def whole(document: Document) -> Excerpt:
    """Return all of *document*."""
    losses, places = StatementIndex(document).losses, document.map
    read = lambda: parse(document.source).value  # noqa: E731
    return Excerpt(document, places.nodes, places.triples, losses, read)
