"""Times the answer to a keystroke against a whole process for the same file."""

from __future__ import annotations

import gc
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import count, cycle

from benchmarks import robot
from benchmarks.processes import KINLINT, Workplace
from benchmarks.table import Row
from benchmarks.timing import interleaved
from benchmarks.urdf_robot import urdf_chain
from kinlint.catalogue import rulebook
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.pipeline.analyzer import Analyzer
from kinlint.text import SourceText

JOINTS = 60
TARGET = 10
"""How many times faster an answer has to be than a process."""

MODELS = {
    "JSON-LD": ("chain.jsonld", robot.chain(JOINTS)),
    "JSON-LD with faults": ("spoiled.jsonld", robot.chain(JOINTS, spoiled=True)),
    "URDF": ("chain.urdf", urdf_chain(JOINTS)),
}
"""Robots of so many joints: how their files are called and what they hold."""

KEYSTROKES = {
    "a digit": re.compile(r"0\.(?=[0-9])"),
    "a letter of a name": re.compile(r'"[a-z:]*link3'),
}
"""What is typed: one character after the middle one of the places where this matches."""


@dataclass(frozen=True)
class Keystrokes:
    """Somebody types in files at a workplace, where processes run, too."""

    place: Workplace

    def rows(self, runs: int) -> Iterator[Row]:
        """A row for each robot and keystroke."""
        book = rulebook.load()
        for form, (name, text) in MODELS.items():
            whole = self._process(name, text)
            for what, pattern in KEYSTROKES.items():
                ours, theirs = interleaved([typing(name, text, pattern, book), whole], runs)
                yield Row(
                    f"{what} typed, {JOINTS} joints in {form}",
                    "`kinlint` on that file",
                    (ours, theirs),
                    "faster",
                    TARGET,
                )

    def _process(self, name: str, text: str) -> Callable[[], None]:
        """What runs kinlint on *text*, each time with an empty line more, as it never saw it."""
        ends = (end * "\n" for end in count())

        def run() -> None:
            (self.place.directory / name).write_text(text + next(ends), "utf-8")
            self.place.run([KINLINT, "--output-format=concise", name])

        return run


def typing(name: str, text: str, pattern: re.Pattern[str], book: Rulebook) -> Callable[[], object]:
    """What types a character into *text*, or deletes it again, and waits for the answer."""
    places = [match.end() for match in pattern.finditer(text)]
    at = places[len(places) // 2]
    texts = cycle([f"{text[:at]}1{text[at:]}", text])
    incremental = Analyzer(Settings(), book, repeated=True)
    for each in (text, next(texts), next(texts)):
        incremental.examine([SourceText(name, each)])
    gc.collect()
    gc.freeze()
    return lambda: incremental.examine([SourceText(name, next(texts))])
