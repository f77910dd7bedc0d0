"""Writes changed values into text layers."""

from __future__ import annotations

from collections.abc import Sequence

from kinlint.document import Document
from kinlint.edits import Delta, Edit, NotExpressible
from kinlint.formats.options import ReadOptions
from kinlint.terms import NUMERIC, Term, is_literal, literal_datatype, literal_value

ONLY = "only values can be changed in USD"


class Editor:
    """Writes changes of *document* into its text: other values of what is there."""

    def __init__(self, document: Document, _options: ReadOptions) -> None:
        self._document = document

    def edits(self, delta: Delta) -> Sequence[Edit]:
        """Return the edits of *delta*.

        Raises NotExpressible unless it only replaces values of the layer itself.
        """
        new = {triple[:2]: triple[2] for triple in delta.added}
        if len(new) != len(delta.added) or {each[:2] for each in delta.removed} != new.keys():
            raise NotExpressible(ONLY)
        found = {}
        for triple in delta.removed:
            span = self._document.map.triples.get(triple)
            if span is None or not is_literal(triple[2]):
                raise NotExpressible(ONLY)
            if self._document.location(span).source is not self._document.source:
                raise NotExpressible("it is written in another layer")
            found[span] = Edit(span, _written(new[triple[:2]]))
        return [found[span] for span in sorted(found)]


def _written(value: Term) -> str:
    """Return *value* as it is written; of strings, what stands between the quotes."""
    written = literal_value(value)
    if literal_datatype(value) in NUMERIC:
        return f"{float(written):.9g}" if "." in written or "e" in written.lower() else written
    if any(each in written for each in "\"'\\\n@"):
        raise NotExpressible("the text has characters that would have to be escaped")
    return written
