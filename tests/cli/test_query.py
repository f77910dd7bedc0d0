"""`kinlint query` and `kinlint graph --output-format turtle`: the graph that rules see."""

import csv
import io
import json

import pyoxigraph as ox
import pytest

ROBOT = """\
<robot name="arm">
  <link name="base"/>
  <link name="tip"/>
  <joint name="elbow" type="revolute">
    <parent link="base"/>
    <child link="tip"/>
    <limit lower="-1" upper="1" effort="2" velocity="3"/>
  </joint>
</robot>
"""
JOINTS = "SELECT ?joint ?type { ?joint at:type ?type }"


@pytest.fixture(autouse=True)
def robot(write):
    """A robot of two links."""
    write("arm.urdf", ROBOT)


def test_rows_have_places(kinlint):
    """As a table: nodes by their address in the file, each row with where its first node is."""
    code, out, err = kinlint("query", JOINTS, "arm.urdf")
    assert (code, err) == (0, "")
    assert [line.split() for line in out.splitlines()] == [
        ["?joint", "?type", "place"],
        ["#/joint/elbow", "revolute", "arm.urdf:4:16"],
        ["1", "row"],
    ]


def test_rows_as_csv_and_json(kinlint):
    """Which other programs read: SPARQL 1.1 Query Results, with places besides."""
    rows = list(
        csv.reader(io.StringIO(kinlint("query", JOINTS, "arm.urdf", "--output-format=csv")[1]))
    )
    assert rows[0] == ["joint", "type", "place"]
    assert rows[1][1:] == ["revolute", "arm.urdf:4:16"]
    found = json.loads(kinlint("query", JOINTS, "arm.urdf", "--output-format", "json")[1])
    (row,) = found["results"]["bindings"]
    assert found["head"]["vars"] == ["joint", "type"]
    assert row["type"] == {"type": "literal", "value": "revolute"}
    assert row["joint"]["type"] == "uri"
    assert row["joint"]["place"] == "arm.urdf:4:16"


@pytest.mark.slow
def test_names_are_no_formulas_of_a_spreadsheet(kinlint, write):
    """Texts that would be evaluated are quoted; negative numbers stay numbers."""
    write("a.urdf", ROBOT.replace('"tip"', '"=cmd()"').replace('"elbow"', '"-elbow"'))
    for query, expected in {
        "SELECT ?name { ?r urdf:link ?l . ?l at:name ?name }": {"base", "'=cmd()"},
        "SELECT ?name { ?r urdf:joint ?j . ?j at:name ?name }": {"'-elbow"},
        "SELECT ?low { ?l at:lower ?low }": {"-1"},
    }.items():
        code, out, _ = kinlint("query", query, "a.urdf", "--output-format", "csv")
        assert code == 0
        assert {row[0] for row in list(csv.reader(io.StringIO(out)))[1:]} == expected


def test_all_layers_are_asked(kinlint):
    """What a file states, what is lifted and inferred, and what is computed."""
    for query in ("ASK { ?r urdf:joint ?j }", "ASK { ?j a kc:Joint }", "ASK { ?a fact:root ?b }"):
        assert kinlint("query", query, "arm.urdf")[:2] == (0, "true\n")
    assert kinlint("query", "ASK { ?s kin:lower 7 }", "arm.urdf")[1] == "false\n"


def test_what_is_constructed_is_turtle(kinlint):
    """With the prefixes that it takes."""
    code, out, _ = kinlint("query", "CONSTRUCT { ?j a kc:Joint } { ?j a kc:Joint }", "arm.urdf")
    assert code == 0
    (triple,) = ox.parse(out, ox.RdfFormat.TURTLE)
    assert triple.object.value.endswith("structural-entities#Joint")


@pytest.mark.parametrize(
    ("query", "said"),
    [
        (
            "SELECT ?j {\n ?j at:tpye ?t }",
            "query:2: at:tpye: no format has an attribute 'tpye', did",
        ),
        (
            "SELECT ?j { ?j att:type ?t }",
            "query:1: the prefix 'att:' is not declared, did you mean",
        ),
        ("SELECT ?j { ?j at:type ?t FILTER (STRENDZ(?t, 'x')) }", "no function 'STRENDZ', did you"),
        ("SELECT ?j { SERVICE <http://localhost/> { ?j ?p ?o } }", "SERVICE is not allowed"),
        ("SELECT ?j FROM <file:///etc/passwd> { ?j ?p ?o }", "FROM is not allowed"),
        ("SELECT ?j { GRAPH <file:///etc/passwd> { ?j ?p ?o } }", "GRAPH of an IRI is not allowed"),
        ("SELECT ?j { BIND (<urn:call>(1) AS ?j) }", "the function <urn:call> is not known"),
        ("DESCRIBE ?j { ?j ?p ?o }", "expected SELECT, ASK or CONSTRUCT, got 'DESCRIBE'"),
        ("DELETE { ?j ?p ?o } WHERE { ?j ?p ?o }", "expected SELECT, ASK or CONSTRUCT"),
        ("SELECT ?j { ?j ?p ?o", "query:1: the query ends too early"),
        ("SELECT ?j { ?j ?p }", "query:1: "),
    ],
)
def test_a_wrong_query_is_refused(kinlint, query, said):
    """With its line, and under the limits that rules have."""
    code, out, err = kinlint("query", query, "arm.urdf")
    assert (code, out) == (2, "")
    assert said in err


@pytest.mark.slow
def test_the_graph_as_turtle(kinlint):
    """Layer by layer, or all of them, with places as comments."""
    counts = {}
    for layer in ("source", "lifted", "closure", "facts", "all"):
        code, out, _ = kinlint("graph", "arm.urdf", "--output-format", "turtle", "--layer", layer)
        assert code == 0
        counts[layer] = len(list(ox.parse(out, ox.RdfFormat.TURTLE)))
        if layer == "all":
            assert "  # arm.urdf:4:16\n" in out
            assert '    at:type "revolute"' in out
    assert 0 < counts["closure"]
    assert counts["all"] == sum(counts.values()) - counts["all"]


def test_the_graph_in_a_file(kinlint, here):
    """Whose name says what it is."""
    assert kinlint("graph", "arm.urdf", "-o", "arm.ttl")[0] == 0
    assert list(ox.parse((here / "arm.ttl").read_text("utf-8"), ox.RdfFormat.TURTLE))


def test_names_of_files_are_neutralised(kinlint, write):
    """They are no formulas, and move no cursor."""
    write("=1+1.urdf", ROBOT)
    write("a\x1b[2J.urdf", ROBOT)
    out = kinlint("query", JOINTS, "=1+1.urdf", "--output-format", "csv")[1]
    assert list(csv.reader(io.StringIO(out)))[1][2] == "'=1+1.urdf:4:16"
    assert "\x1b" not in kinlint("query", JOINTS, "a\x1b[2J.urdf")[1]
