"""What OWL 2 RL calls inconsistent is a finding, and owlrl, asked about the same, agrees."""

from __future__ import annotations

import re
from collections.abc import Set as AbstractSet
from functools import cache
from pathlib import Path

import pyoxigraph as ox
import pytest
from data import locate_data
from hypothesis import given, settings
from hypothesis import strategies as st
from support.linting import book, told

from kinlint import resources
from kinlint.engine.reference.owl import owlrl_complaints
from kinlint.finding import Finding
from kinlint.formats.registry import decode
from kinlint.terms import Triple
from kinlint.text import SourceText
from kinlint.vocabulary import METAMODELS, OWL

pytestmark = pytest.mark.oracle

CHECKOUT = Path(__file__).parents[2]
ONTOLOGY = sorted((resources.data("shapes") / "ontology").glob("*.ttl"))
BOOK = book()
OURS = "https://example.org/arm#"
PREFIXES = f"""
    @prefix ex: <{OURS}> .
    @prefix geom: <{METAMODELS}geometry/structural-entities#> .
    @prefix geom-rel: <{METAMODELS}geometry/spatial-relations#> .
    @prefix kc: <{METAMODELS}kinematic-chain/structural-entities#> .
    @prefix kin: <https://w3id.org/kinlint/kinematics#> .
    @prefix cstr: <{METAMODELS}task/constraint#> .
"""

COMPLAINTS = {
    "cax-dw": ("LD012", r"Disjoint classes \S+ and \S+ have a common individual (\S+)"),
    "prp-irp": ("LD019", r"Irreflexive property used on (\S+) with \S+"),
    "prp-asyp": ("LD019", r"Erroneous usage of asymmetric property \S+ on (\S+) and (\S+)"),
    "prp-pdw": ("LD019", r"Erroneous usage of disjoint properties \S+ and \S+ on (\S+) and (\S+)"),
    "prp-adp": ("LD019", r"Disjoint properties in an .* \((\S+), \S+,\s*(\S+)\) and \(.*\)"),
    "cls-nothing2": ("LD019", r"(\S+) is defined of type 'Nothing'"),
    # owlrl names a class here, where it says that it names the individual.
    "cls-com": ("LD019", r"Violation of complementarity for classes .* on element \S+"),
    "cls-maxc1": ("LD019", r"Erroneous usage of maximum cardinality with \S+ and (\S+)"),
}
"""What OWL 2 RL calls each contradiction, who reports it here, and how owlrl says of whom."""

CASES = {
    "cax-dw": "ex:tool a geom-rel:Pose, geom-rel:VelocityTwist .",
    "cax-dw of a pair": "ex:tool a geom:2D, geom:3D .",
    "cax-dw by a subclass": "ex:flange a geom:Frame, geom:UnitLength .",
    "cax-dw by a domain": "ex:flange a geom:Frame ; geom:start ex:centre .",
    "cax-dw by a range": "ex:flange geom:origin ex:arm . ex:arm a geom:SimplicialComplex .",
    "cax-dw by a word": 'ex:elbow a kin:PrismaticJoint ; kin:joint-type "revolute" .',
    "cax-dw of tasks": "ex:gentle a cstr:LessThanConstraint, cstr:EqualityConstraint .",
    "prp-irp": "ex:z a geom:Vector ; geom:vector-z ex:z .",
    "prp-irp and prp-asyp": "ex:arm geom:simplices ex:arm .",
    "prp-asyp": "ex:arm geom:simplices ex:hand . ex:hand geom:simplices ex:arm .",
    "prp-asyp of two": "ex:a geom:vector-x ex:b . ex:b geom:vector-y ex:a .",
    "prp-pdw": "ex:x a geom:Vector ; geom:start ex:centre ; geom:end ex:centre .",
    "prp-adp": "ex:flange geom:vector-x ex:x ; geom:vector-y ex:x .",
    "cls-nothing2": "ex:weld a kin:FixedJoint . ex:c a kin:JointCoupling ; kin:follower ex:weld .",
    "cls-com": "ex:weld a kin:FixedJoint, kin:JointWithPolarity .",
    "cls-maxc1": "ex:weld a kin:FixedJoint ; kc:common-axis ex:axis .",
    "nothing": "ex:flange a geom:Frame, geom:RigidBody ; geom:origin ex:o ; geom:vector-z ex:z .",
}


def turtle(text: str) -> tuple[Triple, ...]:
    quads = ox.parse(PREFIXES + text, ox.RdfFormat.TURTLE)
    return tuple((str(q.subject), str(q.predicate), str(q.object)) for q in quads)


def contradictions(*sources: SourceText) -> list[Finding]:
    """What is told of contradictions in *sources*, or follows from what is told."""
    return [each for each in told(sources) if each.rule.code in ("LD012", "LD019")]


