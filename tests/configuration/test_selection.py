"""Selectors choose rules: the specific ones over the general ones, ignoring over choosing."""

import pytest

from kinlint.configuration.selection import Policies, combine_policy
from kinlint.configuration.selectors import Catalogue
from kinlint.configuration.settings import Choice, FileSettings, Ignore, Settings
from kinlint.errors import UsageError
from kinlint.finding import Finding
from kinlint.rule import Rule, Severity
from kinlint.text import Location, SourceText, Span

W = Severity.WARNING


def rule(code, name, *tags, severity=Severity.ERROR):
    return Rule(f"https://w3id.org/kinlint/rules/{name}", code, name, name, "", severity, tags)


RULES = (
    rule("UNI001", "missing-unit", "AP5", "AP6"),
    rule("UNI002", "unit-quantity-mismatch", "AP5"),
    rule("UNX001", "unused-thing"),
    rule("LD001", "dropped-term", "AP5", severity=W),
)
CODES = {one.code for one in RULES}


def chosen(*choices):
    severities = combine_policy(choices, Catalogue(RULES)).severities
    return {code for code, severity in severities.items() if severity is not None}


@pytest.mark.parametrize(
    ("selector", "codes"),
    [
        ("ALL", CODES),
        ("UNI002", {"UNI002"}),
        ("unit-quantity-mismatch", {"UNI002"}),
        ("UNI", {"UNI001", "UNI002"}),
        ("UNI00", {"UNI001", "UNI002"}),
        ("U", {"UNI001", "UNI002", "UNX001"}),
        ("AP6", {"UNI001"}),
        ("AP1", set()),
    ],
)
def test_what_a_selector_names(selector, codes):
    """Codes, names, beginnings of codes, anti-patterns and ALL."""
    assert chosen(Choice(select=(selector,))) == codes


@pytest.mark.parametrize(
    ("select", "ignore", "codes"),
    [
        (("ALL",), ("UNI",), {"UNX001", "LD001"}),
        (("UNI002",), ("UNI",), {"UNI002"}),
        (("UNI",), ("UNI002",), {"UNI001"}),
        (("UNI",), ("U",), {"UNI001", "UNI002"}),
        (("UNI",), ("AP6",), {"UNI002"}),
        (("AP6",), ("UNI",), set()),
        (("AP5",), ("ALL",), {"UNI001", "UNI002", "LD001"}),
        (("UNI002",), ("unit-quantity-mismatch",), set()),
        (("UNI00",), ("AP5",), {"UNI001", "UNI002"}),
        (("unused-thing", "UNI001"), ("UNI0",), {"UNX001", "UNI001"}),
    ],
)
def test_the_more_specific_selector_wins(select, ignore, codes):
    """Code over beginning over family and tag over ALL; of equals, ignoring."""
    assert chosen(Choice(select=select, ignore=ignore)) == codes


def test_without_a_choice_all_rules_speak():
    """The default is everything."""
    assert chosen() == CODES


def test_a_higher_layer_replaces_or_changes_what_a_lower_one_chose():
    """`select` replaces; `extend_select` and `ignore` alone change."""
    below = Choice(select=("UNI",))

    assert chosen(below, Choice(select=("LD001",))) == {"LD001"}
    assert chosen(below, Choice(extend_select=("LD001",))) == {"UNI001", "UNI002", "LD001"}
    assert chosen(below, Choice(ignore=("UNI",))) == set()
    assert chosen(Choice(ignore=("UNI002",)), Choice(select=("UNI",))) == {"UNI001", "UNI002"}


def test_severities_are_overridden_by_the_more_specific_selector():
    """Whatever their order; a higher layer beats a lower one."""
    severity = (("UNI002", Severity.ERROR), ("UNI", Severity.INFO))

    made = combine_policy((Choice(severity=severity),), Catalogue(RULES))
    over = combine_policy(
        (Choice(severity=severity), Choice(severity=(("ALL", W),))), Catalogue(RULES)
    )

    assert made.severity(RULES[0]) is Severity.INFO
    assert made.severity(RULES[1]) is Severity.ERROR
    assert made.severity(RULES[3]) is W
    assert over.severity(RULES[1]) is W


def test_a_rule_nobody_heard_of_speaks():
    """What an engine reports beside the catalogue is not lost."""
    stranger = rule("ZZZ001", "stranger")

    assert (
        combine_policy((Choice(select=("UNI",)),), Catalogue(RULES)).severity(stranger) is not None
    )


@pytest.mark.parametrize(
    ("selector", "suggestion"),
    [("UNI0022", "UNI002"), ("mising-unit", "missing-unit"), ("AP7", "AP"), ("al", "ALL")],
)
def test_an_unknown_selector_is_an_error_with_a_suggestion(selector, suggestion):
    """It is never taken for a selector of nothing."""
    with pytest.raises(UsageError, match=f"unknown rule selector '{selector}', .*{suggestion}"):
        chosen(Choice(ignore=(selector,)))


def test_an_unknown_selector_tells_where_it_was_written():
    """The origin of the layer or of the entry is in the message."""
    settings = Settings(default=FileSettings((Choice("kinlint.toml", ignore=("ZZZ",)),)))
    entry = Settings(default=FileSettings(ignores=(Ignore(("ZZZ",), "a.json", "kinlint.toml"),)))

    with pytest.raises(UsageError, match=r"^kinlint\.toml: unknown"):
        Policies(settings, RULES).check_selectors()
    with pytest.raises(UsageError, match=r"^kinlint\.toml: a\.json: unknown"):
        Policies(entry, RULES).check_selectors()


def test_each_file_has_its_own_policy():
    """A finding is judged by the settings of the file that it lies in."""
    quiet = FileSettings((Choice(ignore=("UNI001",)),))
    policies = Policies(Settings(files={"a.jsonld": quiet}), RULES)

    def found(name):
        location = Location(SourceText(name, "{}"), Span(0, 1))
        return Finding(RULES[0], Severity.ERROR, "", location, "", "_:b")

    assert policies.apply_severities([found("a.jsonld")]) == []
    assert [one.severity for one in policies.apply_severities([found("b.jsonld")])] == [
        Severity.ERROR
    ]
    assert policies.enabled(["a.jsonld"]) == CODES - {"UNI001"}
    assert policies.enabled(["a.jsonld", "b.jsonld"]) == CODES
    assert policies.enabled([]) == set()


@pytest.mark.parametrize(
    ("choices", "severity"),
    [((), W), ((Choice(severity=(("UNI001", Severity.INFO),)),), Severity.INFO)],
)
def test_what_a_constraint_counts_as_holds_until_somebody_says_otherwise(choices, severity):
    """A constraint of a rule may be milder than the rule is."""
    policies = Policies(Settings(default=FileSettings(choices)), RULES)
    place = Location(SourceText("a.jsonld", "{}"), Span(0, 1))
    mild = Finding(next(rule for rule in RULES if rule.code == "UNI001"), W, "", place, "", "_:b")

    assert [one.severity for one in policies.apply_severities([mild])] == [severity]
