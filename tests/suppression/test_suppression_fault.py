"""What is reported of suppressions: unused, unknown, without a reason, past their end."""

import pytest
from suppressing import ARM, DROPPED, LEG, UNIT, applied, document, finding, kl, noted, told

from kinlint.configuration.selection import Policies
from kinlint.configuration.settings import Choice, FileSettings, Settings
from kinlint.rule import Severity
from kinlint.suppression import suppress
from kinlint.terms import iri, literal
from kinlint.text import Span


@pytest.mark.parametrize(
    ("until", "codes"), [("2026-06-01", ["-UNI001"]), ("2026-07-01", ["-UNI001"])]
)
def test_a_suppression_lasts_to_the_end_of_its_day(until, codes):
    """The day that `kl:until` names still counts."""
    assert told(applied([finding(UNIT)], [noted(("until", until))])) == codes


@pytest.mark.parametrize(
    ("until", "message"),
    [("2026-05-31", "'UNI001' ended '2026-05-31'."), ("soon", "'soon' is odd.")],
)
def test_an_expired_suppression_silences_nothing(until, message):
    """It is reported at what names the rule; what is no date is over."""
    outcome = applied([finding(UNIT)], [noted(("until", until))])

    assert told(outcome) == ["UNI001", "LNT004"]
    assert outcome[1].message == message
    assert outcome[1].location.span == Span(1, 2)


def test_an_unused_suppression_is_reported_at_its_value():
    """With the node, the property and the value, and the arguments of its message."""
    outcome = applied([], [document((ARM, kl("ignore"), literal("UNI001")))])

    assert told(outcome) == ["LNT001"]
    assert outcome[0].message == "The suppression of 'UNI001' silences nothing."
    assert outcome[0].arguments == ("UNI001",)
    assert outcome[0].location.span == Span(0, 1)
    assert (outcome[0].focus, outcome[0].path) == (ARM, kl("ignore"))


@pytest.mark.parametrize("settings", [{"complete": False}, {"partial": True}])
def test_nothing_is_called_unused_where_not_everything_is_known(settings):
    """What could not be read, or is elsewhere, may be what the suppression is for."""
    given = document((ARM, kl("ignore"), literal("UNI001")))

    assert told(applied([], [given], **settings)) == []


def test_a_suppression_of_a_rule_that_was_not_asked_is_not_unused():
    """`--select` must not make suppressions look superfluous."""
    default = FileSettings((Choice(select=("LD001", "LNT")),))
    given = document((ARM, kl("ignore"), literal("UNI001")))

    assert told(applied([], [given], default=default)) == []


@pytest.mark.parametrize(
    ("value", "message"),
    [
        (literal("UNI01"), "No rule is called 'UNI01', the nearest is 'UNI001'."),
        (literal("zebra"), "No rule is called 'zebra'."),
        (literal(""), "This suppression names no rule."),
        (iri("https://example.org/x"), "No rule is called 'https://example.org/x'."),
        ("_:empty", "This suppression names no rule."),
    ],
)
def test_an_unknown_rule_is_reported(value, message):
    """With the nearest known one, if one is near."""
    outcome = applied([finding(UNIT)], [document((ARM, kl("ignore"), value))])

    assert told(outcome) == ["UNI001", "LNT002"]
    assert outcome[1].message == message


def test_a_missing_reason_is_reported_where_reasons_are_required():
    """And the finding is silent all the same."""
    strict = FileSettings(require_reason=True)
    bare = document((ARM, kl("ignore"), literal("UNI001")))

    assert told(applied([finding(UNIT)], [bare], default=strict)) == ["-UNI001", "LNT003"]
    assert told(applied([finding(UNIT)], [bare])) == ["-UNI001"]
    assert told(applied([finding(UNIT)], [noted(("reason", "x"))], default=strict)) == ["-UNI001"]


def test_findings_about_suppressions_can_be_silenced_in_turn():
    """By a suppression that is then not unused itself."""
    given = document((ARM, kl("ignore"), literal("LNT001")), (ARM, kl("ignore"), literal("UNI001")))

    assert told(applied([], [given])) == ["-LNT001"]


def test_no_suppression_silences_what_is_said_of_itself():
    """Otherwise ALL would never be unused."""
    assert told(applied([], [document((ARM, kl("ignore"), literal("ALL")))])) == ["LNT001"]


def test_rules_about_suppressions_are_selected_as_all_are():
    """And their severity is overridden as all are."""
    given = document((ARM, kl("ignore"), literal("UNI001")))
    off = FileSettings((Choice(ignore=("LNT",)),))
    loud = FileSettings((Choice(severity=(("LNT001", Severity.ERROR),)),))

    assert told(applied([], [given], default=off)) == []
    assert [one.severity for one in applied([], [given], default=loud)] == [Severity.ERROR]


def test_a_catalogue_without_these_rules_says_nothing_of_suppressions():
    """They work all the same."""
    given = document((ARM, kl("ignore"), literal("UNI001")), (LEG, kl("ignore"), literal("LD001")))
    policies = Policies(Settings(), (UNIT, DROPPED))

    assert told(suppress.apply_suppressions([finding(UNIT)], [given], policies)) == ["-UNI001"]
