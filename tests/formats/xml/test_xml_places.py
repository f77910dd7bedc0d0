"""Reading the text again at the place of a triple gives what the triple says."""

from __future__ import annotations

import re
from html import unescape
from pathlib import Path

import pytest
from data import locate_data
from support.linting import source

from kinlint.addresses import local_name, root_of
from kinlint.document import Document
from kinlint.formats.options import ReadOptions
from kinlint.formats.xml.reader import read
from kinlint.terms import Term, iri_value, is_blank, literal, literal_datatype, literal_value
from kinlint.vocabulary import ATTRIBUTE, EXTENSION, KINLINT, REFERENCE, SRC

MARKUP = re.compile(r"<!--.*?-->|<!\[CDATA\[(.*?)\]\]>|<(\w+)[^>]*>.*?</\2>|<[^>]*/>", re.DOTALL)
SAME = {"inf": "INF", "+inf": "INF", "-inf": "-INF", "nan": "NaN", "-nan": "NaN"}


def models(kind: str) -> list[Path]:
    return [path for path in sorted(locate_data("robots", kind).rglob("*")) if path.is_file()]


@pytest.mark.corpus
@pytest.mark.parametrize("form", ["urdf", "srdf", "sdf"])
def test_every_triple_of_the_robots_is_where_its_span_says(form: str) -> None:
    for path in models(form):
        model = read(source(path.read_bytes(), str(path), form), ReadOptions())
        for triple in model.statements:
            assert_said(model, *triple)


def assert_said(model: Document, subject: Term, prop: Term, value: Term) -> None:
    span = model.map.triples[subject, prop, value]
    there = model.source[span]
    name = iri_value(prop)
    if is_blank(subject):
        assert_remarked(model, name, value, there)
    elif name.startswith((ATTRIBUTE, f"{SRC}text")):
        assert said(there, value), (model.source.position(span.start), there, value)
    elif name.startswith(REFERENCE):
        assert said(there, literal(local_name(value))) or value == root_of(value), (there, value)
    elif value in model.map.nodes and not name.startswith(SRC):
        assert name in (f"{KINLINT}{model.format.name}#{there}", f"{EXTENSION}{there}")
        assert model.source[model.map.nodes[value].whole].startswith(f"<{there}")


def assert_remarked(model: Document, name: str, value: Term, there: str) -> None:
    if name == f"{SRC}written" and not there.startswith("xacro:"):
        assert said(there, value), (there, value)
    if name == f"{SRC}prefix":
        assert there.startswith(f"{literal_value(value)}:")


def said(there: str, value: Term) -> bool:
    """Whether the text *there* is a way to write *value*."""
    if literal_datatype(value).endswith("#string"):
        plain = MARKUP.sub(lambda match: match[1] or "", there)
        written = literal_value(value)
        return written in (unescape(there), unescape(plain).strip(), there) or (
            re.sub(r"\s", " ", unescape(there)) == written
        )
    if literal_datatype(value).endswith("#boolean"):
        return there.lower() == literal_value(value)
    if literal_datatype(value).endswith("#integer"):
        # An integer of SDF may be written as 1u or 1.0.
        number = int(there, 16) if "x" in there else float(there.rstrip("uU"))
        return number == int(literal_value(value))
    return SAME.get(there.lower(), there) == literal_value(value)


@pytest.mark.corpus
@pytest.mark.parametrize("form", ["urdf", "srdf", "sdf"])
def test_every_element_of_the_robots_is_whole(form: str) -> None:
    for path in models(form):
        model = read(source(path.read_bytes(), str(path), form), ReadOptions())
        for node, spans in model.map.nodes.items():
            if is_blank(node) or node == model.graph:
                continue
            whole = model.source[spans.whole]
            tag = re.match(r"<([^\s/>]+)", whole)
            assert tag
            assert whole.endswith((f"</{tag[1]}>", "/>")) or re.search(rf"</{tag[1]}\s+>$", whole)
            assert spans.identifier is not None
            assert spans.whole.start < spans.identifier.start < spans.whole.end
