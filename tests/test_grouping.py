"""Rules with `kl:groupBy`: one finding for many places, with their count and where they are."""

import json
from dataclasses import replace
from pathlib import Path
from textwrap import dedent

import pytest
from support.linting import lint

from kinlint.catalogue.rule_file import read_rules
from kinlint.catalogue.rulebook import Rulebook
from kinlint.engine.compiler.shapes_compiler import compile_shapes
from kinlint.findings.grouping import grouped
from kinlint.formats.registry import decode
from kinlint.report import Report
from kinlint.reporters.full import render
from kinlint.reporters.terminal_style import Style

RULE = """
    @prefix kl:   <https://w3id.org/kinlint/ns#> .
    @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
    @prefix rule: <https://w3id.org/kinlint/rules/> .
    @prefix sh:   <http://www.w3.org/ns/shacl#> .
    @prefix ex:   <https://example.org/arm#> .

    rule:borrowed-mesh a kl:Rule, sh:NodeShape ;
        kl:code "TRY001" ;
        kl:format "jsonld" ;
        kl:groupBy GROUPING ;
        sh:severity sh:Warning ;
        sh:targetSubjectsOf ex:mesh ;
        sh:sparql [
            sh:message "Meshes are borrowed from '{?package}': '{?count}'." ;
            sh:select \"\"\"
                SELECT $this (<https://example.org/arm#mesh> AS ?path) ?value ?package WHERE {
                    $this <https://example.org/arm#mesh> ?value .
                    BIND (STRBEFORE(?value, "/") AS ?package)
                } \"\"\" ] .
    """


@pytest.fixture
def find(tmp_path: Path):
    """Lints links with meshes under a rule that groups."""

    def run(grouping, *files, engine="oxigraph", ignored=()):
        file = tmp_path / "borrowed-mesh.ttl"
        file.write_text(dedent(RULE).replace("GROUPING", grouping), "utf-8")
        book = Rulebook(read_rules(file), compile_shapes([file]), (), (), (file,))
        sources = [_source(f"{name}.jsonld", meshes, ignored) for name, meshes in files]
        return list(lint(sources, rules=book, engine=engine).findings)

    return run


def _source(name, meshes, ignored):
    nodes = [
        {"@id": f"ex:{name[0]}{number}", "ex:mesh": mesh}
        | ({"kl:ignore": "TRY001"} if number in ignored else {})
        for number, mesh in enumerate(meshes)
    ]
    namespaces = {"ex": "https://example.org/arm#", "kl": "https://w3id.org/kinlint/ns#"}
    text = json.dumps({"@context": namespaces, "@graph": nodes}, indent=0)
    return decode(name, text.encode())


ARM = "arm", ("a/1", "b/2", "a/3", "a/4", "b/5", "c/6")


@pytest.mark.parametrize("engine", ["oxigraph", "pyshacl"])
def test_places_that_agree_are_one_finding(find, engine):
    """The first stays, the others are related, and the message counts them."""
    found = find('"package"', ARM, engine=engine)

    assert [one.message for one in found] == [
        "Meshes are borrowed from 'a': 3.",
        "Meshes are borrowed from 'b': 2.",
        "Meshes are borrowed from 'c': 1.",
    ]
    assert [[_written(place.location) for place in one.related] for one in found] == [
        ['"a/3"', '"a/4"'],
        ['"b/5"'],
        [],
    ]
    assert [_written(one.location) for one in found] == ['"a/1"', '"b/2"', '"c/6"']


def _written(location):
    return location.source[location.span]


def test_several_variables_have_to_agree(find):
    """With the value itself, each mesh is a group of its own."""
    assert len(find('"package", "value"', ARM)) == 6


def test_a_file_may_be_one_group(find):
    """Then nothing has to agree."""
    (found,) = find('"file"', ARM)

    assert found.message == "Meshes are borrowed from 'a': 6."


def test_groups_end_with_the_file(find):
    """Each file is told of its own."""
    found = find('"package"', ("arm", ("a/1", "a/2")), ("leg", ("a/3",)))

    assert [one.location.source.name for one in found] == ["arm.jsonld", "leg.jsonld"]
    assert [one.arguments for one in found] == [("'a'", "2"), ("'a'", "1")]


