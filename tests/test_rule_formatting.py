"""`kinlint format-rules`: one layout of rule files, and nothing but the layout."""

from __future__ import annotations

import re
from itertools import pairwise
from pathlib import Path
from textwrap import dedent

import pytest
from rdflib import RDFS, Graph, Literal, Namespace
from rdflib.compare import isomorphic

from kinlint.cli.main import main
from kinlint.formats.turtle.turtle_tokens import tokens
from kinlint.resources import data
from kinlint.rule_formatting.formatter import QUERIES, WIDTH, formatted
from kinlint.rule_formatting.sparql_layout import laid_out
from kinlint.rule_formatting.turtle_tree import Turtle

SH = Namespace("http://www.w3.org/ns/shacl#")
FOLDED = {RDFS.comment, SH.message, *(SH[name.partition(":")[2]] for name in QUERIES)}
RULES = sorted(data("rules").glob("*/*.ttl"))

LONGEST_CHECK = 40
"""The most lines of SPARQL in the check of one rule."""

UGLY = '''
    # A rule of ours.
    @prefix sh: <http://www.w3.org/ns/shacl#> .
    @prefix owl: <http://www.w3.org/2002/07/owl#> .
    @prefix kl: <https://w3id.org/kinlint/ns#> .
    @prefix rdfs:  <http://www.w3.org/2000/01/rdf-schema#> .
    @prefix rule: <https://w3id.org/kinlint/rules/> .
    rule:zero a kl:Rule , sh:NodeShape;
      rdfs:comment """Long ago somebody wrote a comment that went on and on, well beyond the hundredth
          column, and nobody minded.""" ;


      # Whom it is about.
      sh:targetClass kl:One , kl:Two ;
      sh:sparql [ sh:message "It is zero." ; sh:select """
        SELECT $this WHERE { # all of them
        $this kl:value ?value ; kl:first ?first ; kl:second ?second .
          FILTER (?value = 0 || ?first = 0 || ?second = 0 && ?value < ?first || ?first < ?second - 1)
        }""" ] , [ sh:message "Two." ; sh:select "SELECT $this {}" ] ;
      kl:example [ kl:bad """
        <robot>   [||]
    </robot>"""^^kl:urdf ; kl:beside "a.stl" , "b.stl" ] .
    '''  # noqa: E501

NEAT = '''
    # A rule of ours.
    @prefix kl:   <https://w3id.org/kinlint/ns#> .
    @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
    @prefix rule: <https://w3id.org/kinlint/rules/> .
    @prefix sh:   <http://www.w3.org/ns/shacl#> .

    rule:zero a kl:Rule, sh:NodeShape ;
        rdfs:comment """
            Long ago somebody wrote a comment that went on and on, well beyond the hundredth column, and
            nobody minded.
            """ ;

        # Whom it is about.
        sh:targetClass kl:One, kl:Two ;
        sh:sparql [
            sh:message "It is zero." ;
            sh:select """
                SELECT $this WHERE { # all of them
                    $this kl:value ?value ; kl:first ?first ; kl:second ?second .
                    FILTER (?value = 0 || ?first = 0 || ?second = 0 && ?value < ?first ||
                        ?first < ?second - 1)
                }
                """ ], [
            sh:message "Two." ;
            sh:select "SELECT $this {}" ] ;
        kl:example [
            kl:bad """
        <robot>   [||]
    </robot>"""^^kl:urdf ;
            kl:beside "a.stl", "b.stl" ] .
    '''  # noqa: E501


def meaning(text: str) -> Graph:
    """The graph of *text*; SPARQL and prose without their white space."""
    graph = Graph()
    for s, p, o in Graph().parse(data=text, format="turtle", publicID="file:///rule.ttl"):
        graph.add((s, p, Literal("".join(o.split())) if p in FOLDED else o))
    return graph


def without_examples(text: str) -> str:
    """*text* without its strings that have a datatype."""
    found = [*tokens(text)]
    for string, mark in reversed(list(pairwise(found))):
        if mark.text == "^^":
            text = text[: string.start] + text[string.end :]
    return text


def test_a_rule_file_is_laid_out() -> None:
    """Prefixes that are used, sorted; one indentation; comments where they stood."""
    assert formatted(dedent(UGLY)) == dedent(NEAT).lstrip("\n")


