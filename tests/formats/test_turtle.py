"""Turtle, N-Triples and N-Quads with positions."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from data import locate_data
from reading import details, domain, losses
from support.linting import document

from kinlint.document import Document
from kinlint.errors import SourceError
from kinlint.formats.turtle import reader
from kinlint.terms import RDF, XSD, is_blank
from kinlint.text import SourceText
from kinlint.vocabulary import SRC

TURTLE = '''@prefix e: <https://e.org/#> . # a comment with "quotes"
@base <https://e.org/> .
e:arm a e:Arm ; e:p "x\\u00e9" , "y"@EN, """z
"q" """^^e:t ; e:list ( 1 2.0 [ e:inner true ] ) ; e:to <rel> .
[ e:p 1e5 ] .
_:x e:p _:y, '\N{ROBOT FACE}' .
'''


def found(text: str, name: str = "arm.ttl") -> Document:
    return document(text, name)


def test_every_triple_has_the_span_of_its_value() -> None:
    model = found(TURTLE)
    places = [
        (prop.strip("<>").rpartition("#")[2], model.source[model.map.triples[subject, prop, value]])
        for subject, prop, value in domain(model)
    ]
    assert places == [
        ("type", "e:Arm"),
        ("p", '"x\\u00e9"'),
        ("p", '"y"@EN'),
        ("p", '"""z\n"q" """^^e:t'),
        ("inner", "true"),
        ("first", "1"),
        ("rest", "( 1 2.0 [ e:inner true ] )"),
        ("first", "2.0"),
        ("rest", "( 1 2.0 [ e:inner true ] )"),
        ("first", "[ e:inner true ]"),
        ("rest", "( 1 2.0 [ e:inner true ] )"),
        ("list", "( 1 2.0 [ e:inner true ] )"),
        ("to", "<rel>"),
        ("p", "1e5"),
        ("p", "_:y"),
        ("p", "'\N{ROBOT FACE}'"),
    ]


def test_nodes_have_the_spans_of_their_statement_and_their_name() -> None:
    model = found(TURTLE)
    whole, identifier = model.map.nodes["<https://e.org/#arm>"]
    assert identifier is not None
    assert model.source[identifier] == "e:arm"
    assert model.source[whole].startswith("e:arm a e:Arm")
    assert model.source[whole].endswith("<rel> .")
    assert model.prefixes == {"e": "https://e.org/#"}


def test_turtle_says_what_it_describes() -> None:
    model = found(TURTLE)
    described = [s for s, prop, _ in model.statements if prop == f"<{SRC}describedIn>"]
    assert len(described) == 4
    assert (model.graph, f"<{SRC}ownNamespace>", '"https://e.org/#"') in model.statements
    assert (model.graph, f"<{SRC}format>", '"turtle"') in model.statements


@pytest.mark.parametrize(
    ("name", "text", "place"),
    [
        ("a.ttl", "@prefix a: <https://e.org/> .\na:b a:c .", (2, 9)),
        ("a.ttl", "a:b a:c a:d .", (1, 1)),
        ("a.ttl", "@prefix a: <https://e.org/>", (1, 28)),
        ("a.nq", "<https://e.org/a> <https://e.org/b> .\n", (1, 37)),
        ("a.nt", "# fine\n<https://e.org/a> oops\n", (2, 19)),
    ],
)
def test_errors_say_where(name: str, text: str, place: tuple[int, int]) -> None:
    with pytest.raises(SourceError) as caught:
        found(text, name)
    assert (caught.value.line, caught.value.column) == place


def test_n_quads_are_flattened_and_placed() -> None:
    text = (
        '<https://e.org/a> <https://e.org/p> "c\\"d"@en <https://e.org/g> .\n# note\n\n'
        "_:b <https://e.org/p> <https://e.org/a> <https://e.org/g> . # note\r\n"
    )
    model = found(text, "a.nq")
    values = [model.source[model.map.triples[triple]] for triple in domain(model)]
    assert values == ['"c\\"d"@en', "<https://e.org/a>"]
    assert losses(model) == [("NamedGraph", "<https://e.org/g>")]
    assert details(model, "<https://e.org/g>")["name"] == ["https://e.org/g"]
    assert is_blank(domain(model)[1][0])


@pytest.mark.parametrize(
    ("name", "text", "number"),
    [
        ("a.ttl", "<https://e.org/#a> <https://e.org/#p> 1.5, -1e999 .", "-1e999"),
        (
            "a.nt",
            (
                f'<https://e.org/#a> <https://e.org/#p> "1e999"^^<{XSD}double> .\n'
                f'<https://e.org/#a> <https://e.org/#p> "INF"^^<{XSD}double> .\n'
            ),
            f'"1e999"^^<{XSD}double>',
        ),
    ],
)
def test_a_number_that_no_double_holds_is_stated_as_lost(name: str, text: str, number: str) -> None:
    """As in JSON-LD; what reads it as infinity says nothing. Infinity itself may be meant."""
    model = found(text, name)
    assert losses(model, "LostValue") == [("LostValue", number)]
    said = details(model, number)
    assert said["node"] == ["https://e.org/#a"]
    assert said["written"][0] in number
    assert len(domain(model)) == 1


def test_what_the_grammar_does_not_cover_is_still_read(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reader.Grammar, "read", lambda self: None)
    model = found(TURTLE)
    assert len(domain(model)) == 16
    line = model.source.position(model.map.triples[domain(model)[0]].start).line
    assert line == 3


def test_the_authors_shapes_are_all_placed_exactly(monkeypatch: pytest.MonkeyPatch) -> None:
    paths = sorted(locate_data("comp-rob2b").rglob("*.ttl"))
    paths += sorted(locate_data("w3c", "shacl-tests").rglob("*.ttl"))

    def inexact(_truth: object, source: SourceText) -> None:
        raise AssertionError(source.name)

    monkeypatch.setattr(reader, "_placed_by_line", inexact)
    for path in paths:
        model = found(path.read_text("utf-8"), str(path))
        for triple in domain(model):
            if triple[1] in (f"<{RDF}first>", f"<{RDF}rest>") or is_blank(triple[2]):
                continue
            assert model.source[model.map.triples[triple]][0] not in " \n;,", path


@pytest.mark.parametrize(("name", "absent"), [("a.ttl", "pyld"), ("a.jsonld", "pyoxigraph")])
def test_a_front_end_imports_no_other(name: str, absent: str, tmp_path: Path) -> None:
    path = tmp_path / name
    path.write_text("{}" if name.endswith("ld") else "")
    code = (
        "import sys; from kinlint.formats.registry import read, decode;"
        "from kinlint.formats.options import ReadOptions;"
        f"read(decode({name!r}, open({str(path)!r}, 'rb').read()), ReadOptions());"
        "names = {module.partition('.')[0] for module in sys.modules};"
        f"sys.exit(len(names & {{'rdflib', 'pyshacl', {absent!r}}}))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
