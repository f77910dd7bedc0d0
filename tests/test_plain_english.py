"""Messages, titles and help are in the plain technical English of the field."""

import re
from importlib import import_module

import pytest
from support.linting import book

from kinlint.cli.commands import COMMANDS
from kinlint.cli.overview import page
from kinlint.configuration.keys import KEYS
from kinlint.reporters.antipatterns import ANTIPATTERNS
from kinlint.reporters.symptoms import SYMPTOMS

ARCHAIC = re.compile(
    r"""\b(?:
        mend(?:s|ed|ing)? | judge[sd]? | judging | hangs? | bears? | lies | nobody | hence
        | tells | told | stands | stood | forget | anew | in\ vain | passe[sd]\ over
        | (?:is|are|was|be)\ no(?!\ longer)
    )\b""",
    re.VERBOSE | re.IGNORECASE,
)
"""Words that a robotics engineer would not use here, and negated nouns ("is no unit")."""
CLAUSE = re.compile(r"^What\b(?!.*\?)")
"""A clause in the place of a noun: "What is not known there"."""
COUNTS = re.compile(r"\w+: '?\{\?(?:count|number|n)\}'?\.?$")
"""A count as a fragment at the end: "Links like it: '1'."."""
EXISTENTIAL = re.compile(r"\bthere (?:is|are) no\b", re.IGNORECASE)
"""Plain English all the same."""


def rule_texts():
    """The titles, messages and fixes of all rules."""
    for rule in book().rules:
        yield f"{rule.code} title", rule.title
        for number, message in enumerate(rule.messages):
            yield f"{rule.code} message {number}", message
        for repair in rule.repairs:
            yield f"{rule.code} fix", repair.title


def help_texts():
    """The help of all commands and their options, and what the configuration says."""
    yield "kinlint --help", page(COMMANDS)
    for name, (module, about) in COMMANDS.items():
        parser = import_module(module).parser()
        yield f"kinlint {name}", about
        yield f"kinlint {name} --help", parser.description or ""
        for action in parser.actions:
            yield f"kinlint {name} {action.dest}", action.help or ""
    for name, key in KEYS.items():
        yield f"kinlint config {name}", f"{key.meaning} {key.default}"
    yield from SYMPTOMS.items()
    for pattern in ANTIPATTERNS:
        yield pattern.id, f"{pattern.name}. {pattern.description}"


@pytest.mark.parametrize("texts", [rule_texts, help_texts])
def test_the_words_are_those_of_the_field(texts):
    """Neither archaic verbs nor negated nouns, clauses as subjects or counts as fragments."""
    faults = [
        f"{place}: {text}"
        for place, text in texts()
        if ARCHAIC.search(EXISTENTIAL.sub("", text)) or CLAUSE.search(text) or COUNTS.search(text)
    ]

    assert faults == []


@pytest.mark.parametrize(
    "text",
    [
        "'MM' is no unit: kinlint's tables do not list it.",
        "Link 'base' hangs on no joint.",
        "Findings that nobody knows.",
        "What is found is mended.",
        "What standard input is called",
        "Links like it: '{?count}'.",
    ],
)
def test_the_test_knows_the_habits(text):
    """It would find them."""
    assert ARCHAIC.search(text) or CLAUSE.search(text) or COUNTS.search(text)


@pytest.mark.parametrize("text", ["There is no root link.", "'MM' is not a unit.", "Is it known?"])
def test_the_test_spares_plain_english(text):
    """And nothing else."""
    assert not ARCHAIC.search(EXISTENTIAL.sub("", text))
    assert not CLAUSE.search(text)
