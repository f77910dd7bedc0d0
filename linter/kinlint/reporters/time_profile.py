"""Time of a run by phase: the profile of `--statistics -v`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping


def render(phases: Mapping[str, float]) -> Iterator[str]:
    """A line for each of *phases*, which are in seconds: its time and its share of all."""
    total = sum(phases.values())
    rows = [*phases.items(), ("total", total)]
    width = max(len(name) for name, _ in rows)
    for name, seconds in rows:
        share = seconds / total if total else 0.0
        yield f"{name:<{width}}  {1000 * seconds:>9,.1f} ms  {share:>5.0%}\n"
