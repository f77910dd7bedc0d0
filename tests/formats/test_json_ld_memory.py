"""Files read one after the other are read as each would be alone."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from reading import document, losses
from test_json_ld_models import models

from kinlint.contexts.context_library import RELEASES, Contexts
from kinlint.formats.jsonld.reader import read
from kinlint.formats.options import ReadOptions
from kinlint.text import SourceText
from kinlint.vocabulary import METAMODELS

SAMPLES = sorted((Path(__file__).parents[2] / "samples").rglob("*.jsonld"))
RELATIONS = f"{METAMODELS}geometry/spatial-relations.json"
EX = {"ex": "https://example.org/#"}


def check(texts: dict[str, str], contexts: Contexts) -> None:
    shared = ReadOptions(contexts)
    for name, text in texts.items():
        alone = read(SourceText(name, text), ReadOptions(contexts.at_release(contexts.release)))
        after = read(SourceText(name, text), shared)
        assert after.statements == alone.statements, name
        assert after.map == alone.map, name
        assert after.prefixes == alone.prefixes, name


@pytest.mark.slow
def test_samples() -> None:
    check({path.name: path.read_text("utf-8") for path in SAMPLES}, Contexts.bundled())


@pytest.mark.slow
@pytest.mark.parametrize("release", RELEASES)
def test_real_models(release: str) -> None:
    texts = {str(path): path.read_text("utf-8") for path in models()}
    check(texts, Contexts.bundled(release))


def both(first: Any, second: Any) -> list[list[tuple[str, str]]]:
    options = ReadOptions()
    contents = (first, second)
    return [losses(document(content, memory=options.memory)) for content in contents]


def test_what_one_file_defines_is_unknown_in_the_next() -> None:
    node = {"@id": "https://e.org/a", "ex:p": 1}
    first = {"@context": [RELATIONS, EX], **node}
    found = both(first, {"@context": [RELATIONS], **node})
    assert found == [[], [("UndefinedPrefix", '"ex:p"')]]


def test_one_prefix_with_two_meanings() -> None:
    first = {"@context": [RELATIONS, {"ex": "https://e.org/#"}], "@id": "ex:a", "lost": 1}
    second = {"@context": [RELATIONS, {"ex": "nothing"}], "@id": "ex:a", "of": "ex:b"}
    assert both(first, second)[1] == both(second, second)[0]


def test_a_problem_is_stated_in_every_file_that_has_it() -> None:
    content = {"@context": [RELATIONS, "x.json", EX], "@id": "ex:a", "ex:p": 1}
    stated = [("UnresolvedContext", '"x.json"')]
    assert both(content, content) == [stated, stated]
