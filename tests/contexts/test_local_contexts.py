"""Contexts in files beside a model are read from there, and only there."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from kinlint.contexts.context_library import Contexts
from kinlint.document import Document
from kinlint.files.tracked_io import recorded
from kinlint.formats.incremental_reader import IncrementalReader
from kinlint.formats.jsonld.local_contexts import MOST_FILES
from kinlint.formats.jsonld.reader import read
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode
from kinlint.project.model_detection import is_model
from kinlint.terms import RDF_TYPE, iri, is_blank, literal_value
from kinlint.text import SourceText
from kinlint.vocabulary import METAMODELS, SRC

GEOMETRY = f"{METAMODELS}geometry/structural-entities"
RELATIONS = f"{METAMODELS}geometry/spatial-relations.json"
ARM = {"arm": "https://example.org/arm#"}
TIP = {"@id": "arm:tip", "@type": "Frame", "origin": "arm:tip-origin"}


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A project, at whose top kinlint works."""
    top = tmp_path / "project"
    top.mkdir()
    monkeypatch.chdir(top)
    return top


def write(path: str, content: Any) -> None:
    file = Path(path)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(content if isinstance(content, str) else json.dumps(content, indent=1))


def context(path: str, *entries: Any) -> None:
    write(path, {"@context": list(entries)})


def model(named: Any, *nodes: Any) -> SourceText:
    return SourceText("model.json", json.dumps({"@context": named, "@graph": list(nodes or [TIP])}))


def document(named: Any, *nodes: Any) -> Document:
    return read(model(named, *nodes), ReadOptions())


def types(read: Document) -> list[str]:
    return [o for s, p, o in read.statements if p == RDF_TYPE and not is_blank(s) and SRC not in o]


def problems(read: Document) -> Iterator[tuple[str, str, str]]:
    """The file and text of each context that cannot be used, and the reason."""
    for node, prop, reason in read.statements:
        if prop == iri(f"{SRC}reason"):
            place = read.location(read.map.nodes[node].whole)
            yield place.source.name, place.source[place.span], literal_value(reason)


@pytest.mark.parametrize(
    "named",
    [
        "context.json",
        "./context.json",
        ["./context.json"],
        [ARM, "./context.json"],
        "a/../context.json",
    ],
)
def test_a_context_file_is_read(named: Any) -> None:
    """By any relative reference, alone or in an array."""
    context("context.json", f"{GEOMETRY}.json", ARM)

    assert types(document(named)) == [f"<{GEOMETRY}#Frame>"]


def test_context_files_name_others() -> None:
    """In arrays, by @import, and for nodes of a type, each from where it stands."""
    context("context.json", "parts/all.json", ARM)
    context("parts/all.json", f"{GEOMETRY}.json", {"@version": 1.1, "@import": "sizes.json"})
    write(
        "parts/sizes.json", {"@context": {"Box": {"@id": "arm:Box", "@context": "box.json"}} | ARM}
    )
    write("parts/box.json", {"@context": {"size": "https://example.org/box#size"}})

    made = document("context.json", TIP, {"@id": "arm:box", "@type": "Box", "size": 2})

    assert list(problems(made)) == []
    assert types(made)[1] == "<https://example.org/arm#Box>"
    assert "<https://example.org/box#size>" in {prop for _, prop, _ in made.statements}


def test_what_is_wrong_in_a_context_file_is_placed_there() -> None:
    """With the file and the text of the reference or definition."""
    unknown = f"{METAMODELS}geometry/relations.json"
    context("context.json", f"{GEOMETRY}.json", "./more.json", ARM)
    context("more.json", unknown, {"length": {"@id": "arm:length", "@type": ["a"]}})

    found = list(problems(document("./context.json")))

    assert found[0][:2] == ("more.json", f'"{unknown}"')
    assert found[1][0] == "more.json"
    assert json.loads(found[1][1]) == {"@id": "arm:length", "@type": ["a"]}


