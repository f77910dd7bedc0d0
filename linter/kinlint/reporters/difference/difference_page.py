"""Differences between descriptions of robots as one HTML page."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Iterator, Sequence
from hashlib import sha256
from html import escape

from kinlint.reporters.difference.difference_text import (
    heading,
    part_title,
    place,
    summary,
    unstated_line,
)
from kinlint.robot_difference import RobotDifference

CSS = """
:root { color-scheme: light dark; font: 15px/1.5 system-ui, sans-serif; }
body { margin: 2rem auto; max-width: 70rem; padding: 0 1rem; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; padding: .3rem .6rem; border-bottom: 1px solid #8885; }
td:nth-child(n + 3) { font-family: ui-monospace, monospace; font-size: 85%; }
"""


def render_page(differences: Sequence[RobotDifference]) -> Iterator[str]:
    """Yield a page with a table for each pair of descriptions. It loads and runs nothing."""
    digest = b64encode(sha256(CSS.encode()).digest()).decode()
    policy = f"default-src 'none'; style-src 'sha256-{digest}'"
    yield (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
        f"<title>kinlint diff</title>\n<style>{CSS}</style>\n</head>\n<body>\n"
        f"<h1>{escape(summary(differences))}</h1>\n"
    )
    for each in differences:
        if each.differs or each.unstated:
            yield from _robot(each)
    yield "</body>\n</html>\n"


def _robot(each: RobotDifference) -> Iterator[str]:
    yield f"<h2>{escape(heading(each))}</h2>\n"
    rows = [
        (change.title, change.phrase, place(change.old_place), place(change.new_place))
        for change in each.changes
    ]
    rows += [(part_title(part), "removed", place(part.place), "") for part in each.removed]
    rows += [(part_title(part), "added", "", place(part.place)) for part in each.added]
    if rows:
        yield "<table>\n<tr><th>part<th>change<th>old<th>new</tr>\n"
        for row in rows:
            yield f"<tr>{''.join(f'<td>{escape(cell)}' for cell in row)}</tr>\n"
        yield "</table>\n"
    if each.unstated:
        yield "<ul>\n"
        yield from (f"<li>{escape(unstated_line(one))}</li>\n" for one in each.unstated)
        yield "</ul>\n"
