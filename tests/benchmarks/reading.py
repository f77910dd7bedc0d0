"""Reading JSON-LD, compared with the same reader when PyLD expands all of it."""

from __future__ import annotations

import time
from collections.abc import Iterator

from benchmarks import robot
from benchmarks.table import Row
from benchmarks.timing import interleaved
from kinlint.formats.jsonld.reader import read
from kinlint.formats.options import ReadOptions
from kinlint.text import SourceText

JOINTS = 700
TARGET = 10


def rows(runs: int) -> Iterator[Row]:
    """Reading a chain: statements and what is told of them, then the place of each as well."""
    text = SourceText("chain.jsonld", robot.chain(JOINTS, spoiled=True))
    for places in (False, True):

        def reading(*, compiled: bool, places: bool = places) -> None:
            document = read(text, ReadOptions(), compiled=compiled)
            if places:
                list(document.map.triples.items())

        seconds = interleaved(
            (lambda: reading(compiled=True), lambda: reading(compiled=False)),
            runs,
            time.process_time,
        )
        asked = " and asking for all places" if places else ""
        title = f"reading {JOINTS} joints in JSON-LD{asked}"
        yield Row(title, "PyLD for all of it", seconds, "faster", None if places else TARGET)
