"""A text that is read again says exactly what it says when it is read for the first time."""

from __future__ import annotations

import json
import random
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from kinlint.document import Document
from kinlint.errors import SourceError
from kinlint.formats import incremental_reader
from kinlint.formats.incremental_reader import IncrementalReader
from kinlint.formats.json_text.json_outline import Unplaced
from kinlint.formats.jsonld.incremental import divided_reader
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.text import SourceText
from kinlint.vocabulary import METAMODELS

SAMPLES = sorted((Path(__file__).parents[2] / "samples").rglob("*.jsonld"))
GEOMETRY = [
    f"{METAMODELS}geometry/{name}.json"
    for name in ("structural-entities", "spatial-relations", "coordinates")
]
CONTEXT = [*GEOMETRY, {"ex": "https://example.org/#"}]
FRAGMENTS = (
    *('"', "{", "}", "[", "]", ",", ":", " ", "\r\n", "x", "é", "\U0001f916", "\\u00e9"),
    *("null,", "true,", "5,", '"@id": "rel",', '"@type": "Foo",', '"foo": 1,', '"@set": ['),
    *('"@value": 5,', '"@list": [1, 2],', '"@language": "x y",', '"@graph": [],'),
    '"@context": {"zz": "http://z.example/"},',
    f'"@context": ["{GEOMETRY[0]}", "{METAMODELS}qudt.json"],',
    '{"@id": "_:b1", "http://e.example/p": {"@id": "_:b2"}},',
    '{"http://e.example/p": {"foo": 1}},',
    '{"http://e.example/p": [1, 1, {"@list": [1, 2]}]},',
    '{"@id": "rel", "http://e.example/p": {"@id": "rel"}},',
    '{"@id": "http://e.example/i", "@graph": [{"http://e.example/p": 1}]},',
    '"@reverse": {"http://e.example/q": {"@id": "http://e.example/x"}},',
    '"@included": [{"@id": "http://e.example/i", "http://e.example/p": 2}],',
)


class Session:
    """Somebody writes a file, and it is read at once and again."""

    def __init__(self, name: str = "robot.jsonld") -> None:
        self.name = name
        self.options = ReadOptions()
        self.rereader = IncrementalReader()

    def write(self, text: str) -> bool:
        """Whether *text* could be read; it says the same both times."""
        expected, error = self._outcome(read, text)
        found, complaint = self._outcome(self.rereader.read, text)
        assert complaint == error
        if expected is None or found is None:
            return False
        assert tuple(found.statements) == tuple(expected.statements)
        assert list(found.map.triples.items()) == list(expected.map.triples.items())
        assert list(found.map.nodes.items()) == list(expected.map.nodes.items())
        assert list(found.prefixes.items()) == list(expected.prefixes.items())
        assert found == expected
        return True

    def _outcome(
        self, front_end: Callable[[SourceText, ReadOptions], Document], text: str
    ) -> tuple[Document | None, object]:
        try:
            return front_end(SourceText(self.name, text), self.options), None
        except SourceError as error:
            return None, (str(error), error.line, error.column)


@pytest.fixture
def sooner(monkeypatch: pytest.MonkeyPatch) -> Callable[[], None]:
    """From when it is called, nothing is read from its beginning."""

    def forbid() -> None:
        monkeypatch.setattr(incremental_reader, "read", None)
        monkeypatch.setattr(divided_reader, "read_divided", None)

    return forbid


def model(*nodes: Any, **around: Any) -> str:
    content = {"@context": CONTEXT, "@id": "ex:model", "@graph": nodes, **around}
    return json.dumps(content, indent=1)


def node(name: str, **content: Any) -> dict[str, Any]:
    return {"@id": f"ex:{name}", "@type": "Point", **content}


BEFORE = [node("a"), node("b"), node("c")]
PROP, LIST = "http://e.example/p", {"@list": [1, 2]}


