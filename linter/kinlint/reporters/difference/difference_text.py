"""Differences between descriptions of robots, for the terminal."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from kinlint.reporters.display_width import printable
from kinlint.reporters.terminal_style import Style
from kinlint.robot_difference import Change, Part, RobotDifference, Unstated
from kinlint.text import Location

LISTED = 6
"""Most names in a list."""


def render_text(differences: Sequence[RobotDifference], style: Style) -> Iterator[str]:
    """Yield the differences, part by part, with both places."""
    for each in differences:
        if each.differs or each.unstated or len(differences) == 1:
            yield from _robot(each, style)
    yield f"{summary(differences)}\n"


def _robot(each: RobotDifference, style: Style) -> Iterator[str]:
    if not (each.old and each.new):
        yield style.ink(printable(heading(each)), "strong") + "\n\n"
        return
    yield style.ink(printable(heading(each)), "strong") + "\n"
    for title, changes in each.by_part():
        yield f"  {printable(title)}\n"
        for change in changes:
            where = places(change)
            phrase = printable(change.phrase)
            yield f"    {phrase}" + (f"  {style.ink(where, 'place')}" if where else "") + "\n"
    for parts, mark, ink in ((each.removed, "-", "removed"), (each.added, "+", "added")):
        for part in parts:
            text = style.ink(printable(f"{mark} {part_title(part)}"), ink)  # type: ignore[arg-type]
            where = style.ink(place(part.place), "place")
            yield f"  {text}  {where}\n"
    for unstated in each.unstated:
        yield f"  {printable(unstated_line(unstated))}\n"
    yield "\n"


def heading(each: RobotDifference) -> str:
    """Return the names of both descriptions, or that one of them is missing."""
    if not each.new:
        return f"only in old: {each.old}"
    if not each.old:
        return f"only in new: {each.new}"
    matched, old, new = each.joints
    how = "" if each.matched == "names" else ", matched by structure and numbers"
    count = f"{matched} of {old} and {new} joints in common{how}"
    return f"{each.old} -> {each.new} ({count})"


def summary(differences: Sequence[RobotDifference]) -> str:
    """Return how many differences there are, in one sentence."""
    count = sum(each.count for each in differences)
    count += sum(not (each.old and each.new) for each in differences)
    if not count:
        return "No differences."
    return f"{count} difference{'s' if count > 1 else ''}."


def part_title(part: Part) -> str:
    """Return what a part is and its name."""
    detail = f" ({part.detail})" if part.detail else ""
    return f"{part.kind} '{part.name}'{detail}"


def unstated_line(each: Unstated) -> str:
    """Return what only one description states, and why the other does not."""
    names = ", ".join(f"'{name}'" for name in each.parts[:LISTED])
    if len(each.parts) > LISTED:
        names += f" and {len(each.parts) - LISTED} more"
    which = "old" if each.old_states else "new"
    other = "new" if each.old_states else "old"
    reason = "not given" if each.expressible else f"{each.form} cannot state it"
    return f"{each.quantity} only in the {which} one, in the {other} one {reason}: {names}"


def places(change: Change) -> str:
    """Return both places of a change; empty if it has none."""
    shown = [place(each) for each in (change.old_place, change.new_place) if each is not None]
    return ", ".join(shown)


def place(location: Location | None) -> str:
    """Return `file:line` of *location*."""
    return "" if location is None else printable(f"{location.source.name}:{location.start.line}")
