"""Pictures of the robots, a figure and a tree each, with marks that lead to the findings."""

from __future__ import annotations

from collections.abc import Callable
from itertools import chain

from kinlint.finding import Finding
from kinlint.report import Report
from kinlint.reporters.html.folding_outline import outline
from kinlint.reporters.picture import svg, text_tree
from kinlint.reporters.picture.escape import element, text
from kinlint.reporters.picture.finding_badges import Marks, badge, marked, paired
from kinlint.reporters.picture.labels import heading
from kinlint.reporters.picture.stick_figure.figure_svg import figure
from kinlint.reporters.terminal_style import Style
from kinlint.structure import Structure

OPEN = 3
"""Number of robots above which only those with findings are unfolded."""
LARGE = 45
"""Number of links above which a robot has an outline that folds instead of a drawn tree."""


class RobotPictures:
    """Pictures of all robots of a report; *address* leads to a finding on the page."""

    def __init__(
        self, report: Report, address: Callable[[Finding], str], *, frames: bool = False
    ) -> None:
        self.address = address
        self.frames = frames
        self.anchors: dict[int, str] = {}
        """Identifier of the mark of each finding in a figure, by the `id` of the finding."""
        few = len(report.structures) <= OPEN
        self._cards = [
            self._robot(structure, found, f"robot{index}", shown=few)
            for index, (structure, found) in enumerate(
                paired(report.structures, report.unsuppressed)
            )
        ]

    def section(self) -> str:
        """Return the section of pictures; nothing if no robot was read."""
        if not self._cards:
            return ""
        return (
            '<section id="robots" aria-labelledby="robots-title">\n'
            f'<h2 id="robots-title">Robots</h2>\n{"".join(self._cards)}</section>\n'
        )

    def _robot(self, structure: Structure, found: Marks, name: str, *, shown: bool) -> str:
        found = marked(found)
        title = element("strong", text(structure.name))
        title += text(heading(structure)[len(structure.name) :])
        for one in found.get(structure.iri, ()):
            mark = badge([one])
            if mark is not None:
                link = element("a", text(mark.text()), href=self.address(one))
                title += " " + element("span", link, class_=f"chip {one.severity.label}")
        files = element("p", text(", ".join(structure.files)), class_="place")
        tree, words = self._tree(structure, found, name)
        views = element("div", self._figure(structure, found, name) + tree, class_="views") + words
        opened = shown or any(chain.from_iterable(found.values()))
        opening = f'<details class="robot-card"{" open" * opened}>'
        return f"{opening}<summary>{title}</summary>{files}{views}</details>\n"

    def _figure(self, structure: Structure, found: Marks, name: str) -> str:
        drawn = figure(structure, found, name=f"{name}-figure", href=self.address)
        if drawn is None:
            return ""
        for finding, anchor in drawn.anchors.items():
            self.anchors.setdefault(finding, anchor)
        caption = element("figcaption", drawn.caption)
        return element("figure", drawn.svg + caption, class_="view")

    def _tree(self, structure: Structure, found: Marks, name: str) -> tuple[str, str]:
        """Return the tree, and the same as text where it is drawn."""
        if len(structure.links) > LARGE:
            return outline(structure, found, self.address), ""
        picture = svg.figure(structure, found, name=name, frames=self.frames, href=self.address)
        label = f"Tree of {structure.name}, scrolls"
        canvas = element(
            "div", picture, class_="canvas", tabindex="0", role="region", aria_label=label
        )
        tree = "\n".join(text_tree.lines(structure, found, Style(), frames=self.frames))
        lines = element("pre", text_block(tree), tabindex="0")
        words = element("details", f"<summary>As text</summary>{lines}", class_="words")
        return element("figure", canvas, class_="view"), words


def text_block(lines: str) -> str:
    """Text of several lines as markup."""
    return "\n".join(text(line) for line in lines.split("\n"))
