"""Times the stages of one run, from text to findings."""

from __future__ import annotations

import gc
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from statistics import median
from time import perf_counter

from benchmarks import robot
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.engine.closure import close
from kinlint.engine.evaluate import check
from kinlint.engine.store import Store
from kinlint.facts.computation import facts
from kinlint.findings.finding_builder import findings
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.text import SourceText


def parsed(joints: int) -> Document:
    """What a spoiled chain of *joints* states."""
    text = SourceText("chain.jsonld", robot.chain(joints, spoiled=True))
    return read(text, ReadOptions.from_settings(Settings()))


def stages(joints: int, rulebook: Rulebook, runs: int) -> Mapping[str, float]:
    """The median seconds of each stage of linting a spoiled chain of *joints*."""
    taken: dict[str, list[float]] = {}

    @contextmanager
    def stage(name: str) -> Iterator[None]:
        started = perf_counter()
        yield
        taken.setdefault(name, []).append(perf_counter() - started)

    for _ in range(runs):
        gc.collect()
        with stage("reading"):
            document = parsed(joints)
        with stage("loading"):
            store = Store()
            store.load([document])
            store.load_vocabulary(rulebook.vocabulary)
        with stage("closure"):
            close(store, rulebook.axioms)
        with stage("facts"):
            store.state(facts(store))
        with stage("checking"):
            results = list(check(store, rulebook.constraints))
        with stage("locating"):
            findings(results, [document], store, rulebook)
    return {name: median(seconds) for name, seconds in taken.items()}
