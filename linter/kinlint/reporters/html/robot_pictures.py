"""The pictures of the robots, with badges that lead to the findings."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from kinlint.finding import Finding
from kinlint.report import Report
from kinlint.reporters.picture import svg, text_tree
from kinlint.reporters.picture.escape import element, text
from kinlint.reporters.picture.finding_badges import Marks, badge, paired
from kinlint.reporters.picture.labels import heading
from kinlint.reporters.terminal_style import Style
from kinlint.structure import Structure

FIT = '<label class="fit"><input type="checkbox"> Fit to the width</label>'
WIDE = 1080
"""Width in pixels above which a picture does not fit the page."""
OPEN = 3
"""Number of robots above which only those with findings are unfolded."""


def robots(report: Report, address: Callable[[Finding], str]) -> Iterator[str]:
    """The section of pictures; nothing if no robot was read."""
    if not report.structures:
        return
    yield '<section id="robots" aria-labelledby="robots-title">\n'
    yield '<h2 id="robots-title">Robots</h2>\n'
    few = len(report.structures) <= OPEN
    for index, (structure, found) in enumerate(paired(report.structures, report.unsuppressed)):
        yield _robot(structure, found, f"robot{index}", address, shown=few)
    yield "</section>\n"


def _robot(
    structure: Structure,
    found: Marks,
    name: str,
    address: Callable[[Finding], str],
    *,
    shown: bool,
) -> str:
    title = element("strong", text(structure.name))
    title += text(heading(structure)[len(structure.name) :])
    for one in found.get(structure.iri, ()):
        mark = badge([one])
        if mark is not None:
            link = element("a", text(mark.text()), href=address(one))
            title += " " + element("span", link, class_=f"chip {one.severity.label}")
    files = element("p", text(", ".join(structure.files)), class_="place")
    picture, width = svg.figure(structure, found, name=name, href=address)
    label = f"Picture of {structure.name}, scrolls"
    canvas = element("div", picture, class_="canvas", tabindex="0", role="region", aria_label=label)
    tree = "\n".join(text_tree.lines(structure, found, Style()))
    lines = element("pre", text_block(tree), tabindex="0")
    words = element("details", f"<summary>As text</summary>{lines}", class_="words")
    fit = FIT if width > WIDE else ""
    body = f"{files}<figure>{fit}{canvas}</figure>{words}"
    opening = f'<details class="robot-card"{" open" if shown else ""}>'
    return f"{opening}<summary>{title}</summary>{body}</details>\n"


def text_block(lines: str) -> str:
    """Text of several lines as markup."""
    return "\n".join(text(line) for line in lines.split("\n"))
