"""What takes too long is interrupted and told, and the server goes on."""

import time
from contextlib import suppress

import pytest
from robots import GOOD, LEG
from test_library import here, library, moment, never  # noqa: F401  fixtures

from kinlint.pipeline.analyzer import Analyzer
from kinlint.server import session, thread_limit
from kinlint.server.thread_limit import TimeOver


def forever():
    while True:
        with suppress(Exception):  # as readers do
            sum(range(100))


def test_a_loop_is_interrupted():
    with pytest.raises(TimeOver), thread_limit.thread_limit(0.2):
        forever()


def test_what_ends_in_time_is_left_alone():
    with thread_limit.thread_limit(60):
        pass
    for _ in range(20):  # it may be over before the block is entered
        with suppress(TimeOver), thread_limit.thread_limit(0.001):
            pass
    sum(range(100_000))
    time.sleep(0.01)
    assert thread_limit.answered(str, 1) == "1"


def test_a_request_without_an_answer(monkeypatch):
    monkeypatch.setattr(thread_limit, "REQUEST", 0.2)
    assert thread_limit.answered(lambda _: forever(), None) is None


@pytest.mark.slow
def test_a_model_that_takes_too_long_has_a_diagnostic(here, library, monkeypatch):  # noqa: F811
    """Another is checked as ever, and so is this one when it changes."""
    (here / "leg.srdf").unlink()
    monkeypatch.setattr(session, "ANALYSIS", 0.5)
    examine = Analyzer.examine

    def stubborn(self, sources, *arguments, **more):
        if any("FOREVER" in each.text for each in sources):
            forever()
        return examine(self, sources, *arguments, **more)

    monkeypatch.setattr(Analyzer, "examine", stubborn)
    evil = GOOD.replace("</robot>", "<!-- FOREVER --></robot>")
    step = library.step(moment(here, 1, ("leg.urdf", evil)), never)
    told = {path.name: [each.message for each in found.items] for path, found in step.found.items()}
    assert told == {"leg.urdf": ["not checked within 0.5 s"]}
    assert library.consult(here / "leg.urdf", None, str, never) is None
    monkeypatch.setattr(session, "ANALYSIS", 300.0)
    after = library.step(moment(here, 2, ("leg.urdf", LEG)), never)
    assert [each.code for found in after.found.values() for each in found.items] == ["LIM001"]
