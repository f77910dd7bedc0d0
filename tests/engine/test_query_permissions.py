"""Queries of rules and shapes reach no network and no file, however they ask for it."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path

import pytest

from kinlint.cli.main import main

ROBOT = '<robot name="arm"><link name="base"/></robot>'
PREFIXES = """
@prefix sh: <http://www.w3.org/ns/shacl#> .
@prefix ex: <https://example.org/#> .
@prefix kl: <https://w3id.org/kinlint/ns#> .
@prefix kc: <https://comp-rob2b.github.io/metamodels/kinematic-chain/structural-entities#> .
@prefix geom: <https://comp-rob2b.github.io/metamodels/geometry/structural-entities#> .
@prefix dash: <http://datashapes.org/dash#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
@prefix rule: <https://w3id.org/kinlint/rules/> .
@prefix owl: <http://www.w3.org/2002/07/owl#> .
"""
SHAPE = (
    PREFIXES
    + 'ex:S a sh:NodeShape ; sh:targetClass geom:RigidBody ; sh:sparql [ sh:select """%s""" ] .'
)
COUNT = (
    PREFIXES
    + """@prefix xsd: <http://www.w3.org/2001/XMLSchema#> .
ex:S a sh:NodeShape ; sh:targetClass geom:RigidBody ;
    sh:property [ sh:path ex:p ; sh:minCount %s ] ."""
)
TARGET = (
    PREFIXES
    + """
ex:S a sh:NodeShape ; sh:nodeKind sh:Literal ;
    sh:target [ a sh:SPARQLTarget ; sh:select \"\"\"%s\"\"\" ] ."""
)
FUNCTION = (
    PREFIXES
    + """
ex:f a sh:SPARQLFunction ; sh:returnType <http://www.w3.org/2001/XMLSchema#boolean> ;
    sh:ask \"\"\"%s\"\"\" .
ex:S a sh:NodeShape ; sh:targetClass geom:RigidBody ;
    sh:sparql [ sh:select "SELECT $this { $this a ?x FILTER (<https://example.org/#f>()) }" ] ."""
)
VALIDATOR = (
    PREFIXES
    + """
ex:C a sh:ConstraintComponent ; sh:parameter [ sh:path ex:c ] ;
    sh:nodeValidator [ a sh:SPARQLSelectValidator ; sh:select \"\"\"%s\"\"\" ] .
ex:S a sh:NodeShape ; sh:targetClass geom:RigidBody ; ex:c true ."""
)
INFERENCE = (
    PREFIXES
    + """
ex:S a sh:NodeShape ; sh:targetClass geom:RigidBody ; sh:nodeKind sh:Literal ;
    sh:rule [ a sh:SPARQLRule ; sh:construct \"\"\"%s\"\"\" ] ."""
)
REPAIR = (
    PREFIXES
    + """
rule:mine a kl:Rule, sh:NodeShape ; kl:code "USR001" ; rdfs:label "mine" ;
    sh:targetClass geom:RigidBody ;
    sh:sparql [ sh:message "x" ; sh:select "SELECT $this WHERE { $this a ?class }" ] ;
    dash:suggestionGenerator [
        rdfs:label "do" ; kl:applicability kl:safe ; sh:update \"\"\"%s\"\"\" ] ."""
)

