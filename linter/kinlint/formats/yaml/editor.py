"""Writes changed names and numbers into YAML."""

from __future__ import annotations

import json
import re
from collections.abc import Sequence

from kinlint.document import Document
from kinlint.edits import Delta, Edit, NotExpressible
from kinlint.formats.options import ReadOptions
from kinlint.terms import NUMERIC, Term, is_literal, literal_datatype, literal_value
from kinlint.text import Span

PLAIN = re.compile(r"(?!(?i:y|yes|n|no|true|false|on|off|null)\Z)[A-Za-z_][\w./-]*\Z", re.ASCII)
"""A name that needs no quotes, by YAML 1.1."""


class Editor:
    """Writes changes of *document* into its text: other values of what is there."""

    def __init__(self, document: Document, _options: ReadOptions) -> None:
        self._document = document

    def edits(self, delta: Delta) -> Sequence[Edit]:
        """Return the edits of *delta*.

        Raises NotExpressible unless it only replaces values.
        """
        new = {triple[:2]: triple[2] for triple in delta.added}
        if len(new) != len(delta.added) or {each[:2] for each in delta.removed} != new.keys():
            raise NotExpressible("only values can be changed in YAML")
        found = {}
        for triple in delta.removed:
            span = self._document.map.triples.get(triple)
            if span is None or not is_literal(triple[2]):
                raise NotExpressible("only values can be changed in YAML")
            found[span] = Edit(span, self._written(span, new[triple[:2]]))
        return [found[span] for span in sorted(found)]

    def _written(self, span: Span, value: Term) -> str:
        """Return *value* as it stands at *span*, between quotes or not."""
        text, written = self._document.source.text, literal_value(value)
        if literal_datatype(value) in NUMERIC:
            return f"{float(written):.15g}"
        before, behind = text[max(span.start - 1, 0) : span.start], text[span.end : span.end + 1]
        if before in "\"'" and before == behind:
            return json.dumps(written)[1:-1] if before == '"' else written.replace("'", "''")
        return written if PLAIN.match(written) else json.dumps(written)
