"""Whatever an XML file says is stated, at its place; whatever a file is, there is an answer."""

from __future__ import annotations

from dataclasses import dataclass, field
from xml.sax.saxutils import escape

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from reading_xml import graph, model
from support.linting import document

from kinlint.errors import SourceError
from kinlint.terms import is_blank

NAMES = st.sampled_from(["link", "joint", "visual", "pose", "mass", "x", "é", "gz:a", "a-1"])
PLAIN = st.characters(exclude_categories=["Cs", "Cc"], exclude_characters="\ufffe\uffff$")
VALUES = st.text(PLAIN, max_size=8)
SPACE = st.text(" \t\n", max_size=3)


@dataclass
class Tag:
    name: str
    attributes: dict[str, str]
    children: list[Tag | str] = field(default_factory=list)


TAGS = st.recursive(
    st.builds(Tag, NAMES, st.dictionaries(NAMES | st.just("name"), VALUES, max_size=3)),
    lambda inner: st.builds(
        Tag,
        NAMES,
        st.dictionaries(NAMES | st.just("name"), VALUES, max_size=3),
        st.lists(inner | VALUES, max_size=3),
    ),
    max_leaves=8,
)


@st.composite
def written(draw: st.DrawFn, tag: Tag) -> str:
    """One of the ways to write *tag*."""
    text = f"<{tag.name}"
    for name, value in tag.attributes.items():
        quote = draw(st.sampled_from("\"'"))
        said = escape(value, {quote: "&quot;" if quote == '"' else "&apos;"})
        text += f" {draw(SPACE)}{name}{draw(SPACE)}={draw(SPACE)}{quote}{said}{quote}"
    text += draw(SPACE)
    if not tag.children and draw(st.booleans()):
        return text + "/>"
    inside = ""
    for child in tag.children:
        inside += escape(child) if isinstance(child, str) else draw(written(child))
        inside += draw(st.sampled_from(["", "", "<!-- <a> ' -->", "<?b > ?>"]))
    return f"{text}>{inside}</{tag.name}{draw(SPACE)}>"


def attributes(tag: Tag) -> list[tuple[str, str]]:
    """All attributes in *tag*, in the order of the text."""
    found = list(tag.attributes.items())
    for child in tag.children:
        if isinstance(child, Tag):
            found += attributes(child)
    return found


def elements(tag: Tag) -> list[str]:
    inner = [elements(child) for child in tag.children if isinstance(child, Tag)]
    return [tag.name, *(name for each in inner for name in each)]


@given(st.data(), TAGS)
def test_what_is_written_is_stated_where_it_is_written(data: st.DataObject, tag: Tag) -> None:
    root = Tag("robot", {"name": "r"}, [Tag("gazebo", {}, [tag])])
    text = data.draw(written(root))
    encoding = data.draw(st.sampled_from(["utf-8", "utf-16", "utf-8-sig"]))
    arm = model(text.encode(encoding))
    stated = graph(arm)
    assert [(p[1:], o) for _, p, o in stated if p[0] == "@"] == attributes(root)
    assert [p.removeprefix("ext:") for _, p, o in stated if o[:1] == "#" and p[0] != "@"][1:] == [
        "gazebo", *elements(tag)
    ]  # fmt: skip
    for triple in arm.statements:
        span = arm.map.triples[triple]
        assert 0 <= span.start <= span.end <= len(text)
        if "attribute#" in triple[1]:
            name = triple[1].partition("#")[2][:-1]
            assert text[: span.start].rstrip("\"'").rstrip("= \t\n").endswith(name)
    for node, spans in arm.map.nodes.items():
        if not is_blank(node) and node != arm.graph:
            assert text[spans.whole.start] == "<"
            assert text[spans.whole.end - 1] == ">"


PIECES = st.sampled_from(
    ["<robot name='a'>", "</robot>", "<link ", "name='", "'", '"', "/>", ">", "<", "&", ";",
     "&amp;", "<!--", "--", "-->", "<![CDATA[", "]]>", "<?xml version='1.0'?>", "<?", "?>", "[",
     "<!DOCTYPE robot", "]", " ", "\n", "=", "é", "\0", "\ud800", "kinlint: ignore[A]", "x",
     "xmlns:a='b'", "a:b", "<mass value='1'/>", "${a}"]
)  # fmt: skip


@pytest.mark.slow
@settings(max_examples=300)
@given(st.lists(PIECES | st.text(max_size=3), max_size=30).map("".join))
def test_any_text_is_read_or_refused_with_its_place(text: str) -> None:
    try:
        arm = document(text, form="urdf")
    except SourceError as refused:
        error = refused
    else:
        error = None
    if error is not None:
        assert error.line is not None
        return
    for triple in arm.statements:
        span = arm.map.triples[triple]
        assert 0 <= span.start <= span.end <= len(text)
    for spans in arm.map.nodes.values():
        assert 0 <= spans.whole.start <= spans.best.start <= spans.best.end <= len(text)


@settings(max_examples=300)
@given(st.binary(max_size=200).map(lambda data: b"<" + data) | st.binary(max_size=50))
def test_any_bytes_are_decoded_or_refused(data: bytes) -> None:
    stated, cause = (), ""
    try:
        stated = model(data).statements
    except SourceError as refused:
        cause = refused.cause
    assert bool(cause) is not bool(stated)
