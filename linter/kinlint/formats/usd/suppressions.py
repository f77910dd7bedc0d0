"""Comments of text layers that silence rules: those of `kinlint.formats.line_directives`.

They are about prims, variants, properties, metadata and items of lists.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator

from kinlint.formats.line_directives import state_directives
from kinlint.formats.source_layer import SourceLayer
from kinlint.formats.usd.usda_syntax import Prim, Value
from kinlint.formats.xml.suppression_comments import MARK
from kinlint.text import Span


def state_suppressions(text: str, root: Prim, layer: SourceLayer) -> None:
    """Put what the comments of *text*, the layer *root*, silence into *layer*."""
    if MARK not in text:
        return
    strings = sorted(each.span for each in _values(root) if each.kind == "string")
    starts = [each.start for each in strings]

    def is_content(offset: int) -> bool:
        at = bisect_right(starts, offset) - 1
        return at >= 0 and offset < strings[at].end

    entries = sorted({(start, end) for start, end in _places(root)})
    state_directives(text, entries, is_content, layer)


def _prims(root: Prim) -> Iterator[Prim]:
    pending = [root]
    while pending:
        at = pending.pop()
        yield at
        pending += at.children
        pending += (each for given in at.variant_sets for each in given.variants)


def _places(root: Prim) -> Iterator[Span]:
    """Yield the places of all that may be silenced."""
    for prim in _prims(root):
        if prim is not root:
            yield prim.span
        yield from (each.span for each in prim.properties)
        for given in prim.metadata:
            yield Span(given.name_span.start, given.value.span.end)
            yield from (each.span for each in given.value.items)


def _values(root: Prim) -> Iterator[Value]:
    """Yield all values, those in others, too."""
    for prim in _prims(root):
        pending = [each.value for each in prim.metadata]
        for each in prim.properties:
            pending += [given.value for given in each.metadata]
            pending += [each.value] if each.value is not None else []
        while pending:
            value = pending.pop()
            yield value
            pending += value.items
            pending += (entry.value for entry in value.fields)
