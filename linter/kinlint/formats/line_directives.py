"""Comments to the end of a line that silence rules: `# kinlint: ignore[CODE, ...] reason`.

A comment on a line of its own is about what begins on the next line, one behind something about
what begins on its line, and all within. `file-ignore` is about the file.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Callable, Sequence

from kinlint.document import NodeSpans
from kinlint.formats.source_layer import SourceLayer
from kinlint.formats.xml.suppression_comments import state_directive
from kinlint.terms import Term
from kinlint.text import Span

DIRECTIVE = re.compile(
    r"(?m)(?:^|(?<=[ \t]))#[ \t]*kinlint:[ \t]*(file-)?ignore\b[ \t]*"
    r"(?:\[([^\]\r\n]*)\])?([^\r\n]*)"
)
_IDLE = re.compile(r"[ \t]*(?:#[^\r\n]*)?(?:\r\n?|\n)")
"""Line without content."""


def state_directives(
    text: str,
    entries: Sequence[tuple[int, int]],
    is_content: Callable[[int], bool],
    layer: SourceLayer,
) -> None:
    """Put what the comments of *text* silence into *layer*.

    *entries* are the places of what may be silenced, sorted; *is_content* tells whether an offset
    is inside of a value.
    """
    for match in DIRECTIVE.finditer(text):
        if not is_content(match.start()):
            extent = None if match[1] else _extent(text, match, entries)
            covered: Term | None = None
            if extent is not None:
                covered = layer.blanks.fresh()
                layer.nodes[covered] = NodeSpans(extent)
            state_directive(match, layer, covered)


def _extent(text: str, match: re.Match[str], entries: Sequence[tuple[int, int]]) -> Span | None:
    """Return the place of those of *entries* that begin on the line that *match* is about."""
    start = max(text.rfind("\n", 0, match.start()), text.rfind("\r", 0, match.start())) + 1
    if not text[start : match.start()].strip():
        while idle := _IDLE.match(text, start):
            start = idle.end()
    ends = [each for end in "\r\n" if (each := text.find(end, start)) >= 0]
    end = min(ends, default=len(text))
    here = entries[bisect_left(entries, (start, 0)) : bisect_left(entries, (end, 0))]
    return Span(here[0][0], max(end for _, end in here)) if here else None
