"""Robots in XML through the command: what reports call their parts, and what silences them."""

import io
import json
import re
import sys
from html import unescape

import pytest

from kinlint.project import reading

ROBOT = """\
<robot name="lamp">
  <link name="base"/>
  <link name="head"><inertial><mass value="-1"/></inertial></link>
  <joint name="elbow" type="revolute">
    <parent link="base"/>
    <child link="head"/>
    <axis xyz="0 0 2"/>
    <limit lower="3" upper="1" effort="1" velocity="1"/>
  </joint>
</robot>
"""
ONLY = ("--select", "INE003,FRM009,LIM001")


@pytest.fixture
def lamp(write):
    """A lamp with three mistakes."""
    return write("lamp.urdf", ROBOT)


def test_entities_are_ways_through_the_file(kinlint, lamp):
    """Never addresses that kinlint made up for itself."""
    _, out, _ = kinlint("lamp.urdf", *ONLY, "--output-format", "json")
    found = {each["code"]: each for each in json.loads(out)}

    assert {code: each["iri"] for code, each in found.items()} == {
        "INE003": "lamp.urdf#/link/head/inertia/mass",
        "FRM009": "lamp.urdf#/joint/elbow/axis",
        "LIM001": "lamp.urdf#/joint/elbow/position-limit",
    }
    related = found["FRM009"]["related"]
    assert {each["message"] for each in related} >= {"'xyz' is given here"}


@pytest.mark.parametrize("form", ["full", "concise", "json", "json-lines", "sarif", "github"])
def test_no_report_has_addresses_of_elements(kinlint, lamp, form):
    """Nor those of the terms for attributes, but in the updates that fixes are."""
    code, out, err = kinlint("lamp.urdf", *ONLY, "--output-format", form)
    out = re.sub(r'"(update|kinlint/sparqlUpdate)": "(?:[^"\\]|\\.)*"', "", out)

    assert code == 1
    assert "urn:kinlint" not in out + err
    assert "kinlint/attribute#" not in out + err


def test_code_scanning_is_told_the_element(kinlint, lamp):
    """As a logical location."""
    _, out, _ = kinlint("lamp.urdf", "--select", "FRM009", "--output-format", "sarif")
    (result,) = json.loads(out)["runs"][0]["results"]

    assert result["locations"][0]["logicalLocations"] == [
        {"name": "axis", "fullyQualifiedName": "/joint/elbow/axis", "kind": "element"}
    ]


@pytest.mark.parametrize(
    ("key", "left"),
    [
        ("lamp.urdf", []),
        ("*.urdf", []),
        ("lamp.urdf#/link/head", ["FRM009", "LIM001"]),
        ("lamp.urdf#/joint/elbow", ["INE003"]),
        ("lamp.urdf#/joint/elbow/axis", ["INE003", "LIM001"]),
        ("lamp.urdf#/joint/elb", ["FRM009", "INE003", "LIM001"]),
        ("<urn:kinlint:document:lamp.urdf#/joint/elbow/axis>", ["INE003", "LIM001"]),
    ],
)
def test_what_a_file_or_an_element_may_have(kinlint, lamp, write, key, left):
    """By a pattern of names, by the way to the element, by its address."""
    write("kinlint.toml", f'[per-file-ignores]\n"{key}" = ["INE", "FRM", "LIM"]\n')
    _, out, _ = kinlint("lamp.urdf", *ONLY, "--output-format", "json")

    assert sorted(each["code"] for each in json.loads(out)) == left


def test_standard_input_is_recognised_by_content(kinlint, monkeypatch):
    """With a name and without."""
    for more, name in (((), "<stdin>"), (("--stdin-filename", "a/b.urdf"), "a/b.urdf")):
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(ROBOT.encode())))
        code, out, _ = kinlint("-", *more, "--select", "LIM001", "--output-format", "concise")

        assert code == 1
        assert out.startswith(f"{name}:8:19: error: [*!] <limit> of joint 'elbow': lower limit 3")


