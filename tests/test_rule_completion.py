"""What all rules say is left out of their files, and is there again for whoever reads them."""

from __future__ import annotations

import pytest
from pyshacl import validate
from rdflib import OWL, RDF, SH, Graph, Namespace

from kinlint.catalogue.rule_file import read_rules
from kinlint.catalogue.shacl_export import shacl
from kinlint.cli.main import main
from kinlint.resources import data

KL = Namespace("https://w3id.org/kinlint/ns#")
DASH = Namespace("http://datashapes.org/dash#")
HEAD = """
    @prefix dash: <http://datashapes.org/dash#> .
    @prefix kl: <https://w3id.org/kinlint/ns#> .
    @prefix owl: <http://www.w3.org/2002/07/owl#> .
    @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
    @prefix rule: <https://w3id.org/kinlint/rules/> .
    @prefix sh: <http://www.w3.org/ns/shacl#> .
    """
SHORT = (
    HEAD
    + """
    rule:own a kl:Rule, sh:NodeShape ;
        kl:code "OWN001" ; kl:symptom "AP2.3" ; kl:format "graph", "urdf" ;
        sh:sparql [
            sh:message \"\"\"
                Limit '{$this}'
                is empty.
                \"\"\" ;
            sh:select "SELECT $this { $this kin:lower ?value }" ] ;
        dash:suggestionGenerator [
            rdfs:label "Fill it" ; kl:applicability kl:safe ;
            sh:update "INSERT { $this kin:lower 1 } WHERE {}" ] .
    """
)
LONG = (
    HEAD
    + """
    <> owl:imports <../../shapes/prefixes.ttl> .
    rule:own a kl:Rule, sh:NodeShape ;
        kl:code "OWN001" ; kl:symptom "AP2.3" ; kl:antiPattern kl:AP2 ;
        kl:format "jsonld", "turtle", "urdf" ;
        sh:sparql [
            sh:message "Limit '{$this}' is empty." ;
            sh:prefixes kl:prefixes ;
            sh:select "SELECT $this { $this kin:lower ?value }" ] ;
        dash:suggestionGenerator [
            a dash:SPARQLUpdateSuggestionGenerator ;
            rdfs:label "Fill it" ; kl:applicability kl:safe ;
            sh:prefixes kl:prefixes ;
            sh:update "INSERT { $this kin:lower 1 } WHERE {}" ] .
    """
)


def test_the_short_and_the_long_form_are_one_rule(tmp_path) -> None:
    """Files that say everything go on working."""
    file = tmp_path / "own.ttl"
    rules = []
    for text in (SHORT, LONG):
        file.write_text(text, "utf-8")
        rules += read_rules(file)

    assert rules[0] == rules[1]
    assert rules[0].antipatterns == ("AP2",)
    assert rules[0].formats == ("jsonld", "turtle", "urdf")
    assert rules[0].messages == ("Limit '{$this}' is empty.",)


@pytest.mark.parametrize("file", sorted(data("rules").glob("*/*.ttl")), ids=lambda file: file.stem)
def test_no_built_in_rule_states_what_follows(file) -> None:
    """What the file does not say twice cannot contradict itself."""
    graph = Graph().parse(file)
    (rule,) = graph.subjects(RDF.type, KL.Rule)
    families = {KL[each.partition(".")[0]] for each in graph.objects(rule, KL.symptom)}

    assert not families.intersection(graph.objects(rule, KL.antiPattern))
    assert not {"jsonld", "turtle"} <= set(map(str, graph.objects(rule, KL.format)))
    assert not set(graph.predicates()) & {SH.prefixes, OWL.imports, KL.since}
    assert (None, RDF.type, DASH.SPARQLUpdateSuggestionGenerator) not in graph


def test_plain_shapes_are_left_as_they_are(tmp_path) -> None:
    """Only rules are completed: a shape with SPARQL of its own names its prefixes itself."""
    file = tmp_path / "shape.ttl"
    text = SHORT.replace("kl:Rule, ", "")
    file.write_text(text, "utf-8")

    assert "sh:prefixes" not in shacl([file]).partition("OWN001")[2]


@pytest.mark.parametrize(("lower", "upper", "conforms"), [(2, 1, False), (1, 2, True)])
def test_plain_pyshacl_runs_what_is_printed(capsys, lower, upper, conforms) -> None:
    """`kinlint rule CODE --output-format turtle` needs no other file."""
    assert main(["rule", "LIM001", "--output-format", "turtle"]) == 0
    shapes = Graph().parse(data=capsys.readouterr().out, format="turtle")
    kin = "https://w3id.org/kinlint/kinematics#"
    stated = f"<urn:a> a <{kin}Limit> ; <{kin}lower> {lower} ; <{kin}upper> {upper} ."

    verdict, _, report = validate(Graph().parse(data=stated, format="turtle"), shacl_graph=shapes)

    assert verdict is conforms
    assert conforms or "is above upper limit" in report


@pytest.mark.slow
def test_every_rule_can_be_printed() -> None:
    """As Turtle that rdflib reads, with the prefixes of its queries."""
    for file in sorted(data("rules").glob("*/*.ttl")):
        assert "kl:prefixes" in shacl([file])
    assert len(Graph().parse(data=shacl(sorted(data("rules").glob("*/*.ttl"))), format="turtle"))
