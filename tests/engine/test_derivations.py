"""Findings that rest on inferred triples show what is written, where it is written."""

from __future__ import annotations

from pathlib import Path

import pytest
from data import locate_data
from support.linting import book, lint

from kinlint.catalogue import rulebook
from kinlint.document import Document
from kinlint.engine.closure import close
from kinlint.engine.evaluate import check
from kinlint.engine.explanation import premises_of
from kinlint.engine.store import Store
from kinlint.facts.computation import facts
from kinlint.finding import Finding
from kinlint.findings.finding_builder import findings
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode, read
from kinlint.reporters.sarif.sarif_log import log
from kinlint.terms import RDF_TYPE
from kinlint.text import SourceText

SAMPLES = Path(__file__).parents[1] / "samples"
BROKEN = sorted((SAMPLES / "broken").glob("*.jsonld"))
BOOK = book()
PUBLISHED = {
    "tutorial": ("comp-rob2b", "modelling-tutorial", "models"),
    "Kinova Gen3": ("comp-rob2b", "robot-models"),
}


@pytest.fixture(params=[*BROKEN, *PUBLISHED], ids=lambda each: getattr(each, "stem", each))
def files(request: pytest.FixtureRequest) -> list[Path]:
    if isinstance(request.param, Path):
        return [request.param]
    return sorted(locate_data(*PUBLISHED[request.param]).rglob("*.json"))


def closed(documents: list[Document]) -> Store:
    store = Store()
    store.load(documents)
    store.load_vocabulary(BOOK.vocabulary)
    close(store, BOOK.axioms)
    store.state(facts(store))
    return store


def judged(files: list[Path]) -> list[tuple[Finding, bool]]:
    """The findings about *files*, each with whether something inferred was matched for it.

    Classes that metamodels alone imply are not told.
    """
    documents = [read(decode(str(file), file.read_bytes()), ReadOptions()) for file in files]
    store = closed(documents)
    return [
        (
            finding,
            any(
                inferred and premise[1] != RDF_TYPE
                for premise, inferred in premises_of(store, result.constraint, result)
            ),
        )
        for result in check(store, BOOK.constraints)
        for finding in findings([result], documents, store, BOOK)
    ]


def test_whatever_was_inferred_is_traced_to_what_is_written(files):
    """Every proof ends in triples with a place, and nothing that follows stands alone."""
    for finding, inferred in judged(files):
        assert bool(finding.because) >= inferred, finding.message
        for premise, following in zip(finding.because, finding.because[1:], strict=False):
            assert bool(premise.axiom) == (premise.location is None), finding.message
            assert not premise.axiom.startswith("every") or following.depth > premise.depth
        if inferred:
            assert any(premise.location for premise in finding.because)


def test_code_flows_lead_through_the_lines_of_what_is_written():
    """From the properties and types in the file to the line of the finding."""
    text = """{
      "@context": ["https://w3id.org/kinlint/composable.json", {"ex": "https://e.org/#"}],
      "@graph": [
        {
          "@id": "ex:flange",
          "@type": "SimplicialComplex",
          "vector-z": "ex:z"
        }
      ]
    }"""
    report = lint(text, "arm.jsonld")

    results = log(report)["runs"][0]["results"]
    (result,) = (each for each in results if each["ruleId"] == "LD012")
    (flow,) = result["codeFlows"][0]["threadFlows"]
    steps = [
        (
            step["location"]["message"]["text"],
            step["location"]["physicalLocation"]["region"]["startLine"],
        )
        for step in flow["locations"]
    ]
    assert ("ex:flange vector-z ex:z", 7) in steps
    assert ("ex:flange is a SimplicialComplex", 6) in steps
    assert steps[-1][1] == 7
    derived = "ex:flange is a CoordinateFrame (whatever has basis-vector is a CoordinateFrame)"
    assert (derived, 7) in steps