def test_columns_count_characters(kinlint, write):
    """Whatever the encoding, the ends of lines, and the length of a character."""
    text = '<robot name="r">\r\n\t<link name="🦾"/>\t<!--🦾🦾--><link name="🦾"/>\r\n</robot>'
    path = write("a.urdf")
    for data in (text.encode(), text.encode("utf-16")):
        path.write_bytes(data)
        _, out, _ = kinlint("a.urdf", "--select", "ID001", "--output-format", "concise")

        assert out.startswith("a.urdf:2:40: error: ")


def test_what_never_ends_is_no_model(kinlint, lamp, monkeypatch):
    """A device in the place of a file, through a pipe or by its name."""
    monkeypatch.setattr(reading, "MOST_BYTES", 100)
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"\0" * 200)))
    for path in ("-", "lamp.urdf"):
        code, out, err = kinlint(path, "--output-format", "concise")

        assert code == 2
        assert "more than 0 MiB" in out + err


GEARS = """\
<sdf version="1.9">
  <model name="arm">
    <link name="base"/><link name="wheel"/><link name="hand"/>
    <joint name="a" type="revolute">
      <parent>base</parent><child>wheel</child>
      <axis><xyz>0 0 1</xyz></axis>
    </joint>
    <joint name="b" type="revolute">
      <parent>base</parent><child>hand</child>
      <axis><xyz>0 0 -1</xyz></axis>
    </joint>
    <joint name="g" type="gearbox">
      <parent>wheel</parent><child>hand</child>
      <gearbox_reference_body>base</gearbox_reference_body>
      <gearbox_ratio>3</gearbox_ratio>
      <axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 0 -1</xyz></axis2>
    </joint>
  </model>
</sdf>
"""
GEARED = '''\
@prefix kin:  <https://w3id.org/kinlint/kinematics#> .
@prefix kl:   <https://w3id.org/kinlint/ns#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
@prefix sh:   <http://www.w3.org/ns/shacl#> .

<https://example.org/rules/geared> a kl:Rule, sh:NodeShape ;
    kl:code "ACME001" ;
    rdfs:label "gears" ;
    rdfs:comment "Gears have play." ;
    kl:format "sdf" ;
    sh:severity sh:Warning ;
    sh:targetSubjectsOf kin:multiplier ;
    sh:sparql [
        sh:message "Joints are geared by {?value}." ;
        sh:select """
            SELECT $this (kin:multiplier AS ?path) ?value WHERE { $this kin:multiplier ?value }
            """ ] .
'''


@pytest.mark.slow
def test_a_value_computed_from_several_elements_shows_all_of_them(kinlint, write):
    """The finding is at the first of them, here the ratio; its sign follows from axes."""
    write("gears.sdf", GEARS)
    write("rules/geared.ttl", GEARED)
    words = ("gears.sdf", "--rules", "rules", "--select", "ACME001", "--output-format")
    said = [
        (16, "<xyz> of joint 'g' is given here"),
        (16, "<xyz> of <axis2> of joint 'g' is given here"),
        (10, "<xyz> of joint 'b' is given here"),
        (6, "<xyz> of joint 'a' is given here"),
    ]

    (found,) = json.loads(kinlint(*words, "json")[1])
    assert found["location"]["row"] == 15
    assert [(each["location"]["row"], each["message"]) for each in found["related"]] == said
    (result,) = json.loads(kinlint(*words, "sarif")[1])["runs"][0]["results"]
    assert [
        (each["physicalLocation"]["region"]["startLine"], each["message"]["text"])
        for each in result["relatedLocations"]
    ] == said
    (diagnostic,) = json.loads(kinlint(*words, "rdjson")[1])["diagnostics"]
    assert [
        (each["location"]["range"]["start"]["line"], each["message"])
        for each in diagnostic["related_locations"]
    ] == said
    for form in ("full", "html"):
        text = unescape(kinlint(*words, form)[1])
        assert all(message in text for _, message in said), form