CALL = "SERVICE <%s> { ?s ?p ?o }"
SILENT = CALL.replace("SERVICE", "SERVICE SILENT")
ESCAPED = CALL.replace("V", r"\\u0056")
ELSEWHERE = {
    "plain": f"SELECT $this WHERE {{ $this a ?class {CALL} }}",
    "silent": f"SELECT $this WHERE {{ $this a ?class {SILENT} }}",
    "lower case": f"SELECT $this WHERE {{ $this a ?class {CALL.lower()} }}",
    "escaped": f"SELECT $this WHERE {{ $this a ?class {ESCAPED} }}",
    "sub-select": f"SELECT $this WHERE {{ {{ SELECT $this {{ $this a ?x {CALL} }} }} }}",
    "exists": f"SELECT $this WHERE {{ $this a ?x FILTER EXISTS {{ {CALL} }} }}",
    "having": f"SELECT $this WHERE {{ $this a ?x }} GROUP BY $this HAVING (EXISTS {{ {CALL} }})",
    "order": f"SELECT $this WHERE {{ $this a ?x }} ORDER BY (EXISTS {{ {CALL} }})",
    "bind": f"SELECT $this WHERE {{ $this a ?x BIND (EXISTS {{ {CALL} }} AS ?y) }}",
    "projection": f"SELECT $this (EXISTS {{ {CALL} }} AS ?y) WHERE {{ $this a ?x }}",
    "optional": f"SELECT $this WHERE {{ $this a ?x OPTIONAL {{ {CALL} }} }}",
    "variable": "SELECT $this WHERE { $this a ?x BIND (<%s> AS ?u) SERVICE ?u { ?s ?p ?o } }",
    "from": "SELECT $this FROM <%s> WHERE { $this a ?x }",
    "from named": "SELECT $this FROM NAMED <%s> WHERE { $this a ?x }",
    "graph": "SELECT $this WHERE { $this a ?x GRAPH <%s> { ?s ?p ?o } }",
    "function": "SELECT $this WHERE { $this a ?x FILTER (<%s>(?x)) }",
    "nested function": "SELECT $this WHERE { $this a ?x FILTER (STR(<%s>(?x)) = '') }",
}
UPDATES = {
    "load": "LOAD <%s>",
    "load silent": "LOAD SILENT <%s>",
    "service": "INSERT { $this ?p ?o } WHERE { SERVICE <%s> { ?s ?p ?o } }",
    "using": "INSERT { $this a ?o } USING <%s> WHERE { $this a ?o }",
    "with": "WITH <%s> INSERT { $this a ?o } WHERE { $this a ?o }",
    "graph": "INSERT { $this a ?o } WHERE { GRAPH <%s> { $this a ?o } }",
    "into": "INSERT { GRAPH <%s> { $this a ?o } } WHERE { $this a ?o }",
}
SCRIPT = (
    PREFIXES
    + """
ex:S a sh:NodeShape ; sh:targetClass geom:RigidBody ;
    sh:js [ sh:jsFunctionName "f" ; sh:jsLibrary [ sh:jsLibraryURL "%s" ] ] ."""
)
IMPORT = PREFIXES + "<%s> a owl:Ontology ; owl:imports <%s> ."


@pytest.fixture
def listening() -> Iterator[tuple[str, list[str]]]:
    """The address of a server, and the requests that reach it."""
    received: list[str] = []

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self) -> None:
            received.append(self.path)
            self.send_response(200)
            self.end_headers()

        do_POST = do_HEAD = do_GET  # noqa: N815

        def log_message(self, *_: object) -> None:
            pass

    server = HTTPServer(("127.0.0.1", 0), Handler)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    yield f"http://127.0.0.1:{server.server_port}/secret", received
    server.shutdown()
    thread.join()
    server.server_close()


