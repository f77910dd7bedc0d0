"""Which fixes are wanted, and how far they are trusted, is chosen by selectors like rules."""

from dataclasses import replace

import pytest

from kinlint.configuration.config_file import parse_config
from kinlint.configuration.fix_trust import combine_trust
from kinlint.configuration.selection import Policies
from kinlint.configuration.selectors import Catalogue
from kinlint.configuration.settings import Choice, FileSettings, Settings
from kinlint.errors import ConfigError, UsageError
from kinlint.finding import Fix
from kinlint.rule import Applicability, Rule, Severity

DISPLAY, UNSAFE, SAFE = Applicability


def rule(code, name, *tags):
    return Rule(
        f"https://w3id.org/kinlint/rules/{name}", code, name, name, "", Severity.ERROR, tags
    )


RULES = (
    rule("UNI001", "missing-unit", "AP5"),
    rule("UNI002", "unit-quantity-mismatch", "AP5"),
    rule("LD001", "dropped-term"),
)
UNI001, UNI002, LD001 = RULES


def mended(*choices):
    said = combine_trust(choices, Catalogue(RULES))
    return {one.code for one in RULES if said.allows_fixes(one)}


def counts(proven, *choices):
    return combine_trust(choices, Catalogue(RULES)).applicability(UNI001, proven)


def test_without_a_choice_every_fix_is_wanted_as_it_is():
    """What was proven is what counts."""
    assert mended() == {"UNI001", "UNI002", "LD001"}
    assert [counts(one) for one in Applicability] == list(Applicability)


@pytest.mark.parametrize(
    ("fixable", "unfixable", "codes"),
    [
        (("UNI",), (), {"UNI001", "UNI002"}),
        (None, ("AP5",), {"LD001"}),
        (("ALL",), ("missing-unit",), {"UNI002", "LD001"}),
        (("UNI001",), ("UNI",), {"UNI001"}),
        (("UNI001",), ("UNI001",), set()),
        ((), (), set()),
    ],
)
def test_the_more_specific_selector_wins(fixable, unfixable, codes):
    """As for rules: of equals, the one that refuses."""
    assert mended(Choice(fixable=fixable, unfixable=unfixable)) == codes


def test_a_higher_layer_replaces_or_changes_what_a_lower_one_wanted():
    """`fixable` replaces, `unfixable` takes away."""
    below = Choice(fixable=("UNI",))
    assert mended(below, Choice(fixable=("LD",))) == {"LD001"}
    assert mended(below, Choice(unfixable=("UNI002",))) == {"UNI001"}


@pytest.mark.parametrize(
    ("proven", "choice", "counted"),
    [
        (UNSAFE, Choice(extend_safe_fixes=("UNI",)), SAFE),
        (SAFE, Choice(extend_unsafe_fixes=("UNI",)), UNSAFE),
        (DISPLAY, Choice(extend_safe_fixes=("UNI",)), DISPLAY),
        (SAFE, Choice(extend_safe_fixes=("UNI",), extend_unsafe_fixes=("UNI",)), UNSAFE),
        (UNSAFE, Choice(extend_safe_fixes=("UNI001",), extend_unsafe_fixes=("UNI",)), SAFE),
        (SAFE, Choice(extend_unsafe_fixes=("LD",)), SAFE),
    ],
)
def test_what_a_fix_counts_as_can_be_said(proven, choice, counted):
    """But what is only shown stays so; of equals, the careful one wins."""
    assert counts(proven, choice) is counted


def test_a_higher_layer_may_trust_again():
    """The command line of a project over the base that it extends."""
    careful, trusting = Choice(extend_unsafe_fixes=("ALL",)), Choice(extend_safe_fixes=("UNI",))
    assert counts(SAFE, careful, trusting) is SAFE
    assert counts(SAFE, trusting, careful) is UNSAFE


def test_a_fix_that_is_not_safe_here_says_why():
    """The reason that it has, or that the configuration says so."""
    careful = combine_trust([Choice(extend_unsafe_fixes=("UNI",))], Catalogue(RULES))
    trusting = combine_trust([Choice(extend_safe_fixes=("UNI",))], Catalogue(RULES))
    guess, sure = Fix("Do it", UNSAFE, (), "", "It guesses."), Fix("Do it", SAFE, (), "")

    assert careful.weighed_fix(UNI001, guess) is guess
    assert trusting.weighed_fix(UNI001, guess) == sure
    assert careful.weighed_fix(UNI001, sure).applicability is UNSAFE
    assert careful.weighed_fix(UNI001, sure).why == "the configuration calls it unsafe"
    assert careful.weighed_fix(LD001, sure) is sure


def test_each_file_has_its_own_trust():
    """As the configuration nearest to it says."""
    there = FileSettings(choices=(Choice(unfixable=("UNI",)),))
    policies = Policies(Settings(files={"b.jsonld": there}), RULES)

    assert policies.trust("a.jsonld").allows_fixes(UNI001)
    assert not policies.trust("b.jsonld").allows_fixes(UNI001)
    assert policies.trust("b.jsonld").allows_fixes(LD001)


@pytest.mark.parametrize(
    "name", ["fixable", "unfixable", "extend_safe_fixes", "extend_unsafe_fixes"]
)
def test_a_selector_that_names_nothing_is_a_mistake(name):
    """Found before any work, with a suggestion."""
    choice = replace(Choice(origin="kinlint.toml"), **{name: ("UNI01",)})
    policies = Policies(Settings(default=FileSettings(choices=(choice,))), RULES)

    with pytest.raises(UsageError, match=r"kinlint.toml: unknown rule selector 'UNI01'"):
        policies.check_selectors()


def test_a_configuration_says_it_all(tmp_path):
    """`unsafe-fixes` holds for the run, the rest for files."""
    said = {
        "fixable": ["UNI"],
        "unfixable": ["LD001"],
        "extend-safe-fixes": ["UNI001"],
        "extend-unsafe-fixes": ["UNI002"],
        "unsafe-fixes": True,
    }
    config = parse_config(said, "kinlint.toml", tmp_path)

    (choice,) = config.choices
    assert (choice.fixable, choice.unfixable) == (("UNI",), ("LD001",))
    assert (choice.extend_safe_fixes, choice.extend_unsafe_fixes) == (("UNI001",), ("UNI002",))
    assert config.unsafe_fixes is True
    with pytest.raises(ConfigError, match=r"unsafe-fixes: expected true or false"):
        parse_config({"unsafe-fixes": "yes"}, "kinlint.toml", tmp_path)
