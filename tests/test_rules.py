"""Every rule keeps the promises its own file makes."""

from pathlib import Path

import pytest

from kinlint import resources, rule_test, rulebook

BOOK = rulebook.load()


@pytest.mark.parametrize("rule", BOOK.rules, ids=lambda rule: rule.name)
def test_a_rule_keeps_its_promises(rule):
    """Bad examples are found where marked, good ones left alone, the file has the right form."""
    assert list(rule_test.failures(rule, BOOK)) == []


def test_every_rule_file_is_one_rule():
    """The catalogue has one rule for each file, called as the file is."""
    files = sorted(resources.data("rules").rglob("*.ttl"))

    assert sorted(Path(rule.path).stem for rule in BOOK.rules) == sorted(f.stem for f in files)


def test_marks_are_taken_out_and_remembered():
    """`[|…|]` marks leave their content, and its place."""
    text, spans = rule_test.unmarked('{"a": [|1|], "b": [[|"x"|]]}')

    assert text == '{"a": 1, "b": ["x"]}'
    assert [text[span.start : span.end] for span in spans] == ["1", '"x"']
