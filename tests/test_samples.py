"""The samples say what their README promises: good ones are clean, broken ones broken as marked."""

from pathlib import Path

import pytest

from kinlint import lint, rulebook
from kinlint.configuration.settings import Settings
from kinlint.formats.registry import decode

SAMPLES = Path(__file__).parents[1] / "samples"
GOOD = ("one-dof", "six-axis", "four-bar")
BROKEN = sorted((SAMPLES / "broken").glob("*.jsonld"))


def report(*files):
    sources = [decode(str(file), file.read_bytes()) for file in files]
    return lint.run(sources, [], Settings(), rulebook.load())


@pytest.mark.parametrize("name", GOOD)
def test_a_good_sample_is_clean(name):
    """Good samples have no finding, read without an error, and rules applied to every file."""
    outcome = report(*sorted((SAMPLES / name).glob("*.jsonld")))

    assert [finding.message for finding in outcome.findings] == []
    assert outcome.errors == ()
    assert outcome.unapplied == ()


@pytest.mark.parametrize("file", BROKEN, ids=lambda file: file.stem)
def test_a_broken_sample_is_found_broken_where_it_is(file):
    """The findings of a broken sample are those listed beside it, and no others."""
    found = []
    for finding in report(file).findings:
        start = finding.location.start
        found.append(f"{start.line}:{start.column} {finding.rule.code}")

    assert found == file.with_suffix(".expected").read_text().splitlines()


def test_every_rule_about_models_has_a_broken_sample():
    """A fault that a rule names can be seen in a file of that name."""
    about_models = {rule.name for rule in rulebook.load().rules if rule.family != "LNT"}

    assert about_models == {file.stem for file in BROKEN}
