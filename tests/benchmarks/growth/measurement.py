"""Times a run over a file and over one with four times as many of some part."""

from __future__ import annotations

import gc
import math
import time
from collections.abc import Iterator
from dataclasses import dataclass

from benchmarks.growth.growing import Growing
from benchmarks.growth.other_inputs import OTHERS
from benchmarks.growth.urdf_inputs import URDF
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.parallel.shard import Job, lint_shard
from kinlint.phases import Phases
from kinlint.text import SourceText

FACTOR = 4
LARGEST_EXPONENT = 1.2
"""Exponent of the time above which growth is too fast."""
SHORTEST = 0.2
"""CPU seconds of the smaller run below which it is made larger: the constant part would hide the
growth of the rest.
"""
LARGEST_COUNT = 16_000
"""Number from which on it is not made larger."""
GROWTH_HEADING = """\
| input | N | N: CPU s | 4 N: CPU s | exponent | findings | longest phase |
|---|--:|--:|--:|--:|--:|---|"""
"""Markdown of the head of a table of growth."""


@dataclass(frozen=True)
class Growth:
    """The time of two runs over inputs of one kind."""

    title: str
    """What there is more of."""
    count: int
    """How many in the smaller input."""
    seconds: tuple[float, float]
    """CPU seconds of the smaller and of the larger input."""
    findings: int
    """How many findings the larger one has."""
    phase: str
    """The phase that takes longest in the larger one."""

    @property
    def exponent(self) -> float:
        """The power of the number that the time grows with."""
        small, large = self.seconds
        return math.log(large / small, FACTOR)

    @property
    def met(self) -> bool:
        """Tell whether the time grows as it may."""
        return self.exponent <= LARGEST_EXPONENT

    @property
    def line(self) -> str:
        """Return its row in a table of growth, in Markdown."""
        small, large = self.seconds
        missed = "" if self.met else f" **above {LARGEST_EXPONENT}**"
        return (
            f"| {self.title} | {self.count} | {small:.2f} | {large:.2f}"
            f" | {self.exponent:.2f}{missed} | {self.findings} | {self.phase} |"
        )


def measured(titles: str, catalogue: Rulebook, *, fixing: bool) -> Iterator[Growth]:
    """Yield the growth of every input whose title contains *titles*; with fixes if *fixing*."""
    job = Job(Settings(), catalogue, fixing)
    lint_once(URDF[0], 10, job)
    for each in (*URDF, *OTHERS):
        if titles.lower() in each.title.lower():
            yield _growth(each, job)


def _growth(given: Growing, job: Job) -> Growth:
    count = given.count
    small, _, _ = lint_once(given, count, job)
    while small < SHORTEST and count < LARGEST_COUNT:
        count *= 2
        small, _, _ = lint_once(given, count, job)
    large, findings, phase = lint_once(given, FACTOR * count, job)
    return Growth(given.title, count, (small, large), findings, phase)


def lint_once(given: Growing, count: int, job: Job) -> tuple[float, int, str]:
    """Return the CPU seconds of a run over *count* parts, its findings, and the longest phase."""
    source = SourceText(given.name, given.text(count))
    phases = Phases()
    gc.collect()
    started = time.process_time()
    (outcome,) = lint_shard([[source]], (), job, phases)
    taken = time.process_time() - started
    return (
        taken,
        len(outcome.report.findings),
        max(phases.seconds, key=lambda name: phases.seconds[name]),
    )
