"""A fix under its finding: what it does, the lines it changes, and why it is not safe."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import zip_longest

from kinlint.finding import Finding, Fix
from kinlint.light_dataclasses import dataclass
from kinlint.reporters.display_width import fold_lines, printable
from kinlint.reporters.excerpt import bounds, line_text
from kinlint.reporters.hunk import Hunk, common, edits_by_source, hunks
from kinlint.reporters.summary import plural
from kinlint.reporters.terminal_style import Ink, Style
from kinlint.rule import Applicability
from kinlint.text import SourceText

FIXES_SHOWN = 3
LINES_SHOWN = 20
"""A fix that changes more lines of a file is shown in part."""
_KINDS = {Applicability.UNSAFE: "unsafe fix", Applicability.DISPLAY: "never made by --fix"}
_INKS: dict[str, Ink] = {"-": "removed", "+": "added"}


def last_line(finding: Finding) -> int:
    """The largest line number that the fixes of *finding* are shown with."""
    ends = [1]
    for fix in finding.fixes[:FIXES_SHOWN]:
        for source, edits in edits_by_source(fix):
            for hunk in hunks(source, edits):
                ends += (hunk.old + len(hunk.removed), hunk.new + len(hunk.added))
    return max(ends)


@dataclass(frozen=True, slots=True)
class FixPreview:
    """Writes fixes beneath excerpts whose line numbers take `gutter` columns."""

    style: Style
    """Colours."""
    gutter: int
    """Number of columns of line numbers."""

    def block(self, finding: Finding) -> Iterator[str]:
        """The lines that tell of the fixes of *finding*; nothing if there are none."""
        for fix in finding.fixes[:FIXES_SHOWN]:
            yield self._labelled("help", fix.title)
            for source, edits in edits_by_source(fix):
                if fix.sources[1:] or source.name != finding.location.source.name:
                    name = printable(source.name, unicode=self.style.unicode)
                    line = source.position(edits[0].span.start).line
                    yield f"{self._margin}{self.style.ink(':::', 'place')} {name}:{line}"
                yield from self._changes(source, list(hunks(source, edits)))
            yield from self._caution(fix)
        if (more := len(finding.fixes) - FIXES_SHOWN) > 0:
            yield self._labelled("help", plural(more, "more fix", "more fixes"))

    def _changes(self, source: SourceText, changes: Sequence[Hunk]) -> Iterator[str]:
        bar = self.style.ink(f"{self._margin} |", "place")
        dots = self.style.ink("...", "place")
        rows: list[str] = []
        for hunk in changes:
            rows += [dots] * bool(rows)
            rows += self._rows(source, hunk)
        yield bar
        yield from rows[:LINES_SHOWN]
        if len(rows) > LINES_SHOWN:
            yield f"{dots} {plural(len(rows) - LINES_SHOWN, 'more line')}"
        yield bar

    def _rows(self, source: SourceText, hunk: Hunk) -> Iterator[str]:
        """The lines of *hunk*; where they only come or only go, between their neighbours."""
        alone = not (hunk.removed and hunk.added)
        before, after = hunk.old - 1, hunk.old + len(hunk.removed)
        places = [common(*pair) for pair in zip_longest(hunk.removed, hunk.added, fillvalue="")]
        if alone and before >= 1:
            yield self._neighbour(hunk.new - 1, source, before)
        for first, sign, texts in ((hunk.old, "-", hunk.removed), (hunk.new, "+", hunk.added)):
            for number, (text, at) in enumerate(zip(texts, places, strict=False), first):
                yield self._row(number, sign, text, at)
        if alone and after <= len(source.line_starts) and len(set(bounds(source, after))) > 1:
            yield self._neighbour(hunk.new + len(hunk.added), source, after)

    def _row(self, number: int, sign: str, text: str, at: int) -> str:
        body = f"{sign} {line_text(SourceText('', text), 1, at, self.style)}".rstrip()
        lead = self.style.ink(f"{number:>{self.gutter}}", "place")
        return f"{lead} {self.style.ink(body, _INKS[sign])}"

    def _neighbour(self, number: int, source: SourceText, line: int) -> str:
        """Return *line* of *source*, numbered *number* as after the fix."""
        body = line_text(source, line, 0, self.style)
        return f"{self.style.ink(f'{number:>{self.gutter}} |', 'place')} {body}".rstrip()

    def _caution(self, fix: Fix) -> Iterator[str]:
        """Why it is not safe."""
        if kind := _KINDS.get(fix.applicability):
            yield self._labelled("note", f"{kind}: {fix.why}" if fix.why else kind)

    def _labelled(self, kind: str, text: str) -> str:
        return f"{self.style.ink(kind, 'note')}: {fold_lines(text, unicode=self.style.unicode)}"

    @property
    def _margin(self) -> str:
        return " " * self.gutter