@pytest.mark.parametrize(
    "after",
    [
        [node("a"), node("bee"), node("c")],
        [node("b"), node("c")],
        [node("a"), node("b")],
        [],
        [node("0"), *BEFORE],
        [*BEFORE, node("d")],
        [*BEFORE, *BEFORE],
        [BEFORE[2], BEFORE[1], BEFORE[0]],
        [node("0"), BEFORE[1], BEFORE[1], BEFORE[2], BEFORE[1], node("1")],
        [node("0"), {PROP: 1}, {PROP: 2}, BEFORE[1], {PROP: 3}, BEFORE[2], node("1")],
        [node("a", **{PROP: LIST}), *BEFORE[1:], node("d", **{PROP: LIST})],
        [node("a"), {PROP: {"@id": "_:x"}}, {"@id": "_:x", PROP: 1}, node("c")],
        [node("a"), {"foo": {"bar": 1}}, {PROP: {"foo": 1}}, node("c", foo=1)],
        [node("a", **{PROP: {"@id": "rel"}}), {"@id": "rel", PROP: 1}, node("c")],
        [node("a", **{PROP: {PROP: 1}}), node("b", **{PROP: {PROP: {PROP: 1}}})],
        [node("a"), {"@id": "ex:g", "@graph": [node("d")]}, node("c")],
        [node("a"), {"@reverse": {PROP: {"@id": "ex:c"}}}, node("c")],
        [node("a"), node("b", **{"frobnicate": 1, "@type": "Pointt"}), node("c")],
        [node("a"), {"@value": 5}, {"@set": [node("d")]}, node("c")],
        [node("a"), node("b", **{"@type": 5}), node("c")],
        [node("a"), [node("b")], None, True, "text", 5, node("c")],
        [node("a"), {"@context": GEOMETRY, **node("b")}, node("c", of="ex:a")],
        [node("a"), {"@context": "https://example.org/nowhere", **node("b")}, node("c")],
        [node("a", **{PROP: "\U0001f916 é"}), node("b"), node("c")],
    ],
)
def test_changes_of_elements(after: list[Any]) -> None:
    session = Session()
    session.write(model(*BEFORE))
    session.write(model(*after))
    session.write(model(*BEFORE))
    session.write(model(*after).replace("\n", "\r\n"))


@pytest.mark.parametrize(
    "around",
    [
        {"@context": [GEOMETRY[0], {"ex": "https://example.org/#"}]},
        {"@context": [*CONTEXT, "https://example.org/nowhere"]},
        {"@context": 5},
        {"@id": "ex:other"},
        {"@type": "Foo", PROP: [{PROP: 1}, {"foo": 2}], "zzz": 3},
        {"@graph": BEFORE[0]},
    ],
)
def test_changes_around_elements(around: dict[str, Any]) -> None:
    session = Session()
    session.write(model(*BEFORE, zzz=1, **{PROP: LIST}))
    session.write(model(*BEFORE, **around))
    session.write(model(*BEFORE, node("d"), **around))
    session.write(model(*BEFORE[1:], **around))


def test_typing(sooner: Callable[[], None]) -> None:
    """Most of what stands there in between is no JSON."""
    text, session = model(*BEFORE, node("d"), zzz=[{"foo": 1}]), Session()
    session.write(text)
    at = text.index('"@id": "ex:c"')
    written = '"start": {"@id": "ex:a", "colour": [true, "red"]},'
    ends = range(len(written) + 1)
    readable = [end for end in ends if session.write(text[:at] + written[:end] + text[at:])]
    assert readable == [0, len(written)]
    again = IncrementalReader()
    options = session.options
    for written_so_far in (f"{text}\n", text):
        again.read(SourceText(session.name, written_so_far), options)
    sooner()
    for end in readable:
        again.read(SourceText(session.name, text[:at] + written[:end] + text[at:]), options)


@pytest.mark.parametrize("after", [BEFORE[1:], [*BEFORE, node("d", foo=1)], []])
def test_elements_are_not_read_again(after: list[Any], sooner: Callable[[], None]) -> None:
    rereader, options = IncrementalReader(), ReadOptions()
    for text in (f"{model(*BEFORE)}\n", model(*BEFORE)):
        rereader.read(SourceText("a.jsonld", text), options)
    sooner()
    expected = {"<https://example.org/#" + str(each["@id"])[3:] + ">" for each in after}
    document = rereader.read(SourceText("a.jsonld", model(*after)), options)
    assert {node for node in document.map.nodes if "example.org" in node} == expected


