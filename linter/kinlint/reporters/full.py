"""Findings for people: the message, the lines with marks, the reasons, where to read on."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.finding import Finding, Premise, Related
from kinlint.report import Report
from kinlint.reporters.display_width import fold_lines, printable
from kinlint.reporters.excerpt import CONTEXT_LINES, Mark, cut_line, excerpt_rows
from kinlint.reporters.fix_preview import FixPreview, last_line
from kinlint.reporters.fixability import sign
from kinlint.reporters.summary import errors, plural
from kinlint.reporters.terminal_style import INK_OF, Style
from kinlint.text import Location

NEAR_LINES = 5
"""A related place at most so many lines away is shown in the same excerpt."""
SAME_MESSAGES = 50
"""More findings than this with one message are shown once, with their places."""
PLACES_SHOWN = 10
PREMISES_SHOWN = 24


def render(report: Report, style: Style) -> Iterator[str]:
    """The pieces of the text: a block for each finding, then the files that cannot be read."""
    groups: dict[tuple[str, str, bool], list[Finding]] = {}
    for finding in report.findings:
        groups.setdefault(_sameness(finding), []).append(finding)
    for finding in report.findings:
        same = groups[_sameness(finding)]
        if len(same) <= SAME_MESSAGES:
            yield from _block(finding, (), style, report)
        elif same[0] is finding:
            others = [other.location for other in same[1:]]
            yield from _block(finding, others, style, report)
    yield from errors(report, style)


def _sameness(finding: Finding) -> tuple[str, str, bool]:
    return finding.rule.code, finding.message, finding.suppressed is None


def _block(
    finding: Finding, others: Sequence[Location], style: Style, report: Report
) -> Iterator[str]:
    near, far = _split(finding, style)
    if finding.rule.group_by:
        others = [*(mark.location for mark in far if not mark.label), *others]
        far = [mark for mark in far if mark.label]
    gutter = len(str(max(last_line(finding), *(mark.line for mark in (*near, *far)))))
    margin = " " * gutter
    bar = style.ink(f"{margin} |", "place")
    yield _headline(finding, style, unsafe=report.unsafe) + "\n"
    yield f"{margin}{style.ink('-->', 'place')} {_place(finding.location, style)}\n{bar}\n"
    for row in excerpt_rows(near, style, gutter, CONTEXT_LINES):
        yield f"{row}\n"
    yield f"{bar}\n"
    for mark in far:
        yield f"{margin}{style.ink(':::', 'place')} {_place(mark.location, style)}\n{bar}\n"
        for row in excerpt_rows((mark,), style, gutter):
            yield f"{row}\n"
        yield f"{bar}\n"
    lead = style.ink(f"{margin} =", "place")
    if finding.reason:
        yield f"{lead} because: {fold_lines(finding.reason, unicode=style.unicode)}\n"
    for line in _derivation(finding.because, style) if report.derived else ():
        yield f"{lead if line.startswith('derived') else margin + '  '} {line}\n"
    if others:
        yield f"{lead} {_elsewhere(finding.location.source.name, others, style)}\n"
    if finding.suppressed is not None:
        yield f"{lead} suppressed: {fold_lines(finding.suppressed, unicode=style.unicode)}\n"
    for line in FixPreview(style, gutter).block(finding):
        yield f"{line}\n"
    yield f"{lead} docs: kinlint rule {finding.rule.code}\n\n"


def _headline(finding: Finding, style: Style, *, unsafe: bool | None) -> str:
    rule = finding.rule
    code = style.link(rule.code, rule.iri)
    kind = style.ink(f"{finding.severity.label}[{code}]", INK_OF[finding.severity])
    message = style.ink(fold_lines(finding.message, unicode=style.unicode), "strong")
    tags = f" [{', '.join(rule.antipatterns)}]" if rule.antipatterns else ""
    mark = sign(finding, unsafe=unsafe)
    return f"{kind}: {message}{tags}{f' {mark}' if mark else ''}"


def _place(location: Location, style: Style) -> str:
    line, column = location.start
    return f"{printable(location.source.name, unicode=style.unicode)}:{line}:{column}"


def _split(finding: Finding, style: Style) -> tuple[list[Mark], list[Mark]]:
    """The marks of the finding's own excerpt, its main one first, and those shown apart."""
    main = Mark(finding.location, INK_OF[finding.severity], sign="^")
    near = [main]
    far: list[Mark] = []
    for related in sorted(finding.related, key=_in_text):
        mark = Mark(related.location, "place", related.message)
        (near if _fits(mark, near, style) else far).append(mark)
    return near, far


def _in_text(related: Related) -> tuple[str, int]:
    return related.location.source.name, related.location.span.start


def _fits(mark: Mark, near: Sequence[Mark], style: Style) -> bool:
    """Tell whether *mark* is close, and visible in the excerpt of its line."""
    main = near[0]
    source = main.location.source
    if mark.location.source.name != source.name or abs(mark.line - main.line) > NEAR_LINES:
        return False
    leader = next((other for other in near if other.line == mark.line), mark)
    return cut_line(source, mark.line, leader.start, style).holds(mark.start)


def _derivation(premises: Sequence[Premise], style: Style) -> Iterator[str]:
    """A line for each statement that the finding rests on, what it follows from below it."""
    lead = "derived from: "
    for premise in premises[:PREMISES_SHOWN]:
        text = fold_lines(premise.statement, unicode=style.unicode)
        if premise.computed:
            text += f", {premise.axiom}" + ":" * premise.axiom.endswith("from")
        elif premise.inferred:
            text += f", inferred: {fold_lines(premise.axiom, unicode=style.unicode)}"
        if premise.location is not None:
            name = printable(premise.location.source.name, unicode=style.unicode)
            text += f" ({name}:{premise.location.start.line})"
        yield lead + "  " * premise.depth + text
        lead = " " * len(lead)
    if len(premises) > PREMISES_SHOWN:
        more = len(premises) - PREMISES_SHOWN
        yield f"{lead}and {more:,} more"


def _elsewhere(name: str, others: Sequence[Location], style: Style) -> str:
    """Return the lines of *others*; the file is named where it is not the one called *name*."""
    files: dict[str, list[Location]] = {}
    for other in others[:PLACES_SHOWN]:
        files.setdefault(other.source.name, []).append(other)
    places = [
        _lines(each) if file == name else f"{printable(file, unicode=style.unicode)} {_lines(each)}"
        for file, each in files.items()
    ]
    rest = len(others) - PLACES_SHOWN
    more = f" and {rest:,} more" if rest > 0 else ""
    return f"note: the same at {plural(len(others), 'other place')}: {'; '.join(places)}{more}"


def _lines(places: Sequence[Location]) -> str:
    """Return `lines 69, 74`; the columns too where all are in one line."""
    lines = list(dict.fromkeys(place.start.line for place in places))
    if len(lines) == 1 < len(places):
        return f"line {lines[0]}, columns {', '.join(str(each.start.column) for each in places)}"
    return f"line{'s' * (len(lines) > 1)} {', '.join(map(str, lines))}"
