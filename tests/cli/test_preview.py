"""Rules that are not settled: off, unless previews are on or the rule is named."""

import pytest

RULE = """\
@prefix kl:   <https://w3id.org/kinlint/ns#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
@prefix rule: <https://w3id.org/kinlint/rules/> .
@prefix sh:   <http://www.w3.org/ns/shacl#> .
@prefix urdf: <https://w3id.org/kinlint/urdf#> .

rule:any-link a kl:Rule, sh:NodeShape ;
    kl:code "ACME001" ; rdfs:label "any link" ; rdfs:comment "Links are found." ;
    kl:format "urdf" ; kl:preview true ;
    sh:severity sh:Warning ;
    sh:targetObjectsOf urdf:link ;
    sh:sparql [ sh:message "A link." ; sh:select "SELECT $this WHERE { ?robot urdf:link $this }" ] .
"""


@pytest.fixture
def project(write):
    """A robot, and a rule of the project."""
    write("rules/any-link.ttl", RULE)
    write("arm.urdf", '<robot name="arm"><link name="base"/></robot>')
    return ("arm.urdf", "--rules", "rules", "--output", "concise")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("options", "told"),
    [
        ((), False),
        (("--select", "ACME,ALL"), False),
        (("--preview",), True),
        (("--preview", "--no-preview"), False),
        (("--config", "preview=true"), True),
        (("--extend-select", "ACME001"), True),
        (("--select", "any-link"), True),
        (("--preview", "--ignore", "ACME"), False),
    ],
)
def test_a_preview_rule_is_checked_on_request(kinlint, project, options, told):
    """By the option, the key of the configuration, or its name."""
    code, out, _ = kinlint(*project, *options)

    assert (code, "ACME001" in out) == (int(told), told)


def test_the_rule_says_so(kinlint, project):
    """In its page, and in the list."""
    assert "Preview: off without --preview" in kinlint("rule", "ACME001", "--rules", "rules")[1]
    assert kinlint("rules", "ACME", "--rules", "rules")[1].endswith("any link (preview)\n")
