"""A finding that rests on computed triples shows what they were computed from."""

from __future__ import annotations

import json

import pytest
from computed import CONTEXT, QUARTER, STRAIGHT, Node, frame, pose, shift
from support.linting import lint

from kinlint.catalogue import rulebook
from kinlint.catalogue.rulebook import Rulebook
from kinlint.finding import Premise

pytestmark = pytest.mark.xdist_group("faults")

RULE = """
@prefix kl:   <https://w3id.org/kinlint/ns#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
@prefix rule: <https://w3id.org/kinlint/rules/> .
@prefix sh:   <http://www.w3.org/ns/shacl#> .
@prefix fact: <https://w3id.org/kinlint/fact#> .

rule:%s a kl:Rule, sh:NodeShape ;
    kl:code "%s" ; rdfs:label "computed fault" ; rdfs:comment "It is computed." ;
    kl:since "0.1.0" ; kl:antiPattern kl:AP3 ; kl:format "jsonld" ;
    sh:severity sh:Violation ;
    sh:targetSubjectsOf %s ;
    sh:sparql [ sh:message "Fault." ; sh:prefixes kl:prefixes ;
        sh:select "SELECT $this WHERE { %s }" ] ;
    kl:example [ kl:bad "{}"^^kl:jsonld ; kl:good "{}"^^kl:jsonld ] .
"""


FAULTS = {
    "TST001": ("reflection", "fact:determinant", "$this fact:determinant ?det . FILTER (?det < 0)"),
    "TST002": (
        "open-cycle",
        "fact:closed-by",
        "$this fact:closed-by ?last ; fact:distance ?missing . FILTER (?missing > 0.1)",
    ),
    "TST003": ("long-cycle", "fact:length", "$this fact:length ?n . FILTER (?n > 5)"),
    "TST004": (
        "single-joint",
        "fact:component",
        "$this fact:component ?piece . ?piece fact:size ?n . FILTER (?n = 1)",
    ),
    "TST005": ("any-mass", "fact:mass", "$this fact:mass ?m"),
}


@pytest.fixture(scope="module")
def faults(tmp_path_factory: pytest.TempPathFactory) -> Rulebook:
    """The catalogue with a rule for each of FAULTS."""
    folder = tmp_path_factory.mktemp("rules")
    for code, (name, target, where) in FAULTS.items():
        text = RULE % (name, code, target, where)
        (folder / f"{name}.ttl").write_text(text, "utf-8")
    return rulebook.load([folder])


def because(faults: Rulebook, code: str, *nodes: Node) -> tuple[Premise, ...]:
    """The premises of the one finding of a rule."""
    text = json.dumps({"@context": CONTEXT, "@graph": nodes}, indent=1)
    report = lint(text, "arm.jsonld", rules=faults)
    (finding,) = (each for each in report.findings if each.rule.code == code)
    return finding.because


def told(premises: tuple[Premise, ...]) -> list[tuple[int, str, str]]:
    return [(each.depth, each.statement, each.axiom) for each in premises]


@pytest.mark.slow
def test_a_number_is_shown_with_what_it_is_computed_from(faults: Rulebook) -> None:
    """The numbers, lists and units of the node itself, each at its place."""
    premises = because(
        faults,
        "TST001",
        {
            "@id": "ex:c",
            "@type": ["OrientationCoordinate", "DirectionCosineXYZ"],
            "unit": "UNITLESS",
        }
        | {f"direction-cosine-{axis}": row for axis, row in zip("xyz", MIRROR, strict=True)},
    )

    assert told(premises) == [
        (0, "ex:c determinant -1", "computed from"),
        (1, "ex:c unit UNITLESS", ""),
        (1, "ex:c direction-cosine-x [1, 0, 0]", ""),
        (1, "ex:c direction-cosine-y [0, 1, 0]", ""),
        (1, "ex:c direction-cosine-z [0, 0, -1]", ""),
    ]
    assert premises[0].location is None
    assert all(each.location is not None for each in premises[1:])


MIRROR = ([1, 0, 0], [0, 1, 0], [0, 0, -1])


@pytest.mark.slow
def test_a_fact_node_is_shown_by_its_sources(faults: Rulebook) -> None:
    """Once; each further triple of it rests on the same."""
    premises = because(
        faults,
        "TST002",
        *frame("a"),
        *frame("b"),
        *pose("p", "a", "b", STRAIGHT | shift(1, 0, 0)),
        *pose("q", "a", "b", QUARTER | shift(1, 2, 0)),
    )
    shown = told(premises)

    assert (0, "cycle 1 closed by ex:q", "computed from") in shown
    assert (1, "ex:p-coord x 1", "") in shown
    assert (1, "ex:q-coord y 2", "") in shown
    assert (0, "cycle 1 distance 2", "computed from the same") in shown
    assert len({statement for _, statement, _ in shown}) == len(shown)


def test_of_many_sources_each_is_shown_once(faults: Rulebook) -> None:
    """One statement of each is enough to go there."""
    nodes = [node for index in range(6) for node in frame(f"f{index}")]
    for index in range(6):
        nodes += pose(f"p{index}", f"f{(index + 1) % 6}", f"f{index}", shift(1, 0, 0) | STRAIGHT)
    premises = because(faults, "TST003", *nodes)

    assert len([each for each in premises if each.depth == 1]) == 6


