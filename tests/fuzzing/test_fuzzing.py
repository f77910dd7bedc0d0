"""Mutated files of each format are answered; `python tests/fuzzing` goes on for hours."""

from __future__ import annotations

import pytest

from fuzzing import trial
from fuzzing.corpus import SUFFIXES, corpus
from fuzzing.trial import Input, fault, made, reduced

SHARE = 40
"""Inputs of a run: each alone, or all as one model."""
PARTS = 12
"""Tests of a format."""
MODELS = {
    "mjcf": 4,
    "urdf": 4,
    "jsonld": 6,
    "sdf": 6,
    "turtle": 9,
    "collada": 12,
    "usd": 12,
    "xacro": 14,
    "yaml": 14,
    "srdf": 20,
}
"""Models of a test, with which all tests of a format take about a minute of CPU."""


@pytest.mark.slow
@pytest.mark.parametrize("part", range(PARTS))
@pytest.mark.parametrize("form", SUFFIXES)
def test_mutated_files_are_answered(form, part):
    faults = {seed: fault(made(form, seed)) for seed in range(part * SHARE, (part + 1) * SHARE)}
    assert {seed: found for seed, found in faults.items() if found} == {}


@pytest.mark.slow
@pytest.mark.parametrize("part", range(PARTS))
@pytest.mark.parametrize("form", SUFFIXES)
def test_mutated_files_are_answered_as_one_model(form, part):
    models = MODELS[form] * SHARE
    for start in range(part * models, (part + 1) * models, SHARE):
        given = [made(form, seed) for seed in range(start, start + SHARE)]
        assert fault(*given) is None, start


@pytest.mark.parametrize("form", SUFFIXES)
def test_inputs_are_made_again_by_their_number(form):
    assert corpus(form)
    assert made(form, 7) == made(form, 7)
    assert len({made(form, seed).content for seed in range(20)}) > 15


def test_a_fault_is_told_with_the_inputs_that_lead_to_it(monkeypatch):
    given = [Input("urdf", each, f"{each}.urdf", b"<robot name='%d'/>" % each) for each in range(8)]

    def broken(sources, *_):
        if {"<robot name='1'/>", "<robot name='3'/>"} <= {source.text for source in sources}:
            raise AttributeError("no such thing")
        return run([], *_)

    run = trial.lint.run
    monkeypatch.setattr("fuzzing.trial.lint.run", broken)
    assert "no such thing" in (fault(*given) or "")
    assert [each.seed for each in reduced(given)] == [1, 3]
