"""Mutated JSON-LD is read alike by the compiled walk and by PyLD.

`python tests/fuzzing --expansion 1000000` tries more.
"""

from __future__ import annotations

import json

import pytest

from fuzzing.expansion import CONTEXT, EX, START, difference, made
from kinlint.formats.jsonld import reader
from kinlint.formats.jsonld.reader import read
from kinlint.formats.options import ReadOptions
from kinlint.text import SourceText

SHARE, PARTS = 150, 4
OF = {"of": {"@id": "ex:of", "@type": "ex:T", "@context": {"size": "ex:size"}}}
TEXTS = {
    "an unknown prefix in a scoped context": {
        "@context": {
            "ex": EX,
            "Part": {"@id": "ex:Part", "@context": {"of": {"@id": "ex:of", "@type": "arm:x"}}},
        },
        "@graph": [{"@id": "ex:a", "@type": "Part", "of": "b"}],
    },
    "a graph whose context does not reach its elements": {
        "@context": {"ex": EX, **OF, "@propagate": False},
        "@graph": [{"@id": "ex:a", "of": {"size": 1}}, {"@id": "ex:b", "size": 2}],
    },
    "a scoped context that means something else elsewhere": {
        "@context": {"ex": EX, **OF, "T": {"@id": "ex:T", "@context": {"size": "ex:t-size"}}},
        "@graph": [
            {"@id": "ex:a", "of": {"size": 1}},
            {"@id": "ex:b", "@type": "T", "of": {"size": 1}},
            {"@id": "ex:c", "of": {"size": 1}},
        ],
    },
    "a scoped context of a key with an object, and later with a number": {
        "@context": {"ex": EX, "size": "ex:s", **OF},
        "@graph": [{"@id": "ex:a", "of": {"size": 1}, "no": 1}, {"@id": "ex:b", "of": 1.5}],
    },
    "a scoped context within itself": {
        "@context": {"ex": EX, **OF},
        "@graph": [{"@id": "ex:a", "of": {"size": 1, "of": {"size": 2}}}],
    },
    "a truth value as a list among other values": {
        "@context": {"ex": EX},
        "@graph": [{"@id": "ex:a", "ex:bag": [1, {"@list": True}, "x"]}],
    },
}


@pytest.mark.slow
@pytest.mark.parametrize("part", range(PARTS))
def test_mutated_models_are_read_alike(part: int) -> None:
    seeds = range(part * SHARE, (part + 1) * SHARE)
    assert {seed: found for seed in seeds if (found := difference(made(seed)))} == {}


@pytest.mark.parametrize("name", TEXTS)
def test_texts_that_once_differed(name: str) -> None:
    assert difference(json.dumps(TEXTS[name])) is None


def test_inputs_are_made_again_by_their_number() -> None:
    assert made(7) == made(7)
    assert len({made(seed) for seed in range(20)}) > 15


def test_most_elements_are_compiled(monkeypatch: pytest.MonkeyPatch) -> None:
    """Otherwise there is nothing to compare."""
    taken: list[bool] = []

    class Counted(reader.CompiledGraph):
        def take(self, *given):
            left = super().take(*given)
            taken.append(left is None)
            return left

    monkeypatch.setattr(reader, "CompiledGraph", Counted)
    read(SourceText("arm.jsonld", json.dumps(START[0])), ReadOptions())
    assert taken == [True] * len(START[0]["@graph"])


def test_a_difference_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    walk = "kinlint.formats.jsonld.compiled.plain_walk.PlainWalk._types"
    monkeypatch.setattr(walk, lambda *_: None)
    text = json.dumps({"@context": CONTEXT, "@graph": [{"@type": "Thing", "of": "ex:a"}]})
    assert (difference(text) or "").startswith("statements")