@pytest.mark.parametrize(
    ("files", "reason"),
    [
        ({}, "there is no file 'context.json'"),
        (
            {"context.json": "{"},
            "context.json:1:2: the file is cut off: expected a key in double quotes",
        ),
        (
            {"context.json": '{"a": {}}'},
            "'context.json' is not a context document, it has no '@context'",
        ),
        ({"context.json": '{"@context": "context.json"}'}, "it includes itself"),
        (
            {"context.json": '{"@context": "b.json"}', "b.json": '{"@context": ["context.json"]}'},
            "it includes itself",
        ),
        ({"context.json": '{"@context": "../beyond.json"}'}, "is outside of the project"),
        (
            {"context.json": '{"@context": ".hidden/c.json"}'},
            "none of the files that a robot is made of",
        ),
    ],
)
def test_a_context_that_cannot_be_read_says_why(files: dict[str, str], reason: str) -> None:
    """Each is a problem at the reference, and the rest of the model is read."""
    for name, text in files.items():
        write(name, text)
    write("../beyond.json", {"@context": ARM})
    write(".hidden/c.json", {"@context": ARM})

    ((_, _, said),) = problems(document(["./context.json", ARM]))

    assert reason in said


def test_the_number_of_context_files_is_bounded() -> None:
    """A chain without end is not followed."""
    for number in range(MOST_FILES + 2):
        context(f"c{number}.json", f"c{number + 1}.json")

    ((name, _, reason),) = problems(document("c0.json"))

    assert (name, reason) == (
        f"c{MOST_FILES - 1}.json",
        f"the model names more than {MOST_FILES} context files",
    )


def test_links_do_not_lead_out_of_the_project(here: Path) -> None:
    """What counts is where a file really lies."""
    write("../beyond.json", {"@context": ARM})
    (here / "context.json").symlink_to(here.parent / "beyond.json")

    ((_, _, reason),) = problems(document("context.json"))

    assert reason == "'context.json' is outside of the project"


def test_extra_contexts_go_first(here: Path) -> None:
    """A relative reference may be configured as any other."""
    context("other.json", f"{GEOMETRY}.json", ARM)
    options = ReadOptions(Contexts.bundled(extra=[("./context.json", here / "other.json")]))

    assert types(read(model("./context.json"), options)) == [f"<{GEOMETRY}#Frame>"]


def test_a_context_file_is_looked_at_again() -> None:
    """By a cache, and while it is edited, be it there or not."""
    reader, options = IncrementalReader(), ReadOptions()
    source = model("context.json")
    with recorded() as record:
        assert types(reader.read(source, options)) != [f"<{GEOMETRY}#Frame>"]
    context("context.json", f"{GEOMETRY}.json", ARM)
    edited = reader.read(source, ReadOptions())

    assert any(name == "bounded_read.contents" for name, _ in record.answers)
    assert types(edited) == [f"<{GEOMETRY}#Frame>"]
    assert [each.name for each in edited.sources] == ["model.json", "context.json"]
    open_in_an_editor = SourceText("context.json", json.dumps({"@context": ARM}))
    overlaid = ReadOptions(overlay={Path("context.json").resolve(): open_in_an_editor})
    assert types(reader.read(source, overlaid)) != [f"<{GEOMETRY}#Frame>"]


def test_local_contexts_make_json_a_model() -> None:
    """If they lead to robot vocabularies, or the model uses their terms; a context is none."""
    context("context.json", "more.json", ARM)
    context("more.json", f"{GEOMETRY}.json")
    context("other.json", "https://schema.org")
    thing = {"@id": "arm:x", "@type": "Thing"}

    def verdict(named: str, *nodes: Any) -> bool:
        return is_model(decode("model.json", model(named, *nodes).text.encode()))

    assert verdict("context.json", thing)
    assert not verdict("other.json", thing)
    assert verdict("missing.json", {"@id": "arm:x", "between-attachments": []})
    assert verdict("missing.json", TIP, {"@id": "arm:tip-origin", "@type": "Point"})
    assert not verdict("missing.json", thing, {"@id": "arm:tip-origin", "@type": "Point"})
    assert not is_model(decode("context.json", Path("context.json").read_bytes()))