@cache
def complaints(text: str) -> frozenset[tuple[str, str, frozenset[str]]]:
    """By which OWL rule, by which of ours it is reported, and the individuals concerned."""
    said: set[tuple[str, str, frozenset[str]]] = set()
    for complaint in owlrl_complaints(turtle(text), ONTOLOGY):
        for kind, (code, pattern) in COMPLAINTS.items():
            if match := re.fullmatch(pattern, complaint):
                said.add((kind, code, frozenset(match.groups())))
                break
        else:
            raise AssertionError(complaint)
    return frozenset(said)


def concerned(finding: Finding) -> set[str]:
    terms = (finding.focus, finding.value, *finding.arguments)
    expanded = (f"{term}".strip("<>").replace("ex:", OURS) for term in terms if term)
    return {term for term in expanded if term.startswith(OURS)}


def assert_same(
    findings: list[Finding], said: AbstractSet[tuple[str, str, frozenset[str]]]
) -> None:
    """Each contradiction is found, and nothing is found that is none.

    What has itself as an irreflexive property is reported as that, and not once more for the
    classes that the property's domain and range give it.
    """
    for kind, code, individuals in said:
        assert any(
            individuals <= concerned(finding)
            for finding in findings
            if finding.rule.code == code or "its own" in finding.message
        ), (kind, individuals)
    for finding in findings:
        assert any(
            code == finding.rule.code and individuals <= concerned(finding)
            for _, code, individuals in said
        ), finding.message


@pytest.mark.parametrize("name", CASES)
def test_what_owlrl_calls_inconsistent_is_a_finding(name):
    """Nothing more and nothing less, for each kind of axiom in the ontology."""
    said = complaints(CASES[name])

    found = contradictions(SourceText("arm.ttl", PREFIXES + CASES[name]))

    assert bool(said) == (name != "nothing")
    assert_same(found, said)


def test_every_kind_of_contradiction_is_among_the_cases():
    """owlrl complains of each at least once, so the comparison is not about nothing."""
    said = {kind for text in CASES.values() for kind, _, _ in complaints(text)}

    assert said == COMPLAINTS.keys()


TYPES = (
    *("geom:Frame", "geom:Point", "geom:UnitLength", "geom:SimplicialComplex", "kin:FixedJoint"),
    *("kc:RevoluteJoint", "kin:JointWithPolarity", "geom-rel:Pose", "kin:JointCoupling"),
)
ARCS = (
    *("geom:vector-x", "geom:vector-y", "geom:origin", "geom:start", "geom:end", "geom:simplices"),
    *("kc:common-axis", "kin:follower", "kin:leader", "kc:joints"),
)
NODES = st.sampled_from(["ex:a", "ex:b", "ex:c"])


@settings(max_examples=15)
@given(
    st.lists(st.tuples(NODES, st.sampled_from(TYPES)), max_size=4),
    st.lists(st.tuples(NODES, st.sampled_from(ARCS), NODES), max_size=5),
)
def test_contradictions_are_those_of_owlrl_however_axioms_meet(typed, related):
    """Of any few statements, both say the same."""
    types = [f"{node} a {kind} ." for node, kind in typed]
    arcs = [f"{start} {arc} {end} ." for start, arc, end in related]
    text = "\n".join([*types, *arcs])

    assert_same(contradictions(SourceText("a.ttl", PREFIXES + text)), complaints(text))


SUPPORTED = {
    *("inverseOf", "propertyChainAxiom", "equivalentProperty", "equivalentClass"),
    *("onProperty", "hasValue", "someValuesFrom", "allValuesFrom", "maxCardinality"),
    *("intersectionOf", "unionOf", "complementOf", "members", "disjointWith"),
    *("propertyDisjointWith", "AllDisjointClasses", "AllDisjointProperties"),
    *("FunctionalProperty", "SymmetricProperty", "TransitiveProperty"),
    *("IrreflexiveProperty", "AsymmetricProperty", "Nothing", "Thing"),
}


def test_the_ontology_says_nothing_that_nobody_would_hear():
    """Every OWL term in it is inferred from, or found contradicted, or held by ID004."""
    used = set()
    for file in ONTOLOGY:
        for quad in ox.parse(path=file, format=ox.RdfFormat.TURTLE, base_iri="urn:x:"):
            terms = (quad.predicate, quad.object)
            used |= {t.value for t in terms if isinstance(t, ox.NamedNode)}

    assert {term.removeprefix(OWL) for term in used if term.startswith(OWL)} <= SUPPORTED


def test_the_contradictions_of_a_published_robot_are_found_where_they_are_written():
    """Two vectors that are their own axis, and two frames called a vector, in the Kinova Gen3."""
    files = sorted(locate_data("comp-rob2b", "robot-models").rglob("*.json"))
    found = contradictions(*(decode(str(file), file.read_bytes()) for file in files))

    places = {
        (Path(each.location.source.name).name, each.location.start.line, each.rule.code)
        for each in found
    }
    assert places == {
        ("robot.geom.json", 191, "LD019"),
        ("robot.geom.json", 226, "LD019"),
        ("robot.geom.json", 19, "LD012"),
        ("mounting-upright.geom.json", 19, "LD012"),
    }
