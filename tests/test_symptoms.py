"""Every symptom of the anti-patterns that an author could have avoided is found by a rule."""

import re

import pytest
from support.linting import book

from kinlint.format_profile import profile
from kinlint.reporters.symptoms import FORMATS, SYMPTOMS, symptom_table

RULES = book().rules
AVOIDABLE = {
    "urdf": "1.1 1.2 1.3 2.3 3.2 3.3 3.8 3.9 3.10 3.11 4.2 4.3 4.4 4.5 5.3 5.4 5.5 5.6 "
    "6.1 6.2 6.3 6.5 6.6 6.7 6.10 6.12",
    "sdf": "1.2 1.3 2.3 3.6 3.8 3.10 3.11 4.3 4.5 4.6 5.3 5.4 5.6 6.1 6.3 6.4 6.5 6.6 6.10",
    "srdf": "1.2 1.3 2.3 3.8 3.11 4.3 5.3 6.7 6.10",
    "mjcf": "1.1 1.2 1.3 2.3 3.8 3.10 3.12 4.3 4.5 5.3 5.4 5.5 5.6 6.1 6.3 6.6 6.7 6.10",
    "collada": "1.1 1.2 1.3 2.3 3.8 3.12 4.3 4.5 5.4 5.6 6.1 6.7 6.10",
    "usd": "1.1 1.3 2.1 2.3 3.1 3.2 3.8 3.10 3.11 3.12 4.1 4.2 4.3 4.5 5.3 5.4 6.1 6.2 6.3 6.4 "
    "6.6 6.7 6.10",
}
"""What the author of a file of each format could have done better.

Of MJCF, two are left out that an author could avoid: looks and contact on one geom (4.1), as every
geom without a mesh has both, and the place of a joint (6.4), as a model that was written in global
coordinates has no other way to say it.
"""
INHERENT = {form: {each.number for each in profile(form).symptoms} for form in FORMATS}


def test_there_are_forty_six():
    """As many as the paper's anti-patterns have in all formats."""
    assert len(SYMPTOMS) == 46


@pytest.mark.parametrize(
    ("form", "symptom"),
    [(form, f"AP{number}") for form, numbers in AVOIDABLE.items() for number in numbers.split()],
)
def test_a_format_has_a_rule_for_what_its_authors_could_avoid(form, symptom):
    """Rules that find the symptom in composable models alone do not help there."""
    assert [rule for rule in RULES if symptom in rule.symptoms and form in rule.formats]


@pytest.mark.parametrize("symptom", SYMPTOMS)
def test_a_symptom_is_found_by_a_rule_or_comes_with_a_format(symptom):
    """A rule that finds it witnesses the anti-pattern that the symptom is of."""
    found = [rule for rule in RULES if symptom in rule.symptoms]
    inherent = [form for form in FORMATS if symptom in INHERENT[form]]

    assert found or inherent
    for rule in found:
        assert symptom.split(".")[0] in rule.antipatterns


def test_names_exist():
    """A number nobody explains would be none."""
    assert {each for rule in RULES for each in rule.symptoms} <= SYMPTOMS.keys()
    assert {each for numbers in INHERENT.values() for each in numbers} <= SYMPTOMS.keys()


def test_the_table_names_the_rules_of_each_symptom_by_format():
    """A row for each, with codes, and a word for what comes with the format."""
    head, _, *rows = symptom_table(RULES)

    assert (
        head
        == "| Symptom | Description | JSON-LD | URDF | SDF | MJCF | COLLADA | USD | SRDF | YAML |"
    )
    assert len(rows) == len(SYMPTOMS)
    for row, symptom in zip(rows, SYMPTOMS, strict=True):
        cells = [cell.strip() for cell in row.strip("|").split("|")]
        assert cells[0] == symptom
        assert any(cells[2:])
        for form, cell in zip(FORMATS, cells[2:], strict=True):
            assert re.fullmatch(r"(([A-Z]+\d{3}|\*inherent\*)(, |$))*", cell)
            assert ("*inherent*" in cell) == (symptom in INHERENT[form])
