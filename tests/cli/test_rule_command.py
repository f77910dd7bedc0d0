"""`kinlint rule` and `kinlint test-rules`."""

import json
import textwrap

import pytest
from pipeline import BOOK, RULES

from kinlint.cli import test_rules_command
from kinlint.light_dataclasses import replace
from kinlint.rule import Applicability, Example, Repair


@pytest.fixture(autouse=True)
def book(monkeypatch):
    """A small catalogue."""
    monkeypatch.setattr("kinlint.catalogue.rulebook.load", lambda *_: BOOK)


@pytest.mark.parametrize("word", ["UNI002", "unit-quantity-mismatch"])
def test_a_rule_is_explained_by_code_and_by_name(kinlint, word):
    """As text for a terminal, unless told otherwise."""
    code, out, err = kinlint("rule", word)

    assert (code, err) == (0, "")
    assert out.startswith("UNI002 unit-quantity-mismatch: unit-quantity-mismatch is at fault\n")
    assert "\x1b[" not in out


def test_an_antipattern_is_said_before_its_rules(kinlint):
    """In a sentence; a single rule needs none."""
    out = kinlint("rule", "AP5")[1]

    assert out.startswith("AP5 incomplete metamodel. What a term means, requires or permits is not")
    assert "\n\nUNI002 " in out
    assert "What a term means" not in kinlint("rule", "UNI002")[1]


def test_a_rule_in_markdown(kinlint):
    """With a heading."""
    assert kinlint("rule", "LD001", "--output-format", "markdown")[1].startswith("# LD001 ")


def test_all_rules_in_markdown(kinlint):
    """Are one page."""
    out = kinlint("rule", "--all", "--output-format", "markdown")[1]

    assert out.count("\n# ") == 0
    assert out.startswith("# The rules of kinlint\n")
    assert all(f"\n## {rule.code} {rule.name}\n" in out for rule in RULES)


def test_one_rule_is_an_object_and_several_are_an_array(kinlint):
    """In JSON; several by their code, by a beginning, or all."""

    def codes(*arguments):
        return [one["code"] for one in json.loads(kinlint("rule", *arguments)[1])]

    form = ("--output-format", "json")

    assert json.loads(kinlint("rule", "LD001", *form)[1])["name"] == "dropped-term"
    assert codes("LD001", "UNI001", *form) == ["UNI001", "LD001"]
    assert codes("UNI", *form) == ["UNI001", "UNI002"]
    assert codes("--all", *form) == [rule.code for rule in RULES]


def test_all_rules_as_text(kinlint):
    """One page after the other."""
    out = kinlint("rule", "--all")[1]

    assert [rule.code for rule in RULES if f"{rule.code} {rule.name}: " in out] == [
        rule.code for rule in RULES
    ]


def test_a_rule_on_one_screen(monkeypatch, kinlint):
    """One example, as far as it shows the fault, and no query; all of it with --full."""
    filler = "".join(f'  <link name="l{n}"/>\n' for n in range(20))
    robot = '<robot name="r">\n{}  <joint name="{}">\n    <parent link="{}"/>\n  </joint>\n</robot>'
    bad = robot.format(filler, "a", "[|missing|]")
    pairs = [Example("urdf", bad, robot.format(filler, "a", "l1"))] * 2
    repair = Repair("Use '{?near}'", Applicability.UNSAFE, "DELETE { } WHERE { }", "", (), (), ())
    rule = replace(RULES[0], examples=pairs, repairs=[repair])
    monkeypatch.setattr("kinlint.catalogue.rulebook.load", lambda *_: replace(BOOK, rules=[rule]))
    out = kinlint("rule", rule.code)[1]
    shown = out.partition("Bad:\n\n")[2].partition("\n\nFix: Use ... (unsafe")[0]
    assert textwrap.dedent(shown) == textwrap.dedent("""\
            ...
            <joint name="a">
              <parent link="missing"/>
                            ^^^^^^^
            </joint>
            ...

        Good:

            ...
            <joint name="a">
              <parent link="l1"/>
            </joint>
            ...""")
    assert "DELETE" not in out
    assert out.endswith(f"kinlint rule {rule.code} --full\n")
    full = kinlint("rule", rule.code, "--full")[1]
    assert (full.count("Bad:"), full.count("DELETE"), full.count("l19")) == (2, 1, 4)


def test_format_is_short_for_output_format(kinlint):
    """With a word of its own or with an equals sign."""
    for form in (["--format", "json"], ["--format=json"]):
        assert json.loads(kinlint("rule", "LD001", *form)[1])["code"] == "LD001"


def test_color_for_a_rule(kinlint):
    """If it is wanted."""
    assert "\x1b[" in kinlint("rule", "LD001", "--color", "always")[1]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ([], "name a rule, such as UNI002; kinlint rules lists them"),
        (["UNI02"], "unknown rule selector 'UNI02', did you mean 'UNI002'?"),
        (["LD001", "--output-format", "txt"], "did you mean 'text'?"),
        (["UNI002", "--all"], "--all is every rule, 'UNI002' among them: give one of both"),
        (["--al"], "unknown option '--al', did you mean '--all'?"),
    ],
)
def test_mistakes(kinlint, arguments, message):
    """One line, exit code 2."""
    code, out, err = kinlint("rule", *arguments)

    assert (code, out) == (2, "")
    assert message in err


@pytest.mark.slow
def test_rules_that_keep_their_promises(kinlint, monkeypatch):
    """Exit code 0, and how many there are."""
    monkeypatch.setattr(test_rules_command.rule_conformance, "failures", lambda *_: iter(()))

    assert kinlint("test-rules") == (0, "4 rules with 0 examples: all keep their promises.\n", "")
    assert kinlint("test-rules", "-q") == (0, "", "")


def test_rules_that_do_not(kinlint, monkeypatch):
    """Exit code 1, and a line for each broken promise."""

    def failures(rule, _):
        return iter(["it has no example", "x"] if rule.code == "LD001" else [])

    monkeypatch.setattr(test_rules_command.rule_conformance, "failures", failures)

    code, out, err = kinlint("test-rules")

    assert (code, err) == (1, "")
    assert out.splitlines() == [
        "LD001 dropped-term: it has no example",
        "LD001 dropped-term: x",
        "4 rules with 0 examples: 1 of them fail.",
    ]


@pytest.mark.slow
def test_rules_of_a_directory(kinlint, monkeypatch, here):
    """Those alone; none is an error."""
    (here / "mine").mkdir()
    monkeypatch.setattr(test_rules_command.rule_conformance, "failures", lambda *_: iter(()))

    assert kinlint("test-rules", "rules")[1].startswith("4 rules ")
    assert kinlint("test-rules", "mine") == (2, "", "kinlint: error: no rules found in mine\n")
