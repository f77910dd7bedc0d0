"""Lines of a source as markup, with what a finding speaks of marked in them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.finding import Finding
from kinlint.reporters.display_width import fold_lines
from kinlint.reporters.excerpt import CONTEXT_LINES, Cut, Mark, bounds, cut_line
from kinlint.reporters.picture.escape import element, text
from kinlint.reporters.terminal_style import Style
from kinlint.text import SourceText

NEAR = 5
"""A related place at most so many lines away is shown in the same excerpt."""
STYLE = Style(width=200)
MOST = 12
"""Number of related places above which they are folded and shown without their lines."""


def excerpts(finding: Finding) -> Iterator[str]:
    """The lines of *finding*, then those of the places that it speaks of and that lie elsewhere."""
    main = Mark(finding.location, "error", sign="^")
    near, far = [main], list[Mark]()
    for related in finding.related:
        mark = Mark(related.location, "place", related.message)
        here = mark.location.source.name == main.location.source.name
        (near if here and abs(mark.line - main.line) <= NEAR else far).append(mark)
    yield _block(near, finding, CONTEXT_LINES)
    same = [mark for mark in far if not mark.label]
    told = [mark for mark in far if mark.label]
    for mark in told[:MOST]:
        yield element("p", text(place(mark)), class_="place")
        yield _block([mark], finding, 0)
    if len(told) > MOST:
        yield f'<p class="place">and {len(told) - MOST:,} more places</p>'
    if same:
        yield _listed(same)


def _listed(marks: Sequence[Mark]) -> str:
    """The places of *marks* by file, folded if they are many."""
    files: dict[str, list[str]] = {}
    for mark in marks:
        line, column = mark.location.start
        files.setdefault(mark.location.source.name, []).append(f"{line}:{column}")
    rows = "".join(
        element("p", f"{text(name)}: {', '.join(places)}", class_="place")
        for name, places in files.items()
    )
    count = "1 other place" if len(marks) == 1 else f"{len(marks):,} other places"
    opening = " open" if len(marks) <= MOST else ""
    return f"<details{opening}><summary>The same at {count}</summary>{rows}</details>"


def place(mark: Mark) -> str:
    """File, line and column of *mark*."""
    start = mark.location.start
    return f"{mark.location.source.name}:{start.line}:{start.column}"


def _block(marks: Sequence[Mark], finding: Finding, context: int) -> str:
    source, main = marks[0].location.source, marks[0].line
    by_line: dict[int, list[Mark]] = {}
    for mark in marks:
        by_line.setdefault(mark.line, []).append(mark)
    before = range(max(1, main - context), main)
    wanted = sorted({*by_line, *before})
    rows: list[str] = []
    previous = 0
    for line in wanted:
        if previous and line > previous + 1:
            rows.append('<span class="gap">⋯</span>\n')
        previous = line
        rows.append(_line(source, line, by_line.get(line, ()), finding))
    return element("pre", "".join(rows), class_="excerpt", tabindex="0")


def _line(source: SourceText, number: int, marks: Sequence[Mark], finding: Finding) -> str:
    part = cut_line(source, number, marks[0].start if marks else bounds(source, number)[0], STYLE)
    content = "…" if part.before else ""
    at = part.start
    for mark in sorted(marks, key=lambda one: one.start):
        start, end = _within(mark, part, at)
        kind = finding.severity.label if mark.sign == "^" else "other"
        content += text(source.text[at:start])
        content += element("mark", text(source.text[start:end]) or " ", class_=kind)
        at = end
    content += text(source.text[at : part.end]) + ("…" if part.after else "")
    notes = "; ".join(fold_lines(mark.label) for mark in marks if mark.label)
    note = element("span", f"  {text(notes)}", class_="note") if notes else ""
    return f'<span class="no">{number:>4}</span> {content}{note}\n'


def _within(mark: Mark, part: Cut, least: int) -> tuple[int, int]:
    """Return the part of *mark* that is in *part* and not before *least*."""
    start = min(max(mark.location.span.start, least), part.end)
    return start, min(max(mark.location.span.end, start), part.end)