def test_options_and_names() -> None:
    rereader, text = IncrementalReader(), model(*BEFORE)
    for name in ("a.jsonld", "b.jsonld"):
        for options in (ReadOptions(), ReadOptions(base="https://example.org/base/")):
            source = SourceText(name, text.replace("ex:b", "b"))
            assert rereader.read(source, options) == read(source, options)


def test_earlier_documents_stay_as_they_are() -> None:
    rereader, options = IncrementalReader(), ReadOptions()
    texts = [model(*BEFORE[:number], node("x"), *BEFORE[number:]) for number in range(4)]
    sources = [SourceText("a.jsonld", text) for text in texts]
    documents = [rereader.read(source, options) for source in sources]
    for source, document in zip(sources, documents, strict=True):
        assert document == read(source, options)


def test_nothing_changed() -> None:
    rereader, options, text = IncrementalReader(), ReadOptions(), model(*BEFORE)
    first = rereader.read(SourceText("a.jsonld", text), options)
    again = rereader.read(SourceText("a.jsonld", "".join(text)), options)
    assert again is first
    marked = SourceText("a.jsonld", text, bom=True)
    assert rereader.read(marked, options) == read(marked, options)


@pytest.mark.parametrize(
    ("name", "texts"),
    [
        ("a.urdf", ["<robot name='a'/>", "<robot name='b'><link/></robot>", "<robot"]),
        ("a.ttl", ["<a:b> a <a:c> .", "<a:b> a <a:c>, <a:d> .", "<a:b"]),
        ("a.json", ["{}", '{"@context": {}}', '{"@context": {}, "@graph": []}', "[]"]),
        ("a", ["", "<sdf version='1.9'/>", '[{"@context": {}, "@id": "a:b"}]']),
    ],
)
def test_other_formats(name: str, texts: list[str]) -> None:
    session = Session(name)
    for text in (*texts, *texts):
        session.write(text)


def edited(text: str, chance: random.Random) -> str:
    """*text* after something that people or their editors do."""
    at, size = chance.randrange(len(text) + 1), chance.choice((1, 1, 3, 40))
    kind = chance.randrange(6)
    if kind == 0:
        return text[:at] + text[at + size :]
    if kind == 1:
        return text[:at] + text[at : at + size] + text[at:]
    if kind == 2:
        return text[:at] + chance.choice(FRAGMENTS) + text[at:]
    if kind == 3:
        objects = [match.end() for match in re.finditer("{", text)] or [0]
        at, members = chance.choice(objects), [each for each in FRAGMENTS if ": " in each]
        fragment = chance.choice(members)
        at -= fragment.startswith("{")
        return text[:at] + fragment + text[max(at, 0) :]
    words = [match.span() for match in re.finditer(r'[^\s"{}\[\],:]+', text)] or [(0, 0)]
    start, end = chance.choice(words)
    at = chance.randint(start, end)
    return text[:at] + chance.choice("abc1-_#é") + text[at + (kind == 5) :]


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(12))
def test_random_edits(seed: int) -> None:
    chance = random.Random(seed)  # noqa: S311  no secret
    session = Session()
    good = chance.choice(SAMPLES).read_text("utf-8")
    session.write(good)
    text = good
    for _ in range(25):
        for _ in range(chance.choice((1, 1, 1, 3))):
            text = edited(text, chance)
        if session.write(text):
            good = text
        elif chance.random() < 0.6:
            text = good


def test_places_in_parts_are_found_when_one_is_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    placed: list[int] = []
    place = Unplaced.placed

    def noted(element: Unplaced) -> Any:
        placed.append(element.start)
        return place(element)

    monkeypatch.setattr(Unplaced, "placed", noted)
    nodes = [node(f"n{number}", **{PROP: number}) for number in range(9)]
    read_as = divided_reader.read_divided(SourceText("robot.jsonld", model(*nodes)), ReadOptions())
    first = len(placed)
    assert first < len(nodes)
    triple = next(each for each in read_as.document.statements if each[2].startswith('"8"'))
    assert read_as.document.map.triples[triple].start > placed[0]
    assert len(placed) == first + 1