def test_a_suppressed_place_is_in_no_group(find):
    """It neither counts nor hides the others."""
    found = find('"package"', ("arm", ("a/1", "a/2", "a/3")), ignored=(0,))

    assert [one.arguments for one in found] == [("'a'", "2")]
    assert _written(found[0].location) == '"a/2"'


def test_a_group_keeps_its_identity_when_it_grows(find):
    """So a baseline knows it again."""
    (small,) = find('"package"', ("arm", ("a/1",)))
    (large,) = find('"package"', ("arm", ("a/0", "a/1", "a/2")))

    assert small.fingerprint == large.fingerprint


def test_rules_without_groups_are_left_alone(find):
    """Every finding is told, in the order given."""
    found = find('"package"', ARM)
    alone = [replace(one, rule=replace(one.rule, group_by=())) for one in [*found, *found]]

    assert grouped(alone) == alone


def test_far_places_of_a_group_are_named_and_not_drawn(find):
    """However many there are."""
    found = find('"package"', ("arm", tuple(f"a/{number}" for number in range(40))))
    text = "".join(render(Report(tuple(found)), Style()))

    assert "note: the same at 38 other places: line" in text
    assert " and 28 more" in text
    assert ":::" not in text


@pytest.mark.parametrize(
    ("calls", "end"),
    [
        (1, "must be positive."),
        (6, "must be positive. This text is used 6 times."),
    ],
)
def test_what_a_macro_writes_is_told_once(tmp_path, calls, end):
    """However often it is called, and in whichever file it stands."""
    space = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
    wheel = '<link name="w${n}"><inertial><mass value="-1"/></inertial></link>'
    part = f'<robot {space}><xacro:macro name="wheel" params="n">{wheel}</xacro:macro></robot>'
    (tmp_path / "part.xacro").write_text(part)
    uses = "".join(f'<xacro:wheel n="{number}"/>' for number in range(calls))
    text = f'<robot name="r" {space}><xacro:include filename="part.xacro"/>{uses}</robot>'
    (told,) = (
        each
        for each in lint(text, str(tmp_path / "car.xacro")).findings
        if each.rule.code == "INE003"
    )

    assert told.location.source.name.endswith("part.xacro")
    assert told.location.source[told.location.span] == "-1"
    assert told.message.endswith(end)
    assert told.message.startswith("<mass> of link 'w0'")


def test_what_a_macro_writes_is_told_once_of_several_groups(tmp_path):
    """Each joint has a group of two angles, and all of them are written at one place."""
    space = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
    limit = '<limit lower="-90" upper="90" effort="1" velocity="1"/>'
    ends = '<parent link="base"/><child link="w${n}"/>'
    joint = f'<link name="w${{n}}"/><joint name="j${{n}}" type="revolute">{ends}{limit}</joint>'
    macro = f'<xacro:macro name="wheel" params="n">{joint}</xacro:macro>'
    uses = "".join(f'<xacro:wheel n="{number}"/>' for number in range(3))
    text = f'<robot name="r" {space}>{macro}<link name="base"/>{uses}</robot>'
    findings = lint(text, str(tmp_path / "car.xacro")).findings
    (told,) = (each for each in findings if each.rule.code == "UNI003")

    assert "joint 'j0'" in told.message
    assert told.message.endswith("(2 such places). This text is used 3 times.")
    assert len(told.members) == 6


def test_a_group_counts_as_the_worst_in_it():
    """A value that is malformed in a drawing and in a shape to hit is told once, of the shape."""
    mesh = '<geometry><mesh filename="a.stl" scale="1 1 1 1"/></geometry>'
    link = f"<visual>{mesh}</visual><collision>{mesh}</collision>"
    text = f'<robot name="a"><link name="b">{link}</link></robot>'
    (told,) = (each for each in lint(text).findings if each.rule.code == "SRC007")

    assert told.severity.label == "error"
    assert told.location.span.start > text.index("<collision>")
    assert [
        related.location.span.start < text.index("<collision>") for related in told.related
    ] == [True]
