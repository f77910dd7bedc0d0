"""Time of a run by phase and by parts of phases: the profile of `--statistics -v` and `-vv`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

SLOWEST = 10
"""The number of parts of a kind that are listed."""


def render(phases: Mapping[str, float]) -> Iterator[str]:
    """A line for each of *phases*, which are in seconds: its time and its share of all."""
    total = sum(phases.values())
    yield from _table([*phases.items(), ("total", total)], total)


def render_parts(parts: Mapping[tuple[str, str], float]) -> Iterator[str]:
    """A paragraph for each kind of *parts*, which are in seconds: the slowest, and all others.

    The share is that of all parts of the kind.
    """
    for kind in dict.fromkeys(kind for kind, _ in parts):
        named = {name: seconds for (each, name), seconds in parts.items() if each == kind}
        order = sorted(named.items(), key=lambda one: (-one[1], one[0]))
        rest = order[SLOWEST:]
        rows = order[:SLOWEST]
        if rest:
            rows.append((f"{len(rest)} others", sum(seconds for _, seconds in rest)))
        yield f"\nslowest {kind}:\n"
        yield from _table(rows, sum(named.values()))


def _table(rows: list[tuple[str, float]], total: float) -> Iterator[str]:
    width = max(len(name) for name, _ in rows)
    for name, seconds in rows:
        share = seconds / total if total else 0.0
        yield f"{name:<{width}}  {1000 * seconds:>9,.1f} ms  {share:>5.0%}\n"
