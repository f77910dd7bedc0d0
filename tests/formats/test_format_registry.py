"""Which front end reads what, and how bytes become text."""

from __future__ import annotations

import pytest
from reading import domain

from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError, UsageError
from kinlint.formats.options import ReadOptions
from kinlint.formats.recognition import recognise
from kinlint.formats.records import BY_NAME
from kinlint.formats.registry import decode, read
from kinlint.text import SourceText

MODEL = '{"@context": {"p": "https://e.org/p"}, "@id": "https://e.org/a", "p": "\N{ROBOT FACE}"}'


@pytest.mark.parametrize(
    ("name", "text", "form"),
    [
        ("arm.json", '{"@context": {}}', "jsonld"),
        ("arm.json", ' \n{"a": {"b": "@context"}, "@context" : "https://e.org"}', "jsonld"),
        ("arm.json", '[{"a": 1}, {"@context": []}]', "jsonld"),
        ("arm.json", '{"a": {"@context": {}}}', None),
        ("arm.json", '[[{"@context": {}}]]', None),
        ("arm.json", '{"a": "@context", "b": ["@context"]}', None),
        ("arm.json", '{"@context": null}', None),
        ("arm.json", '{"@context": {}, "cut off', "jsonld"),
        ("arm.json", "@prefix a: <b> .", None),
        ("arm.jsonld", "{}", "jsonld"),
        ("arm.ttl", "", "turtle"),
        ("arm.nt", "", "ntriples"),
        ("arm.NQ", "", "nquads"),
        ("<stdin>", MODEL, "jsonld"),
        ("<stdin>", "# robot\nPREFIX : <https://e.org/>\n", "turtle"),
        ("<stdin>", "<https://e.org/a> <https://e.org/p> _:b .\n", "nquads"),
        ("<stdin>", "<robot name='arm'/>", "urdf"),
        ("<stdin>", "", None),
    ],
)
def test_the_format_of_a_file(name: str, text: str, form: str | None) -> None:
    assert recognise(name, text) == BY_NAME.get(form)


@pytest.mark.parametrize("text", [MODEL, MODEL.replace(" ", "\r\n\t"), MODEL.replace(" ", "")])
@pytest.mark.parametrize("mark", [b"", b"\xef\xbb\xbf"])
def test_places_count_code_points_after_the_mark(text: str, mark: bytes) -> None:
    source = decode("arm.json", mark + text.encode())
    assert source.bom == bool(mark)
    found = read(source, ReadOptions())
    assert source[found.map.triples[domain(found)[0]]] == '"\N{ROBOT FACE}"'


@pytest.mark.parametrize(
    ("data", "place", "cause"),
    [
        ("\ufeff{}".encode("utf-16-le"), (1, 1), "UTF-16"),
        ("\ufeff{}".encode("utf-16-be"), (1, 1), "UTF-16"),
        ("\ufeff{}".encode("utf-32-le"), (1, 1), "UTF-32"),
        ('{"a": 1}'.encode("utf-16-le"), (1, 2), "UTF-16 (little endian)"),
        ('{"a": 1}'.encode("utf-16-be"), (1, 1), "UTF-16 (big endian)"),
        ('{\n"\N{DEGREE SIGN}"}'.encode("latin-1"), (2, 2), "byte 0xB0"),
        ('{"\N{ROBOT FACE}\n\N{ROBOT FACE}'.encode()[:-1], (2, 1), "not UTF-8"),
        (b'{"a":\n\0}', (2, 1), "NUL"),
    ],
)
def test_bytes_that_are_no_text(data: bytes, place: tuple[int, int], cause: str) -> None:
    with pytest.raises(SourceError) as caught:
        decode("arm.json", data)
    assert (caught.value.line, caught.value.column) == place
    assert cause in caught.value.cause


def test_a_file_of_no_known_format_is_refused() -> None:
    with pytest.raises(SourceError, match="not a robot model"):
        read(SourceText("arm.json", "{}"), ReadOptions())


def test_a_format_can_be_given() -> None:
    found = read(SourceText("arm.txt", MODEL, format=BY_NAME["jsonld"]), ReadOptions())
    assert len(domain(found)) == 1


def test_settings_say_which_contexts() -> None:
    assert ReadOptions.from_settings(Settings(contexts="2022-06")).contexts.release == "59e0b06"
    with pytest.raises(UsageError):
        ReadOptions.from_settings(Settings(contexts="1999"))
