"""A rule may be about some consumers of robots, and count as worse for some of them."""

import json

import pytest
from support.linting import findings

from kinlint.catalogue.rule_file import read_rules
from kinlint.catalogue.rulebook import load
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


CONSTRAINTS = """
@prefix kl: <https://w3id.org/kinlint/ns#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
@prefix sh: <http://www.w3.org/ns/shacl#> .
@prefix urdf: <https://w3id.org/kinlint/urdf#> .
<https://w3id.org/kinlint/rules/axes> a kl:Rule, sh:NodeShape ; kl:code "ZZZ001" ;
    kl:format "urdf" ; sh:severity sh:Warning ; sh:targetObjectsOf urdf:link ;
    sh:sparql
        [ sh:message "Worse for some." ;
          kl:severityFor [ kl:target "mujoco" ; sh:severity sh:Violation ] ;
          sh:select "SELECT $this WHERE { ?robot <https://w3id.org/kinlint/urdf#link> $this }" ] ,
        [ sh:message "For some alone." ; kl:target "drake" ; sh:severity sh:Info ;
          sh:select "SELECT $this WHERE { ?robot <https://w3id.org/kinlint/urdf#link> $this }" ] .
"""
WORSE, ALONE = "Worse for some.", "For some alone."


@pytest.mark.slow
@pytest.mark.parametrize(
    ("targets", "expected"),
    [
        ((), {WORSE: WARNING}),
        (("mujoco",), {WORSE: ERROR}),
        (("drake",), {WORSE: WARNING, ALONE: INFO}),
        (("drake", "mujoco"), {WORSE: ERROR, ALONE: INFO}),
    ],
)
def test_single_constraints_have_consumers(tmp_path, targets, expected):
    """A constraint may count as worse for a consumer, or speak for one alone."""
    (tmp_path / "axes.ttl").write_text(CONSTRAINTS, "utf-8")
    found = findings(
        '<robot name="arm"><link name="base"/></robot>',
        rules=load((tmp_path,)),
        default=FileSettings(targets=targets),
    )
    assert {each.message: each.severity for each in found if each.rule.code == "ZZZ001"} == expected


def test_the_user_overrules_constraints(tmp_path):
    """A severity by configuration holds for all findings of a rule."""
    (tmp_path / "axes.ttl").write_text(CONSTRAINTS, "utf-8")
    choice = Choice(severity=(("ZZZ001", INFO),))
    found = findings(
        '<robot name="arm"><link name="base"/></robot>',
        rules=load((tmp_path,)),
        default=FileSettings((choice,), targets=("mujoco",)),
    )
    assert {each.severity for each in found if each.rule.code == "ZZZ001"} == {INFO}


def test_pages_tell_the_consumers_of_constraints(tmp_path):
    """The page of a rule has them, as text and as an object."""
    (tmp_path / "axes.ttl").write_text(CONSTRAINTS, "utf-8")
    (read,) = read_rules(tmp_path / "axes.ttl")
    said = (
        "info for some findings with --target drake; error for some findings with --target mujoco"
    )
    assert said in rule_page.markdown(read)
    assert rule_page.rule_object(read)["constraint_severity_for"][0] == {
        "severity": "info",
        "targets": ("drake",),
        "formats": (),
    }
