"""Folding ranges and selection ranges, which need no analysis."""

from __future__ import annotations

from collections.abc import Sequence

from lsprotocol import types

from kinlint.navigation.text_structure import parts, selections
from kinlint.server.app import KinlintServer
from kinlint.server.position_codec import PositionCodec
from kinlint.text import Span


def register(server: KinlintServer) -> None:
    """Have *server* tell what can be folded, and what is around a place."""

    @server.feature(types.TEXT_DOCUMENT_FOLDING_RANGE)
    def folding(params: types.FoldingRangeParams) -> Sequence[types.FoldingRange] | None:
        buffer = server.buffers.get(params.text_document.uri)
        if buffer is None:
            return None
        source = buffer.source
        found: dict[tuple[int, int], types.FoldingRange] = {}
        for part in parts(source):
            first, last = (source.position(each).line - 1 for each in part.span)
            if part.inner != part.span and not part.is_comment and last > first + 1:
                last -= 1
            if last > first:
                kind = types.FoldingRangeKind.Comment if part.is_comment else None
                found.setdefault((first, last), types.FoldingRange(first, last, kind=kind))
        return list(found.values())

    @server.feature(types.TEXT_DOCUMENT_SELECTION_RANGE)
    def selection(params: types.SelectionRangeParams) -> Sequence[types.SelectionRange] | None:
        buffer = server.buffers.get(params.text_document.uri)
        if buffer is None:
            return None
        codec = PositionCodec(buffer.source, server.encoding, marked=buffer.marked)
        return [
            _nested(codec, selections(buffer.source, codec.offset(each)))
            for each in params.positions
        ]


def _nested(codec: PositionCodec, spans: Sequence[Span]) -> types.SelectionRange:
    """Return *spans*, the innermost first, each with the next as its parent."""
    found = types.SelectionRange(codec.range(spans[-1] if spans else Span(0, 0)))
    for span in reversed(spans[:-1]):
        found = types.SelectionRange(codec.range(span), found)
    return found
