"""Rules of a project: tested, explained and used where the project is trusted."""

import json
from pathlib import Path

import pytest

RULE = """\
@prefix at:   <https://w3id.org/kinlint/attribute#> .
@prefix kl:   <https://w3id.org/kinlint/ns#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
@prefix rule: <https://w3id.org/kinlint/rules/> .
@prefix sh:   <http://www.w3.org/ns/shacl#> .
@prefix urdf: <https://w3id.org/kinlint/urdf#> .

rule:joint-without-suffix a kl:Rule, sh:NodeShape ;
    kl:code "ACME001" ;
    rdfs:label "joint without the suffix" ;
    rdfs:comment '''Our scripts look for joints by the end of their names,
        and pass over all of the others.''' ;
    kl:format "urdf" ;
    sh:severity sh:Warning ;
    sh:targetObjectsOf urdf:joint ;
    sh:sparql [
        sh:message "Joint '{?value}' does not end in _joint." ;
        sh:select '''
            SELECT $this (at:name AS ?path) ?value WHERE {
                $this at:type "revolute" ; at:name ?value .
                FILTER (!STRENDS(?value, "_joint"))
            }
            ''' ] ;
    kl:example [
        kl:bad '''
            <robot name="arm">
              <link name="base"/>
              <link name="arm"/>
              <joint name="[|elbow|]" type="revolute">
                <parent link="base"/>
                <child link="arm"/>
              </joint>
              <joint name="knee" type="fixed"><parent link="base"/></joint>
            </robot>'''^^kl:urdf ;
        kl:good '''
            <robot name="arm">
              <joint name="elbow_joint" type="revolute"/>
            </robot>'''^^kl:urdf ] .
"""


@pytest.fixture
def project(write, monkeypatch, tmp_path):
    """A project with a rule of its own, which nobody trusts yet."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    write("kinlint.toml", 'rules = ["rules"]\n')
    write("rules/joint-without-suffix.ttl", RULE)


@pytest.mark.slow
def test_rules_of_the_project_are_tested(project, kinlint):
    """Without arguments: not those of kinlint, and nothing where it is not trusted."""
    assert kinlint("test-rules", "--trust")[:2] == (
        0,
        "1 rule with 1 example: all keep their promises.\n",
    )
    code, _, err = kinlint("test-rules")
    assert (code, "rules left out: you do not trust this project" in err) == (2, True)


@pytest.mark.slow
def test_rules_of_the_project_are_explained(project, kinlint):
    """With what to write into an XML file to ignore one."""
    assert kinlint("rules", "ACME", "--trust")[1].startswith("ACME001  ")
    code, out, _ = kinlint("rule", "ACME001", "--trust")
    assert code == 0
    assert "<!-- kinlint: ignore[ACME001] --> on the line before" in out
    assert 'ignore = ["ACME001"] in kinlint.toml' in out
    assert "ns#ignore" not in out
    code, _, err = kinlint("rule", "ACME001")
    assert (code, "you do not trust this project" in err) == (2, True)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("right", "wrong", "said"),
    [
        (
            '"revolute" ;',
            '"prismatic" ;',
            'elbow is marked and not found: line 20: ?this at:type "prismatic" matches nothing\n',
        ),
        (
            "FILTER (",
            'FILTER (?value = "x" && ',
            'line 21: FILTER ( ?value = "x" && ! STRENDS ( ?value , "_joint" ) ) is never true',
        ),
        (
            "$this at:type",
            "$this urdf:limit/urdf:axis [] ; at:type",
            "line 20: ?this urdf:limit [] matches nothing\n",
        ),
        ("urdf:joint ;", "urdf:sensor ;", "nothing in the example is a target of the rule"),
        (
            '<link name="base"/>',
            '<link name="base">',
            "it is not well-formed in its line 9",
        ),
        (
            'revolute"/>\n            </robot>',
            'revolute">\n            </robot>',
            "good example 1: it is not well-formed in its line 3: </robot> closes <joint>",
        ),
        (
            "$this at:type",
            "$this urdf:parent ?parent ; at:type",
            "joint-without-suffix: line 20: ?parent is never used: write [] if any value will do",
        ),
    ],
)
def test_a_failure_says_how_far_the_query_came(write, kinlint, right, wrong, said):
    """In the words of the author: variables that only the compiler has are not named."""
    assert right in RULE
    write("joint-without-suffix.ttl", RULE.replace(right, wrong, 1))
    code, out, err = kinlint("test-rules", "joint-without-suffix.ttl")

    assert said in out, out + err
    assert "?k_" not in out
    assert code == 1


@pytest.mark.slow
@pytest.mark.parametrize(
    ("right", "wrong", "said"),
    [
        ("$this at:type", "$this urdf:parent [] ; at:type", "query needs ?this urdf:parent []"),
        ('"joint without', '"Joint without', "A rule has one rdfs:label: at most 40 characters"),
        (
            "look for joints by the end of their names,\n        and pass over all of the others.",
            "miss them.",
            "that says what breaks, in two sentences or more",
        ),
    ],
)
def test_duties_of_the_catalogue_are_remarks(write, kinlint, right, wrong, said):
    """Which fail no rule of a user, and are not shown with --quiet."""
    assert right in RULE
    write("joint-without-suffix.ttl", RULE.replace(right, wrong, 1))
    code, out, _ = kinlint("test-rules", "joint-without-suffix.ttl")

    assert code == 0, out
    assert said in out
    assert "joint-without-suffix: remark: " in out
    assert "1 rule with 1 example: all keep their promises (" in out
    assert kinlint("test-rules", "--quiet", "joint-without-suffix.ttl")[:2] == (0, "")


REPAIR = """
    dash:suggestionGenerator [
        rdfs:label "Append the suffix" ;
        kl:applicability kl:unsafe ;
        rdfs:comment "Other files may name the joint." ;
        sh:update '''
            DELETE { $this at:name ?value } INSERT { $this at:name ?longer }
            WHERE { $this at:name ?value BIND (CONCAT(?value, "_joint") AS ?longer) }
            ''' ] ;
    kl:example ["""


@pytest.mark.slow
def test_examples_are_updated_and_coverage_is_counted(write, kinlint):
    """As JSON, too; marks and fixed texts are written as the rule finds and fixes."""
    fixed = RULE.partition("kl:bad '''")[2].partition("'''")[0]
    fixed = fixed.replace("[|elbow|]", "elbow_joint")
    right = RULE.replace("\n    kl:example [", REPAIR, 1)
    right = right.replace(
        "        kl:good", f"        kl:fixed '''{fixed}'''^^kl:urdf ;\n        kl:good"
    )
    right = f"@prefix dash: <http://datashapes.org/dash#> .\n{right}"
    wrong = right.replace("[|elbow|]", "elbow").replace('"base"/>', '"[|base|]"/>', 1)
    name = "joint-without-suffix.ttl"
    write(name, wrong.replace("elbow_joint", "wrist", 1))
    code, out, _ = kinlint("test-rules", "--json", "--coverage", name)
    (told,) = json.loads(out)
    assert (code, told["code"], told["examples"], len(told["failures"])) == (1, "ACME001", 1, 3)
    assert told["coverage"] == {"parts": 3, "untested": []}
    code, out, _ = kinlint("test-rules", "--update", "--coverage", name)
    assert (code, Path(name).read_text("utf-8")) == (0, right)
    assert "ACME001 joint-without-suffix: examples need 3 of 3 parts of queries\n" in out
    assert out.startswith("updated ")
