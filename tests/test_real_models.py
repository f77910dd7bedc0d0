"""What is found in the published models is what their defects are, at their lines."""

from collections import Counter

import pytest
from data import locate_data

from kinlint import lint, rulebook
from kinlint.configuration.settings import Settings
from kinlint.formats.registry import decode

TUTORIAL = {
    ("cartesian-coordinates.json", 13, "LD003"): 2,
    ("cartesian-coordinates.json", 17, "FRM004"): 1,
    ("cartesian-coordinates.json", 26, "LD003"): 2,
    ("cartesian-coordinates.json", 28, "LD001"): 1,
    ("dynamics.json", 16, "LD001"): 1,
    ("dynamics.json", 16, "LD002"): 1,
    ("dynamics.json", 17, "LD001"): 1,
    ("fpk-algorithm.json", 20, "ALG001"): 3,
    ("fpk-algorithm.json", 22, "LD001"): 1,
    ("fpk-algorithm.json", 22, "LD002"): 1,
    ("fpk-algorithm.json", 23, "LD001"): 1,
    ("fpk-algorithm.json", 24, "LD001"): 1,
    ("joint-coordinates.json", 17, "LD001"): 1,
    ("joint-coordinates.json", 17, "LD002"): 1,
    ("skeleton.json", 49, "FRM014"): 1,
}


@pytest.fixture
def models():
    return locate_data() / "comp-rob2b"


def findings(directory, **settings):
    files = sorted(directory.rglob("*.json"))
    sources = [decode(file.name, file.read_bytes()) for file in files]
    return lint.run(sources, [], Settings(**settings), rulebook.load()).findings


def counted(found):
    return Counter(
        (each.location.source.name, each.location.start.line, each.rule.code) for each in found
    )


def test_the_tutorial_of_the_paper(models):
    """Every known defect of the tutorial is found at its line, and nothing else."""
    assert counted(findings(models / "modelling-tutorial")) == TUTORIAL


def test_kinova_gen3(models):
    """Kinova Gen3: keys and types that the contexts dropped, and nothing that is right."""
    found = findings(models / "robot-models")
    by_rule = Counter(each.rule.code for each in found)
    lines = {(each.location.source.name, each.location.start.line) for each in found}

    assert by_rule == {"LD001": 49, "LD002": 3, "LD003": 10}
    assert {("robot.dyn.json", line) for line in range(15, 177, 23)} <= lines
    assert {("robot.kin-chain.json", 17), ("robot.kin-chain.json", 21)} <= lines


def test_the_release_decides_what_is_lost(models):
    """Read with the contexts of its time, the tutorial keeps its operands."""
    found = findings(models / "modelling-tutorial", contexts="59e0b06")

    assert ("fpk-algorithm.json", 22, "LD001") not in counted(found)
    assert "ALG001" not in {each.rule.code for each in found}
