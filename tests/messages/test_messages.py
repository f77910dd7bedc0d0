"""What the readers of robots complain of is found, or it is said why not.

A table `<reader>.tsv` has a line for each kind of message that the reader has for a defect in a
file: the message in our words, the rule that finds the defect, a file that has it, and the reason
where no rule does. A file is written out; several that belong together have ` & ` between.
"""

import csv
from functools import cache
from pathlib import Path

import pytest
from support.linting import book, lint

from kinlint.configuration.settings import Choice, FileSettings
from kinlint.formats.records import BY_NAME
from kinlint.formats.registry import decode
from kinlint.formats.xml.xml_recognition import recognise_xml

pytestmark = [pytest.mark.corpus, pytest.mark.xdist_group("messages")]

TABLES = sorted(Path(__file__).parent.glob("*.tsv"))
COLUMNS = ["message", "rule", "example", "reason"]
NONE = "-"
BETWEEN = " & "


def lines(table):
    with table.open(encoding="utf-8", newline="") as text:
        return list(csv.DictReader(text, delimiter="\t", quoting=csv.QUOTE_NONE))


EVERY = [(table.stem, line) for table in TABLES for line in lines(table)]
FOUND = [(reader, line) for reader, line in EVERY if line["rule"] != NONE]


def chosen():
    """All rules, for all targets that any is about."""
    said = (
        rule.targets + sum((each.targets for each in rule.severity_for), ())
        for rule in book().rules
    )
    targets = tuple(sorted({target for each in said for target in each}))
    return FileSettings(choices=(Choice(select=("ALL",)),), targets=targets)


def sources(number, example):
    """The files of an example, in a folder of their own."""
    for part in example.split(BETWEEN):
        form = recognise_xml(part) or BY_NAME["urdf"]
        yield decode(f"{number}/robot{form.suffixes[0]}", part.encode())


@cache
def found():
    """The codes of what is found in each example, by its number in `FOUND`.

    Those of one file are linted in one run: each is a model of its own.
    """
    codes = {number: set() for number in range(len(FOUND))}
    examples = [
        (number, list(sources(number, line["example"]))) for number, (_, line) in enumerate(FOUND)
    ]
    together = [source for _, files in examples if len(files) == 1 for source in files]
    for run in (together, *(files for _, files in examples if len(files) > 1)):
        for finding in lint(run, default=chosen()).with_consequences().findings:
            codes[int(finding.location.source.name.split("/")[0])].add(finding.rule.code)
    return codes


@pytest.mark.parametrize("table", TABLES, ids=lambda table: table.stem)
def test_a_table_has_a_line_for_each_message_and_no_message_twice(table):
    """Columns are those announced; messages tell lines apart."""
    header = table.read_text("utf-8").splitlines()[0].split("\t")
    messages = [line["message"] for line in lines(table)]
    assert header == COLUMNS
    assert len(set(messages)) == len(messages)


@pytest.mark.parametrize(
    ("reader", "line"), EVERY, ids=[f"{reader}-{line['message']}" for reader, line in EVERY]
)
def test_a_line_names_a_rule_with_an_example_or_says_why_not(reader, line):
    """Either, never both."""
    known = {rule.code for rule in book().rules}
    assert all(value is not None for value in line.values())
    assert (line["rule"] in known) == bool(line["example"])
    assert (line["rule"] == NONE) == bool(line["reason"])


@pytest.mark.parametrize(
    "number", range(len(FOUND)), ids=[f"{reader}-{line['message']}" for reader, line in FOUND]
)
def test_the_rule_finds_the_defect(number):
    """The example of a message is found broken by the rule of that message."""
    assert FOUND[number][1]["rule"] in found()[number]
