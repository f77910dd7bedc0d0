"""A rule may be about some consumers of robots, and count as worse for some of them."""

import json

import pytest

from kinlint.catalogue.rule_file import read_rules
from kinlint.configuration.selection import Policies, combine_policy
from kinlint.configuration.selectors import Catalogue
from kinlint.configuration.settings import Choice, FileSettings, Settings
from kinlint.errors import UsageError
from kinlint.reporters import rule_page
from kinlint.rule import Rule, Severity, SeverityFor

WARNING, ERROR, INFO = Severity.WARNING, Severity.ERROR, Severity.INFO


def rule(code, severity=INFO, **more):
    name = code.lower()
    return Rule(f"https://w3id.org/kinlint/rules/{name}", code, name, name, "", severity, **more)


LUMPED = rule("CMP010", WARNING, targets=("gazebo",))
BARE = rule(
    "INE004",
    severity_for=(
        SeverityFor(ERROR, ("gazebo",)),
        SeverityFor(WARNING, ("mujoco", "isaac")),
        SeverityFor(WARNING, (), ("sdf",)),
    ),
)
TASTE = rule("INE009", optional=True, severity_for=(SeverityFor(WARNING, ("kdl",)),))
RULES = (LUMPED, BARE, TASTE)


@pytest.mark.parametrize(
    ("targets", "form", "expected"),
    [
        ((), "urdf", {"CMP010": None, "INE004": INFO, "INE009": None}),
        (("gazebo",), "urdf", {"CMP010": WARNING, "INE004": ERROR, "INE009": None}),
        (("isaac", "gazebo"), "urdf", {"CMP010": WARNING, "INE004": ERROR, "INE009": None}),
        (("isaac",), "sdf", {"CMP010": None, "INE004": WARNING, "INE009": None}),
        ((), "sdf", {"CMP010": None, "INE004": WARNING, "INE009": None}),
        (("kdl",), "urdf", {"CMP010": None, "INE004": INFO, "INE009": WARNING}),
    ],
)
def test_what_rules_count_as(targets, form, expected):
    """The worst of the named targets, else of the format, else the rule's own."""
    assert combine_policy((), Catalogue(RULES), targets, form).severities == expected


def test_what_the_user_says_counts_most():
    """A severity by configuration holds for every target."""
    choice = Choice(severity=(("INE004", WARNING),))
    assert combine_policy((choice,), Catalogue(RULES), ("gazebo",)).severities["INE004"] == WARNING


def test_targets_are_those_of_each_file():
    """The configuration nearest to a file says for whom it is meant."""
    files = {"a.urdf": FileSettings(targets=("gazebo",)), "b.urdf": FileSettings()}
    policies = Policies(Settings(files=files), RULES)
    assert policies.for_file("a.urdf").severity(LUMPED) == WARNING
    assert policies.for_file("b.urdf").severity(LUMPED) is None


def test_unknown_target():
    """A slip is told before work starts."""
    settings = Settings(default=FileSettings(targets=("gazbo",)))
    with pytest.raises(UsageError, match="unknown target 'gazbo', did you mean 'gazebo'"):
        Policies(settings, RULES).check_selectors()


FILE = """
@prefix kl: <https://w3id.org/kinlint/ns#> .
@prefix sh: <http://www.w3.org/ns/shacl#> .
<https://w3id.org/kinlint/rules/bare> a kl:Rule ; kl:code "INE004" ; kl:target "gazebo" ;
    sh:severity sh:Info ;
    kl:severityFor [ kl:target "isaac" , "gazebo" ; sh:severity sh:Violation ] ,
                   [ kl:format "sdf" ; sh:severity sh:Warning ] .
"""


def test_rule_files_say_it(tmp_path):
    """In a file, and from there on its page."""
    (tmp_path / "bare.ttl").write_text(FILE, "utf-8")
    (read,) = read_rules(tmp_path / "bare.ttl")
    assert read.targets == ("gazebo",)
    assert read.severity_for == (
        SeverityFor(WARNING, (), ("sdf",)),
        SeverityFor(ERROR, ("gazebo", "isaac")),
    )
    page = rule_page.markdown(read)
    assert "Severity: info; warning in sdf; error with --target gazebo or isaac" in page
    assert "Needs: --target gazebo" in page
    assert json.loads(json.dumps(rule_page.rule_object(read)))["severity_for"][1] == {
        "severity": "error",
        "targets": ["gazebo", "isaac"],
        "formats": [],
    }