def test_a_piece_of_a_chain_is_shown_by_the_chain(faults: Rulebook) -> None:
    """What has no numbers says what it is."""
    premises = because(
        faults,
        "TST004",
        {"@id": "ex:base", "@type": "SimplicialComplex", "simplices": ["ex:a"]},
        {"@id": "ex:arm", "@type": "SimplicialComplex", "simplices": ["ex:b"]},
        {"@id": "ex:j", "@type": "Joint", "between-attachments": ["ex:a", "ex:b"]},
        {"@id": "ex:chain", "@type": "KinematicChain", "joints": ["ex:j"]},
    )

    assert told(premises)[:2] == [
        (0, "ex:chain has a part of ex:arm, ex:base and ex:j", "computed from"),
        (1, "ex:chain is a KinematicChain", ""),
    ]


def test_a_value_in_si_is_shown_with_number_and_unit(faults: Rulebook) -> None:
    """Both are written somewhere."""
    types = ["MassCoordinate", "MassScalar"]
    node = {"@id": "ex:c", "@type": types, "mass": 2000, "unit": "GM"}

    assert told(because(faults, "TST005", node)) == [
        (0, "ex:c mass 2", "computed from"),
        (1, "ex:c mass 2000", ""),
        (1, "ex:c unit GM", ""),
    ]


ARM = """<robot name="arm">
  <link name="base">
    <inertial>
      <mass value="1"/>
      <inertia
        ixx="1"
        ixy="0"
        ixz="0"
        iyy="1"
        iyz="0"
        izz="3"/>
    </inertial>
  </link>
  <link name="tip"/>
  <link name="pad"/>
  <joint name="j" type="revolute">
    <parent link="base"/><child link="tip"/><axis xyz="0 0 1"/>
    <limit effort="1" velocity="1"
      lower="-1"
      upper="2"/>
  </joint>
  <joint name="k" type="revolute">
    <parent link="base"/><child link="pad"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/>
    <mimic joint="j"/>
  </joint>
</robot>
"""


def places(code: str, text: str, name: str) -> list[tuple[str, int]]:
    """What the first finding of a rule of the catalogue rests on, each with its line."""
    finding = next(each for each in lint(text, name).findings if each.rule.code == code)
    return [
        (each.statement, each.location.start.line)
        for each in finding.because
        if each.location is not None
    ]


def test_what_was_computed_of_a_lifted_robot_is_shown_where_its_file_says_it() -> None:
    """Each number at its attribute, also where others have the same value."""
    assert places("INE001", ARM, "arm.urdf") == [
        ("<inertia> of link 'base': ixx 1", 6),
        ("<inertia> of link 'base': ixy 0", 7),
        ("<inertia> of link 'base': ixz 0", 8),
        ("<inertia> of link 'base': iyy 1", 9),
        ("<inertia> of link 'base': iyz 0", 10),
        ("<inertia> of link 'base': izz 3", 11),
        ("<mass> of link 'base': value 1", 4),
    ]


def test_a_value_that_is_not_written_is_shown_at_its_element() -> None:
    """So is the multiplier of a mimic; the units that the format implies are not shown."""
    shown = places("LIM011", ARM, "arm.urdf")
    assert ("<mimic> of joint 'k': multiplier 1", 25) in shown
    assert ("<limit> of joint 'j': lower -1", 19) in shown
    assert ("<limit> of joint 'j': upper 2", 20) in shown
    assert not any("unit" in statement for statement, _ in shown)


def test_numbers_of_sdf_are_shown_at_their_elements() -> None:
    text = """<sdf version="1.9"><model name="arm"><link name="base"><inertial>
    <mass>1</mass><inertia>
    <ixx>1</ixx>
    <iyy>1</iyy>
    <izz>3</izz>
    </inertia></inertial></link></model></sdf>"""
    shown = places("INE001", text, "arm.sdf")
    assert {("<inertia> of link 'base': iyy 1", 4), ("<inertia> of link 'base': izz 3", 5)} <= {
        *shown
    }


def test_a_cycle_of_joints_rests_on_no_placement() -> None:
    """Poses in the frame of another body are resolved by the reader: no file states them."""
    joints = "".join(
        f'<joint name="{name}" type="fixed"><parent>{parent}</parent><child>{child}</child></joint>'
        for name, parent, child in (("one", "inner::a", "b"), ("two", "b", "inner::a"))
    )
    inner = '<model name="inner"><pose>1 0 0 0 0 0</pose><link name="a"/></model>'
    model = f'<model name="arm">{inner}<link name="b"/>{joints}</model>'

    report = lint(f'<sdf version="1.9">{model}</sdf>', "arm.sdf", rules=rulebook.load())
    (finding,) = (each for each in report.findings if each.rule.code == "TOP003")

    assert finding.severity.label == "warning"
    (premise,) = told(finding.because)
    assert premise == (0, "model 'arm': circle joint 'one'", "computed from the elements")


def test_of_an_element_only_its_values_are_shown() -> None:
    """Once, as the file has them: no types, no references between nodes that were lifted."""
    finding = next(each for each in lint(ARM, "arm.urdf").findings if each.rule.code == "LIM011")
    shown = told(finding.because)

    assert (0, "<limit> of joint 'j': upper 2", "") in shown
    assert len({statement for _, statement, _ in shown}) == len(shown)
    assert not [each for each in shown if "coupling" in each[1] or "position-limit" in each[1]]
