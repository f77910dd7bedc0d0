"""The table of results, in Markdown."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True)
class Row:
    """One comparison: the seconds of two things, and what is promised of them.

    `target` bounds the slower by the faster ("faster"), or the first by the second ("ratio").
    """

    ours: str
    theirs: str
    seconds: tuple[float, float]
    form: Literal["faster", "ratio"] = "ratio"
    target: float | None = None

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
        ours, theirs = map(duration, row.seconds)
        yield f"| {row.ours} | {row.theirs} | {ours} | {theirs} | {_ratio(row)} | {_target(row)} |"


def duration(seconds: float) -> str:
    """*seconds* to three digits, in a unit that suits them."""
    return f"{seconds * 1000:.3g} ms" if seconds < 1 else f"{seconds:,.3g} s".replace("e+03", "e3")


def _ratio(row: Row) -> str:
    if row.form == "faster":
        slower = row.ratio < 1
        return f"{1 / row.ratio:,.0f} times slower" if slower else f"{row.ratio:,.0f} times faster"
    return f"{row.ratio:.2f} times as long"


def _target(row: Row) -> str:
    if row.target is None:
        return ""
    sign = "≥" if row.form == "faster" else "≤"
    return f"{sign} {row.target:,g}{'' if row.met else ' **missed**'}"
