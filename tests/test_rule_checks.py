"""Whatever a rule names exists; else the file is refused, with the line and what may be meant."""

import pytest

from kinlint.catalogue.repair_file import prefixes
from kinlint.catalogue.rule_checks import check
from kinlint.engine.compiler.shapes_graph import parse
from kinlint.errors import RuleInvalid

RULE = """\
@prefix at:   <https://w3id.org/kinlint/attribute#> .
@prefix ext:  <https://w3id.org/kinlint/extension#> . @prefix dash: <http://datashapes.org/dash#> .
@prefix kl:   <https://w3id.org/kinlint/ns#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
@prefix rule: <https://w3id.org/kinlint/rules/> .
@prefix sh:   <http://www.w3.org/ns/shacl#> .
@prefix urdf: <https://w3id.org/kinlint/urdf#> .

rule:joint-without-suffix a kl:Rule, sh:NodeShape ;
    kl:code "ACME001" ;
    kl:format "urdf" ;
    rdfs:label "joint without the suffix" ;
    sh:severity sh:Warning ;
    sh:targetObjectsOf urdf:joint ;
    sh:sparql [
        sh:message "Joint '{?value}' is none of '{?robot}'." ;
        sh:select '''
            SELECT $this (at:name AS ?path) ?value ?robot WHERE {
                $this at:type "revolute" ; at:name ?value .
                [] urdf:joint $this ; at:name ?robot .
                FILTER (!REGEX(?value, "\\\\d_joint$"))
            }
            ''' ] ;
    kl:example [ kl:bad "<robot/>"^^kl:urdf ; kl:good "<robot/>"^^kl:urdf ] .
"""


def faults(text, name="joint-without-suffix.ttl"):
    """What is wrong with the file *text*, a line each, without the name of the file."""
    try:
        check(parse((name, text)), prefixes())
    except RuleInvalid as error:
        return [line.removeprefix(f"{name}:") for line in str(error).splitlines()]
    return []


def test_a_rule_whose_terms_exist_passes():
    """What the next test breaks is whole."""
    assert faults(RULE) == []


