"""The table of results, in Markdown."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Literal

TEN = 10.0
"""Ratios from here on are told without decimals."""


@dataclass(frozen=True)
class Row:
    """One comparison: the seconds of two things, and what is promised of them.

    `target` bounds the slower by the faster ("faster"), or the first by the second ("ratio").
    Of memory, it compares bytes.
    """

    ours: str
    theirs: str
    seconds: tuple[float, float]
    form: Literal["faster", "ratio"] = "ratio"
    target: float | None = None
    unit: Literal["s", "B"] = "s"

    @property
    def ratio(self) -> float:
        """By how much ours is faster, or how many times theirs it takes."""
        ours, theirs = self.seconds
        return theirs / ours if self.form == "faster" else ours / theirs

    @property
    def met(self) -> bool:
        """Whether what is promised holds, if anything is."""
        if self.target is None:
            return True
        return self.ratio >= self.target if self.form == "faster" else self.ratio <= self.target


def markdown(rows: Iterable[Row]) -> Iterator[str]:
    """The lines of a table of *rows*."""
    yield "| kinlint | compared with | kinlint takes | the other | ratio | target |"
    yield "|---|---|--:|--:|--:|--:|"
    for row in rows:
        ours, theirs = map(duration if row.unit == "s" else memory, row.seconds)
        yield f"| {row.ours} | {row.theirs} | {ours} | {theirs} | {_ratio(row)} | {_target(row)} |"


def duration(seconds: float) -> str:
    """*seconds* to three digits, in a unit that suits them."""
    return f"{seconds * 1000:.3g} ms" if seconds < 1 else f"{seconds:,.3g} s".replace("e+03", "e3")


def memory(size: float) -> str:
    """*size*, in bytes, as megabytes."""
    return f"{size / 1e6:,.0f} MB"


def _ratio(row: Row) -> str:
    if row.form == "faster":
        slower = row.ratio < 1
        times = 1 / row.ratio if slower else row.ratio
        digits = 0 if times >= TEN else 1
        return f"{times:,.{digits}f} times {'slower' if slower else 'faster'}"
    return f"{row.ratio:.2f} times as {'long' if row.unit == 's' else 'much'}"


def _target(row: Row) -> str:
    if row.target is None:
        return ""
    sign = "≥" if row.form == "faster" else "≤"
    return f"{sign} {row.target:,g}{'' if row.met else ' **missed**'}"
