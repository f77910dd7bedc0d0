"""The summary of a step on GitHub, in Markdown: what the annotations leave untold, and pictures.

GitHub refuses a summary of more than one mebibyte as a whole, so no more is written than there is
room for. Robots are drawn by Mermaid, within the limits that GitHub gives it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from html import escape

from kinlint.report import Report
from kinlint.reporters.display_width import fold_lines, replace_surrogates
from kinlint.reporters.github import annotated
from kinlint.reporters.markdown import Address, by_rule, head, listing, unread
from kinlint.reporters.picture.finding_badges import Marks, marks
from kinlint.reporters.picture.mermaid import lines
from kinlint.reporters.repository_paths import Paths
from kinlint.reporters.summary import counts, plural
from kinlint.structure import Structure

CHARACTERS, EDGES = 50_000, 500
"""A chart with more than so many characters or edges is not drawn."""
ROBOTS = 20
"""Number of robots that are drawn at most."""
_CLOSING = 200
"""Bytes that are kept for the line that tells what there was no room for."""


def render(report: Report, robots: Sequence[Structure], url: Address, room: int) -> Iterator[str]:
    """The summary in at most *room* bytes, with pictures of *robots* and links made by *url*."""
    left, parts = room - _CLOSING, annotated(report)
    if left < 0:
        return
    paths = Paths(report.root)
    told = "".join((*head(report), *by_rule(report.unsuppressed), *unread(report, paths, url)))
    beyond: list[str] = []
    if parts.more_findings:
        beyond = [
            f"\n### Not annotated: {counts(parts.more_findings)}\n",
            *listing(parts.more_findings, paths, url, level=4),
        ]
    omitted = 0
    for piece in (told, *beyond, *_pictures(report, robots)):
        text = replace_surrogates(piece)
        size = len(text.encode())
        if omitted or size > left:
            omitted += 1
            continue
        left -= size
        yield text
    if omitted:
        yield "\nThe rest is too long for this summary; other output formats list everything.\n"


def _pictures(report: Report, robots: Sequence[Structure]) -> Iterator[str]:
    if robots:
        yield "\n### Kinematic trees\n"
    for robot in robots[:ROBOTS]:
        found = marks(robot, report.unsuppressed)
        yield _picture(robot, found)
    if (more := len(robots) - ROBOTS) > 0:
        yield f"\n{plural(more, 'more robot')}: `kinlint graph` draws them.\n"


def _picture(robot: Structure, found: Marks) -> str:
    number = len({id(one) for told in found.values() for one in told})
    about = f"{plural(len(robot.links), 'link')}, {plural(len(robot.joints), 'joint')}"
    title = escape(fold_lines(f"{robot.name} ({', '.join(robot.files)})")).replace("@", "&#64;")
    opened = " open" if number else ""
    head_line = f"\n<details{opened}><summary>{title}: {about}</summary>\n\n"
    chart = "\n".join(lines(robot, found))
    if len(chart) > CHARACTERS or 2 * len(robot.joints) > EDGES:
        return f"{head_line}Too large for GitHub to draw; `kinlint graph` does.\n\n</details>\n"
    return f"{head_line}```mermaid\n{chart}\n```\n\n</details>\n"
