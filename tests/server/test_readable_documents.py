"""The documents that are kept while a file cannot be read."""

from pathlib import Path

from support.linting import book

from kinlint import lint
from kinlint.configuration.settings import Settings
from kinlint.server.readable_documents import ReadableDocuments
from kinlint.text import SourceText

GOOD = '<robot name="a"><link name="one"/></robot>'
OTHER = '{"@context": "https://w3id.org/kinlint/composable.json", "@id": "http://e.org/x"}'


def examined(folder: Path, **texts: str):
    sources = [
        SourceText(str(folder / name.replace("_", ".")), text) for name, text in texts.items()
    ]
    return lint.examine(sources, [], Settings(), book())


def test_a_broken_file_has_its_last_readable_document(tmp_path):
    readable = ReadableDocuments()
    before = examined(tmp_path, a_urdf=GOOD, b_jsonld=OTHER)
    readable.remember(before)
    after = examined(tmp_path, a_urdf=GOOD.replace("/>", ""), b_jsonld=OTHER)
    readable.remember(after)
    found = {each.source.name: each for each in readable.of(str(tmp_path / "a.urdf"), after)}
    assert found[str(tmp_path / "a.urdf")] is before.documents[0]
    assert found[str(tmp_path / "b.jsonld")] is after.documents[1]


def test_what_is_not_open_is_forgotten(tmp_path):
    readable = ReadableDocuments()
    name = str(tmp_path / "b.jsonld")
    readable.remember(examined(tmp_path, b_jsonld=OTHER))
    broken = examined(tmp_path, b_jsonld=OTHER[:-1])
    assert [each.source.name for each in readable.of(name, broken)] == [name]
    readable.forget([name])
    assert readable.of(name, broken) == ()
