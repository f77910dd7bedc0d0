"""What is found in a file, and how it may be fixed, does not depend on what is linted beside it."""

import re

import pytest
from support.linting import book

from kinlint.configuration.settings import Choice, FileSettings, Settings
from kinlint.fixes.rounds import lint_texts
from kinlint.formats.records import BY_NAME
from kinlint.rule_testing.example_texts import FORMATS, unmarked
from kinlint.text import SourceText

pytestmark = pytest.mark.slow

NAME = re.compile(r'(<(?:robot|model|mujoco|COLLADA|world)\b[^>]*?\b(?:name|model)=")[^"]*(")')
"""The name of a robot, by which descriptions of one robot are compared."""


def _repaired():
    for rule in book().rules:
        for number, each in enumerate(rule.examples):
            alone = each.bad is not None and not each.companions and not each.beside
            if alone and rule.repairs and BY_NAME[each.format].is_tree:
                yield pytest.param(rule.code, each, id=f"{rule.code}-{number}")


def _told(code, suffix, *texts):
    """What is said of the first of *texts*, beside the others; blank nodes are called anyhow."""
    sources = [SourceText(f"file{number}{suffix}", text) for number, text in enumerate(texts)]
    settings = Settings(default=FileSettings((Choice(select=(code,)),)))
    found = lint_texts(sources, (), settings, book()).report.findings
    return [
        (
            each.message,
            each.location.span,
            [(f.title, f.applicability, f.edits, f.update) for f in each.fixes],
        )
        for each in found
        if each.location.source.name == sources[0].name
    ]


@pytest.mark.parametrize(("code", "example"), [*_repaired()])
def test_a_bad_example_is_told_and_fixed_as_alone(code, example):
    """Beside another robot with the same names, bad, good and fixed."""
    bad, _ = unmarked(example.bad)
    suffix = FORMATS[example.format].suffixes[0]
    alone = _told(code, suffix, bad)
    for text in filter(None, (bad, example.good, example.fixed)):
        other = NAME.sub(r"\1another_one\2", text, count=1)
        assert _told(code, suffix, bad, other) == alone
