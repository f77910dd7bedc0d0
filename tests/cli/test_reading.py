"""What is read: models that were named, and what a search found that is one."""

import json
import os

import pytest

from kinlint.configuration.settings import Settings
from kinlint.formats.registry import decode
from kinlint.project.discovery import Input
from kinlint.project.model_detection import is_model
from kinlint.project.reading import read_models

ROBOT = '{"@context": "https://comp-rob2b.github.io/metamodels/qudt.json", "@id": "x:y"}'
PACKAGE = '{"@context": "https://doi.org/10.5063/schema/codemeta-2.0", "@type": "X"}'


def outcome(*inputs, settings=None):
    sources, errors = read_models(inputs, settings or Settings())
    return [source.name for source in sources], [str(error) for error in errors]


def given(write, name, text, *, named=True):
    return Input(name, write(name, text), named=named)


@pytest.mark.parametrize(
    ("name", "text", "found"),
    [
        ("a.json", ROBOT, True),
        ("a.jsonld", ROBOT, True),
        ("a.json", PACKAGE, False),
        ("a.jsonld", PACKAGE, True),
        ("a.json", '{"a": {"@context": "kinlint"}}', False),
        ("a.json", '{"@context": {"a": "https://w3id.org/kinlint/"}}', False),
        ("a.jsonld", '{"@context": {"a": "https://w3id.org/kinlint/"}}', False),
        ("a.ttl", "# empty", True),
    ],
)
def test_what_a_search_found_is_read_if_it_is_a_model(write, name, text, found):
    """Other JSON-LD and contexts are passed over in silence."""
    assert outcome(given(write, name, text, named=False)) == ([name] if found else [], [])


@pytest.mark.parametrize(
    "name_and_text", [("a.json", PACKAGE), ("a.jsonld", '{"@context": {}}'), ("a.ttl", "")]
)
def test_what_is_named_is_read(write, name_and_text):
    """Whoever names a file means it."""
    assert outcome(given(write, *name_and_text)) == ([name_and_text[0]], [])


@pytest.mark.parametrize("name_and_text", [("a.json", '{"name": "x"}'), ("a.txt", "robot")])
def test_what_is_named_and_no_model_is_an_error(write, name_and_text):
    """With what kinlint reads."""
    sources, errors = outcome(given(write, *name_and_text))

    assert sources == []
    assert errors[0].startswith(f"{name_and_text[0]}: not a robot model: kinlint reads JSON-LD")


def test_contexts_of_ones_own_make_a_model(write, here):
    """Those that the configuration adds."""
    mine = given(write, "a.json", '{"@context": "https://acme.example/c.json", "@id": "x:y"}')
    found = Input(mine.name, mine.path, named=False)
    write("c.json", '{"@context": {}}')
    settings = Settings(extra_contexts={"https://acme.example/c.json": here / "c.json"})

    assert outcome(found) == ([], [])
    assert outcome(found, settings=settings) == (["a.json"], [])


def test_what_is_no_file_is_an_error(write, here):
    """Pipes, links to nothing, what may not be read; others are read all the same."""
    os.mkfifo(here / "pipe.jsonld")
    (here / "link.jsonld").symlink_to("nowhere")
    names = ["pipe.jsonld", "link.jsonld", "gone.jsonld"]
    inputs = [Input(name, here / name) for name in names]

    assert outcome(*inputs, given(write, "a.jsonld", ROBOT)) == (
        ["a.jsonld"],
        [
            "pipe.jsonld: not a regular file; for a pipe, use - as the path",
            "link.jsonld: a link to nothing",
            "gone.jsonld: No such file or directory",
        ],
    )


def test_what_is_no_text_is_an_error(here):
    """With the place of the first byte that is none."""
    (here / "a.jsonld").write_bytes(b'{"\xff": 1}')
    sources, errors = outcome(Input("a.jsonld", here / "a.jsonld"))

    assert sources == []
    assert errors[0].startswith("a.jsonld:1:3: ")


GEOMETRY = "https://comp-rob2b.github.io/metamodels/geometry/structural-entities#"


@pytest.mark.parametrize(
    ("said", "answer"),
    [
        ({"@context": {"a": f"{GEOMETRY}Point"}}, False),
        ({"@context": [GEOMETRY, {}], "@graph": []}, True),
        ({"@graph": [], "@context": {"Frame": {"@id": f"{GEOMETRY}Frame"}}}, True),
        ({"a": [{"@context": GEOMETRY}], "@context": {}}, True),
        ({"@context": {"@version": 1.1}, "@type": [f"{GEOMETRY}Frame"]}, True),
        ({"@context": {"@version": 1.1}, f"{GEOMETRY}origin": "x"}, True),
        ({"@context": "https://w3id.org/codemeta/3.0", "name": GEOMETRY}, False),
        ({"@context": "https://schema.org", "url": "https://comp-rob2b.github.io"}, False),
        ([{"@context": GEOMETRY}], True),
    ],
)
def test_the_context_makes_json_a_model(said, answer):
    """Not what else it speaks of; a context for others is none."""
    assert is_model(decode("a.json", json.dumps(said).encode())) is answer


def test_json_that_cannot_be_parsed_is_a_model_if_it_might_be():
    """So that what is wrong with a model that was cut off is told."""
    for broken in (f'{{"@context": "{GEOMETRY}", "a": ', '{"@context": ' * 100_000 + GEOMETRY):
        assert is_model(decode("a.json", broken.encode()))
    assert not is_model(decode("a.json", b'{"@context": "https://schema.org", "a": '))
    deep = f'{{"@context": "https://schema.org", "a": "{GEOMETRY}", "b": {"[" * 900 + "]" * 900}}}'
    assert not is_model(decode("a.json", deep.encode()))


def test_json_in_utf_16_is_told(kinlint, write):
    """A search does not pass it over, as if it were no model."""
    text = (
        '{"@context": "https://w3id.org/kinlint/composable.json", "@id": "urn:a", "@type": "Point"}'
    )
    write("arm.json", "").write_bytes(text.encode("utf-16"))

    code, out, err = kinlint(".")

    assert code == 2
    assert "UTF-16" in out + err
