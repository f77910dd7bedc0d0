"""Times the answer to a keystroke against a whole process for the same file."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from itertools import count, cycle
from statistics import median

from benchmarks import robot
from benchmarks.processes import KINLINT, Workplace
from benchmarks.starting import PASS
from benchmarks.table import Row
from benchmarks.timing import interleaved, processor_time, timed
from benchmarks.urdf_robot import urdf_chain
from benchmarks.xml_robots import sdf_chain, xacro_chain
from kinlint import garbage
from kinlint.catalogue import rulebook
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.navigation.navigator import Navigator
from kinlint.pipeline.analyzer import Analyzer, Examination
from kinlint.text import SourceText

JOINTS = (60, 200)
TARGET = 10
"""How many times faster an answer has to be than a process."""
HOVER = 2.3
"""How many times the work of `python -c pass`, of 22 ms, the first hover after an edit may take."""

MODELS: Mapping[str, tuple[str, Callable[[int], str]]] = {
    "JSON-LD": ("chain.jsonld", robot.chain),
    "JSON-LD with faults": ("spoiled.jsonld", partial(robot.chain, spoiled=True)),
    "URDF": ("chain.urdf", urdf_chain),
    "xacro": ("chain.xacro", xacro_chain),
    "SDF": ("chain.sdf", sdf_chain),
}
"""Robots: how their files are called, and what makes one of so many joints."""

KEYSTROKES = {
    "a digit": re.compile(r"0\.(?=[0-9])"),
    "a letter of a name": re.compile(r'"[a-z:]*link3'),
}
"""What is typed: one character after the middle one of the places where this matches."""


@dataclass(frozen=True)
class Keystrokes:
    """Somebody types in files at a workplace, where processes run, too."""

    place: Workplace

    def rows(self, runs: int, wanted: str = "") -> Iterator[Row]:
        """A row for each robot, size and keystroke whose title has *wanted*, and for hovers."""
        book = rulebook.load()
        for stroke in strokes("typed", wanted):
            whole = self._process(stroke.name, stroke.text)
            actions = [typing(stroke, book), whole]
            ours, theirs = interleaved(actions, runs)
            yield Row(stroke.title, "`kinlint` on that file", (ours, theirs), "faster", TARGET)
        for stroke in strokes("typed, then the first hover", wanted):
            seconds = self._hover(stroke, book, runs)
            yield Row(stroke.title, "`python -c pass`, CPU", seconds, target=HOVER)

    def _hover(self, stroke: Stroke, book: Rulebook, runs: int) -> tuple[float, float]:
        """The median seconds of CPU of the first hover after an edit, and of an empty process."""
        answer = typing(stroke, book)
        ours, theirs = list[float](), list[float]()
        for _ in range(runs):
            navigator = Navigator(answer(), book, {})
            shown = partial(navigator.hover, stroke.name, stroke.at - 1)
            ours.append(timed(shown, processor_time))
            theirs.append(timed(partial(self.place.run, list(PASS)), processor_time))
        return median(ours), median(theirs)

    def _process(self, name: str, text: str) -> Callable[[], None]:
        """What runs kinlint on *text*, each time with an empty line more, as it never saw it."""
        ends = (end * "\n" for end in count())

        def run() -> None:
            (self.place.directory / name).write_text(text + next(ends), "utf-8")
            self.place.run([KINLINT, "--output-format=concise", name])

        return run


@dataclass(frozen=True)
class Stroke:
    """A character that is typed into `text`, a file called `name`, at the offset `at`."""

    title: str
    name: str
    text: str
    at: int


def strokes(act: str, wanted: str = "") -> Iterator[Stroke]:
    """All keystrokes, by titles that say that they are *act*, of which each has *wanted*."""
    for joints in JOINTS:
        for form, (name, make) in MODELS.items():
            for what, pattern in KEYSTROKES.items():
                title = f"{what} {act}, {joints} joints in {form}"
                if wanted in title:
                    text = make(joints)
                    places = [match.end() for match in pattern.finditer(text)]
                    yield Stroke(title, name, text, places[len(places) // 2])


def typing(stroke: Stroke, book: Rulebook) -> Callable[[], Examination]:
    """What types a character, or deletes it again, and waits for the answer."""
    text, at = stroke.text, stroke.at
    texts = cycle([f"{text[:at]}1{text[at:]}", text])
    incremental = Analyzer(Settings(), book, repeated=True)
    for each in (text, next(texts), next(texts)):
        incremental.examine([SourceText(stroke.name, each)])
    garbage.freeze()
    return lambda: incremental.examine([SourceText(stroke.name, next(texts))])
