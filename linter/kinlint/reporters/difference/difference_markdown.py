"""Differences between descriptions of robots as Markdown, for pull requests."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.reporters.difference.difference_text import (
    heading,
    part_title,
    place,
    summary,
    unstated_line,
)
from kinlint.reporters.markdown_text import escaped, table
from kinlint.robot_difference import RobotDifference


def render_markdown(differences: Sequence[RobotDifference]) -> Iterator[str]:
    """Yield a heading and a table for each pair of descriptions."""
    yield f"**{escaped(summary(differences))}**\n"
    for each in differences:
        if not each.differs and not each.unstated:
            continue
        yield f"\n### {escaped(heading(each))}\n\n"
        rows = [
            (
                escaped(change.title),
                escaped(change.phrase),
                escaped(place(change.old_place)),
                escaped(place(change.new_place)),
            )
            for change in each.changes
        ]
        rows += [
            (escaped(part_title(part)), "removed", escaped(place(part.place)), "")
            for part in each.removed
        ]
        rows += [
            (escaped(part_title(part)), "added", "", escaped(place(part.place)))
            for part in each.added
        ]
        if rows:
            yield table(("part", "change", "old", "new"), rows, -1)
        if each.unstated:
            yield "\n" + "".join(f"- {escaped(unstated_line(one))}\n" for one in each.unstated)
