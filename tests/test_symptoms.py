"""Every symptom of the anti-patterns that a composable model can show is found by a rule."""

import re

import pytest

from kinlint import rulebook
from kinlint.reporters.symptoms import SYMPTOMS, symptom_table

RULES = rulebook.load().rules


def test_there_are_thirty_five():
    """As many as the paper's anti-patterns have in JSON-LD."""
    assert len(SYMPTOMS) == 35


@pytest.mark.parametrize("symptom", SYMPTOMS)
def test_a_symptom_is_found_by_a_rule(symptom):
    """That rule witnesses the anti-pattern that the symptom is of."""
    found = [rule for rule in RULES if symptom in rule.symptoms]

    assert found
    for rule in found:
        assert symptom.split(".")[0] in rule.antipatterns


def test_rules_name_symptoms_that_exist():
    """A number nobody explains would be none."""
    assert {each for rule in RULES for each in rule.symptoms} <= SYMPTOMS.keys()


def test_the_table_names_the_rules_of_each_symptom():
    """A row for each, with codes."""
    rows = list(symptom_table(RULES))[2:]

    assert len(rows) == len(SYMPTOMS)
    for row, symptom in zip(rows, SYMPTOMS, strict=True):
        assert row.startswith(f"| {symptom} | ")
        assert re.search(r"\| [A-Z]+\d{3}(, [A-Z]+\d{3})* \|$", row)
