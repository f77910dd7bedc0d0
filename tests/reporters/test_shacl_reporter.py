"""The validation report in Turtle, read again by an RDF library."""

from __future__ import annotations

from dataclasses import replace

import pyoxigraph as ox
import pytest
from hypothesis import given
from reported import BOTH, DISPLAY, INERTIA_FINDING, PLAIN, UNSAFE, report, reports

from kinlint.errors import SourceError
from kinlint.report import Report
from kinlint.reporters.terminal_style import Style
from kinlint.reporters.validation_report import PREFIXES, render

PREFIX = "".join(f"PREFIX {name}: <{iri}>\n" for name, iri in PREFIXES.items())


def store(made: Report, style: Style = PLAIN) -> ox.Store:
    text = "".join(render(made, style))
    assert style.unicode or text.isascii()
    graph = ox.Store()
    graph.load(text.encode("utf-8", "replace"), format=ox.RdfFormat.TURTLE)
    return graph


def rows(graph: ox.Store, query: str) -> list[tuple[str, ...]]:
    found = graph.query(PREFIX + query)
    assert isinstance(found, ox.QuerySolutions)
    return [tuple("" if term is None else term.value for term in row) for row in found]


RESULTS = """
SELECT ?severity ?focus ?shape ?file ?line ?column WHERE {
    ?report a sh:ValidationReport ; sh:result ?result .
    ?result a sh:ValidationResult ; sh:resultSeverity ?severity ; sh:focusNode ?focus ;
        sh:resultMessage ?message ; sh:sourceConstraintComponent ?component ;
        kl:file ?file ; kl:line ?line ; kl:column ?column
    OPTIONAL { ?result sh:sourceShape ?shape }
} ORDER BY ?line"""


def test_a_finding_is_a_result_with_a_place() -> None:
    assert rows(store(BOTH), RESULTS) == [
        (
            "http://www.w3.org/ns/shacl#Violation",
            "https://example.org/robot#link2-inertia",
            "https://w3id.org/kinlint/rules/inertia-seen-by-foreign-frame",
            "models/dynamics.jsonld",
            "7",
            "21",
        ),
        (
            "http://www.w3.org/ns/shacl#Warning",
            "https://example.org/robot#length",
            "https://w3id.org/kinlint/rules/unit-quantity-mismatch",
            "models/dynamics.jsonld",
            "8",
            "15",
        ),
    ]


def test_a_report_conforms_if_there_is_nothing_to_say() -> None:
    """What is suppressed counts as nothing, what cannot be read does not."""
    query = "SELECT ?conforms WHERE { ?report sh:conforms ?conforms }"
    silent = replace(INERTIA_FINDING, suppressed="known")
    unread = report(errors=(SourceError("a b.jsonld", "no JSON", 3),))
    assert rows(store(Report()), query) == [("true",)]
    assert rows(store(report(silent)), query) == [("true",)]
    assert rows(store(BOTH), query) == [("false",)]
    assert rows(store(unread), query) == [("false",)]
    assert rows(store(unread), RESULTS)[0][1] == "urn:kinlint:document:a%20b.jsonld"


def test_path_and_value_are_the_terms_of_the_model() -> None:
    finding = replace(INERTIA_FINDING, path="<https://example.org/p>", value='"1 \\"m\\""')
    query = "SELECT ?path ?value WHERE { ?result sh:resultPath ?path ; sh:value ?value }"
    assert rows(store(report(finding)), query) == [("https://example.org/p", '1 "m"')]


SUGGESTIONS = """
SELECT ?order ?title ?trust ?why ?s ?p ?o ?new WHERE {
    ?result dash:suggestion ?update .
    ?update a dash:GraphUpdate ; sh:order ?order ; sh:message ?title ; kl:applicability ?trust ;
        dash:deletedTriple [ rdf:subject ?s ; rdf:predicate ?p ; rdf:object ?o ] ;
        dash:addedTriple [ rdf:object ?new ]
    OPTIONAL { ?update rdfs:comment ?why }
} ORDER BY ?order"""


def test_fixes_are_suggested_graph_updates() -> None:
    """As DASH has them, the preferred first, each with how far it may be trusted."""
    old, new = (
        ("<https://example.org/s>", "<https://example.org/p>", value) for value in ('"1"', '"2"')
    )
    fixes = tuple(replace(one, removed=(old,), added=(new,)) for one in (UNSAFE, DISPLAY))
    title = "Express it in frame 'rob:link2-root'"
    triple = "https://example.org/s", "https://example.org/p", "1", "2"
    kl = PREFIXES["kl"]
    assert rows(store(report(replace(INERTIA_FINDING, fixes=fixes))), SUGGESTIONS) == [
        ("1", title, f"{kl}unsafe", "The numbers stay as they are.", *triple),
        ("2", title, f"{kl}displayOnly", "Nobody knows.", *triple),
    ]


@pytest.mark.slow
@given(reports())
def test_any_report_is_turtle(made: Report) -> None:
    """Whatever stands in names, messages and terms; in ASCII, too."""
    count = "SELECT (COUNT(?r) AS ?n) WHERE { ?report sh:result ?r }"
    for style in (PLAIN, Style(unicode=False)):
        assert rows(store(made, style), count) == [(str(len(made.findings)),)]