@pytest.mark.parametrize(
    ("right", "wrong", "said"),
    [
        (
            "at:type",
            "at:tpye",
            "19: at:tpye: no format has an attribute 'tpye', did you mean 'at:t",
        ),
        ("urdf:joint ;", "urdf:jiont ;", "14: urdf:jiont: URDF has no element 'jiont', did you me"),
        ("[] urdf:joint", "[] urdf:jiont", "20: urdf:jiont: URDF has no element 'jiont', did you"),
        (
            "kl:example",
            "kl:exmple",
            "24: kl:exmple: no term of rules is called 'exmple', did you m",
        ),
        (
            "sh:message",
            "sh:mesage",
            "16: sh:mesage: SHACL has no term 'mesage', did you mean 'sh:m",
        ),
        ("sh:Warning", "sh:Warnign", "13: sh:Warnign: SHACL has no term 'Warnign', did you mean '"),
        (
            "[] urdf",
            "[] fact:rot $this ; urdf",
            "20: fact:rot: no fact is called 'rot', did you mea",
        ),
        (
            "[] urdf",
            "[] kin:lowr 1 ; urdf",
            "20: kin:lowr: the metamodels have no term 'lowr', did y",
        ),
        (
            "[] urdf",
            "[] kc:betwen [] ; urdf",
            "20: kc:betwen: the metamodels have no term 'betwen'",
        ),
        (
            "[] urdf",
            "[] ref:parnt [] ; urdf",
            "20: ref:parnt: no format has a reference 'parnt', di",
        ),
        (
            "[] urdf",
            "[] src:txet 1 ; urdf",
            "20: src:txet: no reader states 'txet', did you mean 'src:text'?",
        ),
        (
            "[] urdf",
            "[] at:upper unit:MiliM ; urdf",
            "20: unit:MiliM: the table of units has no 'MiliM', did you mean 'unit:MilliM'?",
        ),
        (
            "    kl:example",
            "    dash:sugestionGenerator [] ;\n    kl:example",
            "24: dash:sugestionGenerator: DASH has no term 'sugestionGenerator', did you mean 'da",
        ),
        ("; at:name", "; urdf:name", "19: urdf:name: URDF has no element 'name'; the attribute is"),
        (
            '"urdf" ;',
            '"urdff" ;',
            "11: kl:format: no format is called 'urdff', did you mean 'urdf'?",
        ),
        (
            '"ACME001"',
            '"suffix"',
            "10: kl:code 'suffix' is not one to eight capitals and three dig",
        ),
        ("^^kl:urdf ;", "^^kl:urdff ;", "24: kl:urdff: no term of rules is called 'urdff', did yo"),
        (
            "    sh:targetObjectsOf urdf:joint ;\n",
            "",
            "9: the rule has no target: sh:targetClass, ",
        ),
        (
            "ObjectsOf",
            "Class",
            "14: urdf:joint is the property that leads to an element, not a cla",
        ),
        ("[] urdf:joint", "[] a urdf:joint ; urdf:joint", "20: urdf:joint is the property that le"),
        ("REGEX(", "REGXE(", "21: SPARQL has no function 'REGXE', did you mean 'REGEX'?"),
        ("FILTER", "FILTR", "21: SPARQL has no function 'FILTR', did you mean 'FILTER'?"),
        ("WHERE", "WERE", "18: SPARQL has no keyword 'WERE', did you mean 'WHERE'?"),
        (
            "REGEX(?value",
            "REGEX(?valeu",
            "21: nothing gives ?valeu a value, did you mean '?value'?",
        ),
        (
            "at:name ?value",
            "at:name ?valuee",
            "18: nothing gives ?value a value, did you mean '?va",
        ),
        ("{?robot}", "{?robto}", "16: the query does not select {?robto} of the message, did you "),
        (
            "[] urdf",
            "[] at:name ?robt ; urdf",
            "20: ?robt occurs only here, did you mean '?robot'?",
        ),
    ],
)
def test_what_does_not_exist_is_said_with_its_line(right, wrong, said):
    """And with the name that is nearest to it, where one is near."""
    assert right in RULE
    found = faults(RULE.replace(right, wrong, 1))

    assert any(each.startswith(said) for each in found), found


@pytest.mark.parametrize(
    ("right", "wrong"),
    [
        ("at:type", "<https://w3id.org/kinlint/attribute#tpye>"),
        ("[] urdf", "[] ext:plugin [ at:acme 1 ] ; urdf"),
        ("[] urdf", "[] at:xyz-1 0 ; urdf"),
        ("    kl:example", "    dash:suggestion [] ;\n    kl:example"),
        ("[] urdf", "[] urdf:lower|at:lower 0 ; urdf"),
        ("[] urdf", "[] <https://acme.example/terms#weight> 1 ; urdf"),
        ("FILTER", "FILTER NOT EXISTS { $this urdf:axis ?axis } FILTER"),
        ("FILTER", "BIND (IF(?value = 'a', 1, ?none) AS ?robot2) FILTER"),
        ("rdfs:label", "rdfs:seeAlso sh:datatype ; rdfs:label"),
    ],
)
def test_what_may_be_meant_passes(right, wrong):
    """IRIs in full, what no format lists, other vocabularies, and whether something exists."""
    assert right in RULE
    assert faults(RULE.replace(right, wrong, 1)) == []


def test_all_faults_are_told_at_once():
    """Each in a line of its own, in the order of the file."""
    found = faults(RULE.replace("at:type", "at:tpye").replace("sh:Warning", "sh:Warnign"))

    assert [each.partition(":")[0] for each in found] == ["13", "19"]


def test_plain_shapes_are_held_to_it_too():
    """A shape of a user that names an attribute that no format has."""
    shape = (
        "@prefix at: <https://w3id.org/kinlint/attribute#> .\n"
        "@prefix sh: <http://www.w3.org/ns/shacl#> .\n"
        "[] a sh:NodeShape ; sh:property [ sh:path at:naem ; sh:minCount 1 ] .\n"
    )

    assert faults(shape) == [
        "3: at:naem: no format has an attribute 'naem', did you mean 'at:name'?"
    ]