def test_a_finding_about_an_inferred_triple_is_where_that_comes_from():
    """The type that a property implies is shown at the property, in whichever file it stands."""
    context = '"@context": ["https://w3id.org/kinlint/composable.json", {"ex": "https://e.org/#"}]'
    files = [
        SourceText("a.jsonld", f'{{ {context}, "@id": "ex:tip", "@type": "SimplicialComplex" }}'),
        SourceText("b.jsonld", f'{{ {context}, "@id": "ex:flange", "origin": "ex:tip" }}'),
    ]

    report = lint(files)

    (finding,) = (each for each in report.findings if each.rule.code == "LD012")
    assert finding.location.source.name == "b.jsonld"
    assert finding.location.source.text[finding.location.span.start :].startswith('"ex:tip"')
    assert finding.focus == "<https://e.org/#tip>"


def test_what_metamodels_alone_imply_is_left_out():
    """Who writes `PositionCoordinate` knows that it is a coordinate."""
    context = '"@context": ["https://w3id.org/kinlint/composable.json", {"ex": "https://e.org/#"}]'
    text = f'{{ {context}, "@id": "ex:reach", "@type": ["PositionCoordinate", "VectorXYZ"] }}'

    report = lint(text, "a.jsonld")

    (finding,) = (each for each in report.findings if each.rule.code == "UNI001")
    assert finding.because == ()


def test_a_contradiction_shows_its_premises_in_every_file():
    """Also where all of them are written and nothing was inferred, and each of them once."""
    context = '"@context": ["https://w3id.org/kinlint/composable.json", {"ex": "https://e.org/#"}]'
    joint = '"@id": "ex:weld", "@type": ["Joint", "FixedJoint"]'
    files = [
        SourceText("a.jsonld", f"{{ {context}, {joint} }}"),
        SourceText("b.jsonld", f'{{ {context}, "@id": "ex:weld", "kc:common-axis": {{}} }}'),
        SourceText("c.jsonld", f'{{ {context}, "@id": "ex:tool", "@type": "Pose" }}'),
        SourceText("d.jsonld", f'{{ {context}, "@id": "ex:tool", "@type": "VelocityTwist" }}'),
    ]

    report = lint(files)

    shown = {
        finding.rule.code: sorted(
            (each.location.source.name, each.statement) for each in finding.because if each.location
        )
        for finding in report.findings
    }
    assert shown["LD019"] == [
        ("a.jsonld", "ex:weld is a FixedJoint"),
        ("b.jsonld", "ex:weld common-axis an anonymous node"),
    ]
    assert shown["LD012"] == [
        ("c.jsonld", "ex:tool is a Pose"),
        ("d.jsonld", "ex:tool is a VelocityTwist"),
    ]


@pytest.mark.parametrize(
    ("types", "told"),
    [
        ('"UnitLength"', "UnitLength"),
        ('"Vector"', "Vector"),
        ('"UnitLength", "BoundVector"', "BoundVector"),
    ],
)
def test_disjoint_types_are_those_that_are_written(types: str, told: str) -> None:
    """Who writes `UnitLength` does not know that it is a vector."""
    context = '"@context": ["https://w3id.org/kinlint/composable.json", {"ex": "https://e.org/#"}]'

    report = lint(f'{{ {context}, "@id": "ex:tool", "@type": ["Frame", {types}] }}', "a.jsonld")

    (finding,) = (each for each in report.findings if each.rule.code == "LD012")
    assert f"is of type '{told}' and of type" in finding.message


@pytest.mark.slow
def test_what_nobody_describes_is_shown_where_it_is_mentioned(tmp_path):
    """An axiom may say what it is, and a rule complain about that."""
    axioms = tmp_path / "axioms.ttl"
    axioms.write_text(
        "<https://e.org/#stops> <http://www.w3.org/2000/01/rdf-schema#range> "
        "<https://comp-rob2b.github.io/metamodels/kinematic-chain/structural-entities#Joint> ."
    )
    context = '"@context": ["https://w3id.org/kinlint/composable.json", {"ex": "https://e.org/#"}]'
    text = f'{{ {context}, "@id": "ex:stop", "ex:stops": {{"@id": "ex:belt"}} }}'

    rules = rulebook.load([], [axioms], None)
    report = lint(text, "a.jsonld", rules=rules)

    (cause,) = (each for each in report.findings if each.rule.code == "LD006")
    (finding,) = cause.consequences
    assert finding.rule.code == "TOP005"
    assert text[finding.location.span.start :].startswith('"ex:belt"')
