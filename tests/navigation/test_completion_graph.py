"""Completion in JSON-LD and Turtle."""

import json

import pytest
from completing import Typing

CONTEXT = [
    "https://w3id.org/kinlint/composable.json",
    {"ex": "https://example.org/arm#", "kl": "https://w3id.org/kinlint/ns#"},
]
NODES = [
    {"@id": "ex:base", "@type": "Frame", "origin": "ex:base-origin"},
    {"@id": "ex:base-origin", "@type": "Point"},
    {
        "@id": "ex:offset",
        "@type": ["PositionReference", "PositionCoordinate", "VectorXYZ"],
        "of-position": "ex:offset-relation",
        "as-seen-by": "ex:base",
        "unit": "M",
        "x": 1.0,
    },
    {"@id": "ex:elbow", "@type": ["Joint", "RevoluteJoint"], "common-axis": "ex:axis"},
]
MODEL = json.dumps({"@context": CONTEXT, "@graph": NODES}, indent=1)


@pytest.fixture(scope="module")
def arm(tmp_path_factory):
    return Typing(tmp_path_factory.mktemp("arm"), {"arm.jsonld": MODEL})


def test_keys_by_type(arm):
    found = arm.candidates('arm.jsonld: "common-axis": "ex:axis" => "|')
    labels = [each.label for each in found]
    assert {"between-attachments", "origin-offset"} <= set(labels[:6])
    assert "@id" not in labels
    assert "Joint" not in labels
    key = next(each for each in found if each.label == "origin-offset")
    assert key.text == '"origin-offset": '


def test_keys_that_only_a_type_gives(arm):
    found = arm.labels('arm.jsonld: "of-position": "ex:offset-relation", => "|')
    assert found[0] == "of-position"


def test_units_by_what_is_measured(arm):
    found = arm.candidates('arm.jsonld: "unit": "M" => "unit": "|')
    assert "M" in [each.label for each in found[:30]]
    assert next(each for each in found if each.label == "M").text == '"M"'
    assert next(each for each in found if each.label == "M").rank == 0
    assert next(each for each in found if each.label == "KiloGM").rank > 0


def test_classes(arm):
    found = arm.labels('arm.jsonld: "@type": "Frame" => "@type": "|')
    assert {"Frame", "Joint", "SimplicialComplex"} <= set(found)
    assert "unit" not in found


def test_nodes_by_what_a_property_leads_to(arm):
    found = arm.candidates('arm.jsonld: "origin": "ex:base-origin" => "origin": "|"')
    assert (found[0].label, found[0].detail) == ("ex:base-origin", "Point")
    assert found[0].text == '"ex:base-origin"'


def test_names_that_are_used_and_not_described_yet(arm):
    found = arm.labels('arm.jsonld: "@id": "ex:elbow" => "@id": "|"')
    assert "ex:axis" in found
    assert "ex:base" not in found


def test_contexts_and_rules(arm):
    where = 'arm.jsonld: "https://w3id.org/kinlint/composable.json" => "|"'
    assert "https://w3id.org/kinlint/composable.json" in arm.labels(where)
    found = arm.labels('arm.jsonld: "common-axis": "ex:axis" => "kl:ignore": "|"')
    assert "FRM007" in found


TURTLE = """@prefix ex: <https://example.org/arm#> .
@prefix geom: <https://comp-rob2b.github.io/metamodels/geometry/structural-entities#> .
@prefix qudt: <http://qudt.org/schema/qudt/> .
@prefix unit: <http://qudt.org/vocab/unit/> .
@prefix kl: <https://w3id.org/kinlint/ns#> .

ex:base a geom:Frame ; geom:origin ex:base-origin .
ex:base-origin a geom:Point .
"""


@pytest.fixture(scope="module")
def turtle(tmp_path_factory):
    return Typing(tmp_path_factory.mktemp("turtle"), {"arm.ttl": TURTLE})


def test_turtle(turtle):
    where = "arm.ttl: ex:base-origin a geom:Point . => ex:base-origin a geom:Point . "
    assert "geom:Frame" in turtle.labels(f"{where}ex:x a geom:|")
    assert turtle.labels(f"{where}ex:x a geom:Frame ; geom:|")[0] == "geom:origin"
    assert turtle.labels(f"{where}ex:x geom:origin |")[0] == "ex:base-origin"
    assert "unit:M" in turtle.labels(f"{where}ex:x qudt:unit un|")
    found = turtle.candidates(f'{where}ex:x kl:ignore "F|')
    assert '"FRM007"' in [each.text for each in found]
    assert turtle.replaced(f"{where}ex:x geom:origin ex:ba|") == "ex:ba"
    assert turtle.labels(f"{where} # ex:|") == []
