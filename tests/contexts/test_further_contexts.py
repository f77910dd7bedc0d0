"""Contexts of users stand beside the bundled ones."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from kinlint.contexts.context_library import Contexts
from kinlint.errors import ConfigError
from kinlint.vocabulary import METAMODELS


def write(path: Path, content: object) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(content if isinstance(content, str) else json.dumps(content), encoding="utf-8")
    return path


def test_extra_by_iri(tmp_path: Path) -> None:
    """A context file given with its IRI is known, at every release, and wins over bundled ones."""
    mine = {"@context": {"values": "https://vendor.example/values"}}
    path = write(tmp_path / "v.jsonld", {**mine, "title": "ours"})
    iris = ["https://vendor.example/v.json", f"{METAMODELS}algorithm.json"]

    contexts = Contexts.bundled(extra=[(iri, path) for iri in iris])

    for iri in iris:
        assert iri in contexts.iris
        assert contexts.document(iri) == mine
        assert contexts.at_release("59e0b06").document(iri) == mine


def test_extra_directory_with_index(tmp_path: Path) -> None:
    """A directory's contexts.json says which IRI each file answers; it may be named itself."""
    write(tmp_path / "a" / "v.json", {"@context": {"x": "urn:x"}})
    index = write(tmp_path / "contexts.json", {"https://vendor.example/v": "a/v.json"})

    for extra in (tmp_path, index):
        document = Contexts.bundled(extra=[extra]).document("https://vendor.example/v")
        assert document == {"@context": {"x": "urn:x"}}


def test_extra_directory_by_path(tmp_path: Path) -> None:
    """Without an index, host and path of the IRI are the path of the file."""
    write(tmp_path / "vendor.example" / "v.json", {"@context": {"x": "urn:x"}})

    contexts = Contexts.bundled(extra=[tmp_path])

    assert contexts.document("https://vendor.example/v.json") == {"@context": {"x": "urn:x"}}


@pytest.mark.parametrize(
    ("content", "cause"),
    [
        (None, "No such file"),
        ("{", "not a JSON file"),
        ("[]", "not a JSON object"),
        ("{}", "no '@context'"),
    ],
)
def test_bad_extra_document(tmp_path: Path, content: str | None, cause: str) -> None:
    """A further context that is none is refused with its file and the cause."""
    path = tmp_path / "v.json"
    if content is not None:
        write(path, content)

    with pytest.raises(ConfigError, match=rf"v\.json: .*{cause}"):
        Contexts.bundled(extra=[("https://vendor.example/v", path)])


def test_bad_extra_index(tmp_path: Path) -> None:
    """An index whose paths are no strings, and a directory without any context, are refused."""
    with pytest.raises(ConfigError, match=r"neither contexts\.json"):
        Contexts.bundled(extra=[tmp_path])

    write(tmp_path / "contexts.json", {"https://vendor.example/v": 1})
    with pytest.raises(ConfigError, match=r"path of 'https://vendor\.example/v' must be a string"):
        Contexts.bundled(extra=[tmp_path])
