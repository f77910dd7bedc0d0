"""Whatever changes in an XML file, what is read afterwards is what was meant."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise
from random import Random
from xml.sax.saxutils import escape

import pytest
from data import locate_data
from editing_xml import written
from hypothesis import given, settings
from hypothesis import strategies as st
from random_changes import Changer

from kinlint.document import Document
from kinlint.edits import Delta, NotExpressible
from kinlint.errors import SourceError
from kinlint.formats.decoding import decode, encode
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.formats.xml.editing import element_tree
from kinlint.formats.xml.editing.editor import Editor
from kinlint.formats.xml.editing.stated_elements import tag_of
from kinlint.terms import iri, literal
from kinlint.text import SourceText
from kinlint.vocabulary import ATTRIBUTE, EXTENSION

LARGEST = 60_000
ROOTS = {"arm.urdf": "robot", "arm.srdf": "robot", "arm.sdf": "sdf"}
TAGS = st.sampled_from(
    ["link", "joint", "visual", "origin", "axis", "group", "model", "pose", "x", "gazebo"]
)
PLAIN = st.characters(exclude_categories=["Cs", "Cc"], exclude_characters="\ufffe\uffff$")
WORDS = st.sampled_from(["1", "-0.50", "1 2 3", "0 0 0 0 0 0", "a"]) | st.text(PLAIN, max_size=5)
KEYS = st.sampled_from(["name", "xyz", "rpy", "link", "lower", "x"])


@dataclass
class Tag:
    name: str
    attributes: dict[str, str]
    children: list[Tag] = field(default_factory=list)
    text: str = ""


ATTRIBUTES = st.dictionaries(KEYS, WORDS, max_size=3)
LEAVES = st.builds(Tag, TAGS, ATTRIBUTES, text=WORDS) | st.builds(Tag, TAGS, ATTRIBUTES)


def tag(inner: st.SearchStrategy[Tag]) -> st.SearchStrategy[Tag]:
    return st.builds(Tag, TAGS, ATTRIBUTES, st.lists(inner, max_size=3))


@st.composite
def robots(draw: st.DrawFn) -> SourceText:
    """The text of a robot in the manner of somebody."""
    name = draw(st.sampled_from(sorted(ROOTS)))
    children = draw(st.lists(st.recursive(LEAVES, tag, max_leaves=6), max_size=3))
    end = draw(st.sampled_from(["\n", "\n", "\r\n", "\n\n", ""]))
    manner = Manner(draw, end, draw(st.sampled_from(["  ", "\t", "    "])) if end else "")
    text = manner.written(Tag(ROOTS[name], {"name": "r"}, children), end and end[-1:])
    return SourceText(name, text.removeprefix(end) if end else text)


@dataclass
class Manner:
    """How somebody writes XML."""

    draw: st.DrawFn
    end: str
    step: str

    def written(self, tag: Tag, indent: str) -> str:
        draw = self.draw
        quote = draw(st.sampled_from("\"'"))
        broken = f"{self.end}{self.step * 3}" if self.end and draw(st.booleans()) else " "
        text = f"<{tag.name}"
        for number, (name, value) in enumerate(tag.attributes.items()):
            said = escape(value, {quote: "&quot;" if quote == '"' else "&apos;"})
            text += f"{broken if number else ' '}{name}={quote}{said}{quote}"
        if not tag.children and not tag.text and draw(st.booleans()):
            return text + draw(st.sampled_from(["/>", " />"]))
        inside = escape(tag.text)
        for child in tag.children:
            inside += f"{self.end}{indent}{self.step}{self.written(child, indent + self.step)}"
            inside += draw(st.sampled_from(["", "", " <!-- <a> ' -->"]))
        if tag.children:
            inside += f"{self.end}{indent}"
        return f"{text}>{inside}</{tag.name}>"


def check(document: Document, delta: Delta, editor: Editor) -> bool:
    """Whether *editor* can say *delta*; if so, it does."""
    try:
        edits = editor.edits(delta)
    except NotExpressible:
        return False
    assert all(one.span.end <= other.span.start for one, other in pairwise(edits))
    own = written(document, edits).get(document.source.name, document.source)
    encode(own)
    after = read(own, ReadOptions())
    assert element_tree.tree(after) == element_tree.changed(document, delta)
    if not any(tag_of(predicate) for _, predicate, _ in delta.removed):
        assert own.text.count("<!-- <a> ' -->") == document.source.text.count("<!-- <a> ' -->")
    return True


@pytest.mark.slow
@settings(max_examples=200)
@given(robots(), st.randoms(use_true_random=False))
def test_any_change_of_any_robot(source: SourceText, random: Random) -> None:
    document = read(source, ReadOptions())
    check(document, Changer(document, random).delta(), Editor(document, ReadOptions()))


@pytest.mark.slow
@pytest.mark.parametrize("what", [ATTRIBUTE, EXTENSION])
@given(robots(), st.randoms(use_true_random=False))
def test_what_was_put_in_goes_without_a_trace(
    what: str, source: SourceText, random: Random
) -> None:
    document, options = read(source, ReadOptions()), ReadOptions()
    changer = Changer(document, random)
    parent = random.choice(changer.nodes)
    if what == EXTENSION and not changer.known[parent].children:
        return
    value = literal("1") if what == ATTRIBUTE else "_:new"
    change = Delta((), ((parent, iri(f"{what}new"), value),))
    (more,) = written(document, Editor(document, options).edits(change)).values()
    after = read(more, options)
    there = next(each for each in after.statements if each[1].endswith("#new>"))
    (less,) = written(after, Editor(after, options).edits(Delta((there,)))).values()
    assert _lines(less.text) == _lines(source.text)


def _lines(text: str) -> list[str]:
    """The lines that are not blank: of several blank ones, one may go."""
    return [line for line in text.splitlines() if line.strip()]


@pytest.mark.corpus
@pytest.mark.parametrize("kind", ["urdf", "srdf", "sdf"])
def test_any_change_of_real_robots(kind: str) -> None:
    random, said, all_ = Random(kind), 0, 0  # noqa: S311  no secrets
    for path in sorted(locate_data("robots", kind).rglob("*")):
        if path.suffix not in (".urdf", ".srdf", ".sdf") or path.stat().st_size > LARGEST:
            continue
        options = ReadOptions()
        try:
            document = read(decode(str(path), path.read_bytes()), options)
        except SourceError:
            continue
        changer, editor = Changer(document, random), Editor(document, options)
        if not changer.nodes or document.pieces:
            continue
        for _ in range(2):
            all_ += 1
            said += check(document, changer.delta(), editor)
    assert said > all_ / 2
