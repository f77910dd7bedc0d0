"""Hunks of a diff, computed from text edits alone."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.edits import Edit, applied
from kinlint.finding import Fix
from kinlint.light_dataclasses import dataclass
from kinlint.reporters.excerpt import bounds
from kinlint.text import SourceText, Span

NEAR = 1_000
"""Number of characters of a line kept before and after its change."""


@dataclass(frozen=True, slots=True)
class Hunk:
    """Lines that give way to others, without what both begin or end with.

    Lines count from one and come without their ends. Of a long line only what is near the edits is
    there, more than fits a terminal.
    """

    old: int
    """Number of the first line removed."""
    removed: tuple[str, ...]
    """The lines removed."""
    new: int
    """Number of the first line added."""
    added: tuple[str, ...]
    """The lines added."""


def edits_by_source(fix: Fix) -> Iterator[tuple[SourceText, list[Edit]]]:
    """The texts that *fix* changes, each with its edits in order."""
    for source in fix.sources:
        own = (one for one in fix.edits if one.location.source is source)
        yield source, sorted(Edit(one.location.span, one.text) for one in own)


def hunks(source: SourceText, edits: Sequence[Edit]) -> Iterator[Hunk]:
    """Yield the hunks of *edits*, which are in order.

    Edits of the same line, or of lines next to each other, share a hunk.
    """
    shift = 0
    for first, last, own in _groups(source, edits):
        start = max(source.line_starts[first - 1], own[0].span.start - NEAR)
        end = max(own[-1].span.end, min(bounds(source, last)[1], own[-1].span.end + NEAR))
        moved = (Edit(Span(span.start - start, span.end - start), new) for span, new in own)
        after = applied(source.text[start:end], moved)
        old, new = lines(source.text[start:end]), lines(after)
        same = common(old, new)
        rest = common(old[same:][::-1], new[same:][::-1])
        yield Hunk(
            first + same,
            tuple(old[same : len(old) - rest]),
            first + same + shift,
            tuple(new[same : len(new) - rest]),
        )
        shift += len(new) - len(old)


def lines(text: str) -> list[str]:
    """The lines of *text* without their ends, which are LF, CRLF or CR; at least one."""
    return text.replace("\r\n", "\n").replace("\r", "\n").split("\n")


def _groups(source: SourceText, edits: Sequence[Edit]) -> Iterator[tuple[int, int, list[Edit]]]:
    """The first and last line of edits that belong together, and these."""
    group: list[Edit] = []
    first = last = 0
    for edit in edits:
        begin, end = (source.position(offset).line for offset in edit.span)
        if group and begin > last + 1:
            yield first, last, group
            group = []
        first, last = (first if group else begin), end
        group.append(edit)
    if group:
        yield first, last, group


def common(one: Sequence[str], other: Sequence[str]) -> int:
    """Return the length of the common prefix of two sequences."""
    count = 0
    for a, b in zip(one, other, strict=False):
        if a != b:
            break
        count += 1
    return count