@pytest.mark.slow
@pytest.mark.parametrize("file", RULES, ids=lambda file: file.stem)
def test_only_the_layout_changes(file: Path) -> None:
    """The graph is the same, examples to the byte; what is formatted stays as it is."""
    text = file.read_text("utf-8")
    neat = formatted(text)

    assert isomorphic(meaning(neat), meaning(text))
    assert formatted(neat) == neat


def test_the_rules_are_formatted() -> None:
    """If not: `kinlint format-rules`."""
    assert main(["format-rules", "--check"]) == 0


def test_lines_are_short() -> None:
    """But in examples, and where a string or an IRI alone makes them long."""
    for file in RULES:
        text = without_examples(file.read_text("utf-8"))
        lines = re.sub(r'"[^"\n]*"|<[^>\n]*>', "x", text).split("\n")
        assert [line for line in lines if len(line) > WIDTH] == [], file


def test_a_rule_has_a_short_check() -> None:
    """A rule makes one judgement; what is data stands in `shapes/`."""
    for file in RULES:
        (rule,) = (each for each in Turtle(file.read_text("utf-8")).statements if each.properties)
        checks = (each for each in rule.properties if each.verb == "sh:sparql")
        constraints = [each for check in checks for each in check.objects]
        queries = [
            value.text
            for each in constraints
            for prop in each.properties
            for value in prop.objects
            if prop.verb in QUERIES
        ]
        lines = sum(max(1, query.count("\n") - 1) for query in queries)
        assert lines <= LONGEST_CHECK, file


def test_files_are_written_and_checked(tmp_path, capsys) -> None:
    """What would change is told; once it is changed, nothing is."""
    file = tmp_path / "zero.ttl"
    file.write_text(dedent(UGLY), "utf-8")

    assert main(["format-rules", "--check", str(tmp_path)]) == 1
    assert capsys.readouterr().out == f"would format {file}\n1 rule file: 1 would change.\n"
    assert file.read_text("utf-8") == dedent(UGLY)
    assert main(["format-rules", str(file)]) == 0
    assert file.read_text("utf-8") == dedent(NEAT).lstrip("\n")
    assert main(["format-rules", "--check", str(tmp_path)]) == 0


def test_what_cannot_be_formatted_is_refused(tmp_path, capsys) -> None:
    """No file, and no Turtle."""
    (tmp_path / "broken.ttl").write_text("rule:a kl:code 1", "utf-8")

    assert main(["format-rules", str(tmp_path / "none.ttl")]) == 2
    assert main(["format-rules", str(tmp_path)]) == 2
    assert "broken.ttl:1: " in capsys.readouterr().err


@pytest.mark.parametrize(
    ("query", "lines"),
    [
        ("SELECT ?a { ?a ?b ?c }", ["SELECT ?a { ?a ?b ?c }"]),
        (
            "SELECT ?a\n?b WHERE {\n?a ?b\n?c }",
            ["SELECT ?a", "    ?b WHERE {", "        ?a ?b", "        ?c }"],
        ),
        (
            "ASK {\n{ ?a ?b 1 }\nUNION\n{ ?a ?b 2 } }",
            ["ASK {", "    { ?a ?b 1 }", "    UNION", "    { ?a ?b 2 } }"],
        ),
        (
            "ASK {\n?a ?long ?value ; ?other ?value ; ?third ?value }",
            ["ASK {", "    ?a ?long ?value ; ?other ?value ;", "        ?third ?value }"],
        ),
        (
            "ASK {\nFILTER (\nEXISTS {\n?a ?b ?c\n}\n)\n}",
            [
                "ASK {",
                "    FILTER (",
                "        EXISTS {",
                "            ?a ?b ?c",
                "        }",
                "    )",
                "}",
            ],
        ),
        (
            "ASK {\n\n\n?a ?b ?c .\n\n\n?d ?e ?f }",
            ["ASK {", "", "    ?a ?b ?c .", "", "    ?d ?e ?f }"],
        ),
    ],
)
def test_sparql_is_indented_by_its_brackets(query: str, lines: list[str]) -> None:
    """Lines that are too long are broken at the best place; others stay as the author has them."""
    assert list(laid_out(query, 40)) == lines
