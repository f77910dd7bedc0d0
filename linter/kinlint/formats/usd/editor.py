"""Writes changes into text layers: other values, and schemas, attributes and metadata that come."""

from __future__ import annotations

from collections.abc import Sequence

from kinlint.document import Document
from kinlint.edits import Delta, Edit, NotExpressible
from kinlint.formats.options import ReadOptions
from kinlint.formats.usd.layer_additions import LayerAdditions
from kinlint.formats.usd.value_spelling import spelt
from kinlint.terms import Term, Triple, is_literal
from kinlint.text import Span

ONLY = "only values can be changed in USD, and schemas, attributes and metadata be added"


class Editor:
    """Writes changes of *document* into its text."""

    def __init__(self, document: Document, _options: ReadOptions) -> None:
        self._document = document

    def edits(self, delta: Delta) -> Sequence[Edit]:
        """Return the edits of *delta*.

        Raises NotExpressible unless it only replaces values of the layer itself, and adds to it.
        """
        gone = {each[:2] for each in delta.removed}
        new = {each[:2]: each[2] for each in delta.added if each[:2] in gone}
        if len(gone) < len(delta.removed) or gone != new.keys():
            raise NotExpressible(ONLY)
        found = dict(self._replaced(each, new[each[:2]]) for each in delta.removed)
        more = [each for each in delta.added if each[:2] not in gone]
        added = LayerAdditions(self._document).edits(more) if more else []
        return sorted([*found.values(), *added])

    def _replaced(self, triple: Triple, new: Term) -> tuple[Span, Edit]:
        span = self._document.map.triples.get(triple)
        if span is None or not is_literal(triple[2]):
            raise NotExpressible(ONLY)
        if self._document.location(span).source is not self._document.source:
            raise NotExpressible("it is written in another layer")
        return span, Edit(span, spelt(new))