@pytest.fixture
def refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> Callable[..., str]:
    """Lint a robot with a shapes or rule file that is refused; the complaint."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    robot = tmp_path / "arm.urdf"
    robot.write_text(ROBOT, "utf-8")

    def run(option: str, text: str, *more: str) -> str:
        file = tmp_path / "mine.ttl"
        file.write_text(text, "utf-8")
        given = str(file if option == "--shapes" else tmp_path)
        code = main([str(robot), option, given, "--isolated", *more])
        error = capsys.readouterr().err
        assert code == 2, error
        assert "mine.ttl" in error
        return error

    return run


FORMS = {"constraint": SHAPE, "target": TARGET, "function": FUNCTION, "component": VALIDATOR}
PLACES = [pytest.param(SHAPE, "pyshacl", id="pyshacl", marks=pytest.mark.slow)]
PLACES += [
    pytest.param(form, "oxigraph", id=name, marks=pytest.mark.slow if number else ())
    for number, (name, form) in enumerate(FORMS.items())
]


@pytest.mark.slow
@pytest.mark.parametrize(("form", "engine"), PLACES)
@pytest.mark.parametrize("trick", ELSEWHERE.values(), ids=ELSEWHERE)
def test_no_query_reaches_beyond_the_model(
    trick: str,
    form: str,
    engine: str,
    listening: tuple[str, list[str]],
    refused: Callable[..., str],
) -> None:
    address, received = listening
    query = trick % address
    if form is FUNCTION:
        query = f"ASK {{ {{ {query.replace('$this', '?this')} }} }}"
    refused("--shapes", form % query, "--engine", engine)
    assert received == []


@pytest.mark.slow
@pytest.mark.parametrize("scheme", ["http", "file"])
def test_an_inference_rule_reaches_nothing(
    scheme: str, listening: tuple[str, list[str]], refused: Callable[..., str]
) -> None:
    address, received = listening
    place = address if scheme == "http" else "file:///etc/hostname"
    query = f"CONSTRUCT {{ $this a ?o }} WHERE {{ SERVICE <{place}> {{ ?s ?p ?o }} }}"
    assert "SERVICE is not allowed" in refused("--shapes", INFERENCE % query)
    assert received == []


@pytest.mark.slow
@pytest.mark.parametrize("trick", UPDATES.values(), ids=UPDATES)
def test_no_repair_reaches_beyond_the_model(
    trick: str, listening: tuple[str, list[str]], refused: Callable[..., str]
) -> None:
    address, received = listening
    refused("--rules", REPAIR % (trick % address))
    assert received == []


@pytest.mark.slow
def test_no_script_is_loaded(listening: tuple[str, list[str]], refused: Callable[..., str]) -> None:
    address, received = listening
    assert "scripts are not run" in refused("--shapes", SCRIPT % address)
    assert received == []


@pytest.mark.slow
def test_nothing_is_imported(
    listening: tuple[str, list[str]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    address, received = listening
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    robot, shapes = tmp_path / "arm.urdf", tmp_path / "mine.ttl"
    robot.write_text(ROBOT, "utf-8")
    shapes.write_text(IMPORT % ("https://example.org/mine", address), "utf-8")
    main([str(robot), "--shapes", str(shapes), "--isolated", "--engine", "pyshacl"])
    assert received == []


@pytest.mark.slow
@pytest.mark.parametrize(
    ("call", "code"),
    [
        ("<http://www.w3.org/2001/XMLSchema#integer>('4') > 1", 1),
        ("<http://www.w3.org/2005/xpath-functions/math#sqrt>(4) > 1", 2),
        ("<https://example.org/#f>()", 0),
        ("1 < (1 + 1)", 1),
    ],
)
def test_casts_and_functions_of_the_file_may_be_called(
    call: str, code: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    robot, shapes = tmp_path / "arm.urdf", tmp_path / "mine.ttl"
    robot.write_text(ROBOT, "utf-8")
    text = FUNCTION.replace("<https://example.org/#f>()", call) % "ASK { FILTER (1 > 2) }"
    shapes.write_text(text, "utf-8")
    assert main([str(robot), "--shapes", str(shapes), "--isolated"]) == code


@pytest.mark.slow
@pytest.mark.parametrize(
    ("shape", "cause"),
    [
        (SHAPE % "SELECT $this { $this ?p '\\\\UFFFFFFFF' }", "no character of Unicode"),
        (COUNT % '"x"^^xsd:integer', "sh:minCount is not a whole number"),
        (COUNT % f'"1 {CALL % "http://a"}"^^xsd:integer', "sh:minCount is not a whole number"),
        (COUNT % ("1" * 5_000), "sh:minCount is not a whole number"),
    ],
    ids=["escape", "word", "injection", "digits"],
)
def test_what_is_no_number_and_no_character_is_refused(
    shape: str, cause: str, refused: Callable[..., str]
) -> None:
    assert cause in refused("--shapes", shape)
