"""Mutated files of each format are answered; `python tests/fuzzing` goes on for hours."""

from __future__ import annotations

import pytest

from fuzzing.corpus import SUFFIXES, corpus
from fuzzing.trial import fault, made

SHARE = 40
PARTS = 4


@pytest.mark.slow
@pytest.mark.parametrize("part", range(PARTS))
@pytest.mark.parametrize("form", SUFFIXES)
def test_mutated_files_are_answered(form, part):
    faults = {seed: fault(made(form, seed)) for seed in range(part * SHARE, (part + 1) * SHARE)}
    assert {seed: found for seed, found in faults.items() if found} == {}


@pytest.mark.parametrize("form", SUFFIXES)
def test_inputs_are_made_again_by_their_number(form):
    assert corpus(form)
    assert made(form, 7) == made(form, 7)
    assert len({made(form, seed).content for seed in range(20)}) > 15


def test_a_fault_is_told(monkeypatch):
    def broken(*_):
        raise AttributeError("no such thing")

    monkeypatch.setattr("fuzzing.trial.lint.run", broken)
    assert "no such thing" in (fault(made("urdf", 1)) or "")
