"""The real models of comp-rob2b, under each release of the contexts."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from data import locate_data
from reading import document, domain, losses
from test_json_ld_places import check_places, ours, theirs

from kinlint.contexts.context_library import RELEASES, Contexts
from kinlint.document import Document
from kinlint.terms import literal_value
from kinlint.text import Span
from kinlint.vocabulary import SRC

pytestmark = pytest.mark.corpus


def models(*parts: str) -> list[Path]:
    top = locate_data("comp-rob2b", *parts)
    metamodels = locate_data("comp-rob2b", "metamodels")
    return sorted(path for path in top.rglob("*.json") if not path.is_relative_to(metamodels))


@pytest.mark.parametrize("release", RELEASES)
def test_every_place_in_every_model_says_what_is_there(release: str) -> None:
    contexts = Contexts.bundled(release)
    for path in models():
        check_places(document(path.read_text("utf-8"), str(path), contexts=contexts))


@pytest.mark.parametrize("release", RELEASES)
def test_the_triples_are_those_of_pyld(release: str) -> None:
    contexts, compared = Contexts.bundled(release), 0
    for path in models():
        text = path.read_text("utf-8")
        read = document(text, str(path), contexts=contexts)
        if losses(read, "UnresolvedContext") or losses(read, "InvalidContext"):
            continue
        compared += 1
        assert ours(read) == theirs(json.loads(text), contexts), path
    assert compared > 10


def test_the_tutorial_has_190_triples() -> None:
    read = [document(path.read_text("utf-8")) for path in models("modelling-tutorial")]
    assert sum(len(domain(one)) for one in read) == 190


@pytest.mark.parametrize(
    ("name", "kind", "lines"),
    [
        ("cartesian-coordinates", "DroppedKey", [28]),
        ("cartesian-coordinates", "RelativeType", [13, 13, 26, 26]),
        ("dynamics", "DroppedKey", [16, 17]),
        ("fpk-algorithm", "DroppedKey", [22, 23, 24]),
        ("joint-coordinates", "DroppedKey", [17]),
        ("skeleton", "DroppedKey", []),
        ("skeleton", "RelativeType", []),
    ],
)
def test_what_the_tutorial_loses(name: str, kind: str, lines: list[int]) -> None:
    path = locate_data("comp-rob2b", "modelling-tutorial", "models", f"{name}.json")
    read = document(path.read_text("utf-8"))
    found = [
        read.source.position(read.map.nodes[subject].whole.start).line
        for subject, _, value in read.statements
        if value.endswith(f"source#{kind}>")
    ]
    assert sorted(found) == lines


def dropped(read: Document) -> dict[Span, set[str]]:
    """The releases that are said to map each dropped key."""
    nodes = [s for s, _, value in read.statements if value == f"<{SRC}DroppedKey>"]
    found: dict[Span, set[str]] = {read.map.nodes[node].whole: set() for node in nodes}
    for subject, prop, value in read.statements:
        if subject in nodes and prop == f"<{SRC}mappedInRelease>":
            found[read.map.nodes[subject].whole].add(literal_value(value))
    return found


@pytest.mark.parametrize("release", RELEASES)
def test_what_is_said_of_other_releases_is_what_reading_under_them_finds(release: str) -> None:
    """A key that the release in force drops is mapped by others exactly if they keep it."""
    compared = 0
    for path in models():
        text = path.read_text("utf-8")
        reads = {
            other: document(text, str(path), contexts=Contexts.bundled(other)) for other in RELEASES
        }
        if any(losses(read, "UnresolvedContext") for read in reads.values()):
            continue
        for span, said in dropped(reads[release]).items():
            kept = {other for other in RELEASES if span not in dropped(reads[other])}
            assert said == kept, (path, span)
            compared += 1
    assert compared > 20
