"""Fixes as patches: what changes in each file, without the lines around it."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.finding import Finding, Fix
from kinlint.reporters.diff import NO_LINE_END
from kinlint.reporters.display_width import fold_lines, printable
from kinlint.reporters.hunk import Hunk, edits_by_source, hunks
from kinlint.reporters.picture.escape import element, text
from kinlint.rule import Applicability
from kinlint.text import SourceText

KINDS = {
    Applicability.SAFE: "safe fix",
    Applicability.UNSAFE: "unsafe fix",
    Applicability.DISPLAY: "never made by --fix",
}
COPY = '<button type="button" class="copy" hidden>Copy</button>'


def fixes(finding: Finding) -> Iterator[str]:
    """Yield the fixes of *finding* with their patches, which can be copied where they are exact."""
    for fix in finding.fixes:
        kind = element("span", KINDS[fix.applicability], class_="tag")
        why = element("p", text(fold_lines(fix.why)), class_="note") if fix.why else ""
        patch = element("pre", "".join(_lines(fix)), class_="diff", tabindex="0")
        button = COPY if _exact(fix) else ""
        yield f"<h4>{text(fold_lines(fix.title))} {kind}</h4>{why}"
        yield f'<div class="patch">{button}{patch}</div>'


def _lines(fix: Fix) -> Iterator[str]:
    for source, edits in edits_by_source(fix):
        name = text(source.name)
        yield f'<span class="head">--- {name}</span>\n<span class="head">+++ {name}</span>\n'
        for hunk in hunks(source, edits):
            old = _range(hunk.old, len(hunk.removed))
            new = _range(hunk.new, len(hunk.added))
            yield f'<span class="head">@@ -{old} +{new} @@</span>\n'
            end = f'<span class="head">{NO_LINE_END}</span>\n' if _last(source, hunk) else ""
            yield from (f"<del>-{_code(line)}</del>\n" for line in hunk.removed)
            yield end if hunk.removed else ""
            yield from (f"<ins>+{_code(line)}</ins>\n" for line in hunk.added)
            yield end if hunk.added else ""


def _range(first: int, count: int) -> str:
    """Lines as patches count them: nothing begins behind the line before it."""
    return f"{first - (count == 0)},{count}"


def _last(source: SourceText, hunk: Hunk) -> bool:
    """Tell whether *hunk* changes the last line of *source*, and no line end follows it."""
    return hunk.old + len(hunk.removed) > len(source.line_starts)


def _code(line: str) -> str:
    """Return *line* as markup, with its tabs."""
    return "\t".join(map(text, line.split("\t")))


def _exact(fix: Fix) -> bool:
    """Tell whether the patch equals the fix: no line is cut, ends in CR or has to be escaped."""
    for source, edits in edits_by_source(fix):
        if "\r" in source.text:
            return False
        for hunk in hunks(source, edits):
            lines = (*hunk.removed, *hunk.added)
            if any(printable(part) != part for line in lines for part in line.split("\t")):
                return False
            if any(source.line(hunk.old + at) != line for at, line in enumerate(hunk.removed)):
                return False
            if not hunk.removed and _last(source, hunk):
                return False
    return True
