"""`kinlint rules`: one line for each rule."""

import pytest

from kinlint.catalogue import rulebook


def listed(out):
    """The codes of the lines."""
    return [line.split()[0] for line in out.splitlines()]


def test_every_rule_has_a_line(kinlint):
    """Code, severity, name and title, in the order of the codes."""
    code, out, err = kinlint("rules")
    rules = rulebook.load().rules

    assert (code, err) == (0, "")
    assert listed(out) == sorted(rule.code for rule in rules)
    (line,) = (line for line in out.splitlines() if line.startswith("LIM001 "))
    assert line.split(None, 3)[1:3] == ["error", "inverted-limit"]
    assert line.endswith("lower limit above upper limit")


@pytest.mark.parametrize(
    ("options", "inside", "outside"),
    [
        (("--family", "topology"), "TOP001", "LIM001"),
        (("--family", "TOP"), "TOP001", "LIM001"),
        (("topology",), "TOP001", "LIM001"),
        (("--format", "srdf"), "CMP004", "TOP001"),
        (("--format", "jsonld"), "LIM001", "SRC001"),
        (("--severity", "info"), "LIM015", "LIM001"),
        (("--severity", "note"), "LIM015", "LIM001"),
        (("LIM", "--severity", "error"), "LIM001", "LIM015"),
    ],
)
def test_rules_are_chosen(kinlint, options, inside, outside):
    """By family, format and severity."""
    code, out, _ = kinlint("rules", *options)

    assert code == 0
    assert inside in listed(out)
    assert outside not in listed(out)


@pytest.mark.slow
def test_a_family_is_a_selector_by_its_name(kinlint):
    """In `rule` and in `--select`."""
    assert kinlint("rule", "limits")[1] == kinlint("rule", "LIM")[1]
    assert kinlint("rule", "limts") == (
        2,
        "",
        "kinlint: error: unknown rule selector 'limts', did you mean 'limits'?\n",
    )


def test_a_wrong_choice_gets_a_suggestion(kinlint):
    """In one line."""
    assert kinlint("rules", "--format", "urfd")[2].endswith("did you mean 'urdf'?\n")


def test_a_page_begins_with_examples_in_urdf(kinlint):
    """Most people know it; those in graphs come last."""
    page = kinlint("rule", "LIM001", "--full")[1]
    assert page.index('<robot name="arm">') < page.index("<sdf") < page.index("#usda")
    assert page.index("#usda") < page.index('"@context"')
