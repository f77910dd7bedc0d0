"""How nodes and values are written is stated where RDF does not keep it."""

from __future__ import annotations

from typing import Any

import pytest
from reading import details, document, losses

from kinlint.formats.nquads.reader import read as read_nquads
from kinlint.formats.options import ReadOptions
from kinlint.formats.turtle.reader import read as read_turtle
from kinlint.terms import iri, iri_value
from kinlint.text import SourceText
from kinlint.vocabulary import KL, SRC

ARM = "https://example.org/arm#"
EX = {
    "ex": ARM,
    "p": "ex:p",
    "to": {"@id": "ex:to", "@type": "@id"},
    "chain": {"@id": "ex:chain", "@container": "@list"},
}
USES = iri(f"{SRC}usesTerm")


def model(*nodes: Any) -> dict[str, Any]:
    return {"@context": EX, "@graph": list(nodes)}


@pytest.mark.parametrize(
    ("key", "values", "again"),
    [
        ("to", ["ex:b", "ex:c", "ex:b"], '"ex:b"'),
        ("to", ["ex:b", {"@id": "ex:b"}], '"ex:b"'),
        ("p", [1.5, 2.5, 1.5], "1.5"),
        ("@type", ["ex:B", "ex:C", "ex:B"], '"ex:B"'),
    ],
)
def test_a_value_written_once_more_in_a_set_is_stated(key: str, values: Any, again: str) -> None:
    read = document(model({"@id": "ex:a", key: values}))

    assert losses(read) == [("RepeatedValue", again)]
    said = details(read, again)
    assert said["subject"] == [f"{ARM}a"]
    assert said["key"] == [key]
    assert int(said["offset"][0]) == read.source.text.rindex(again)


def test_what_is_repeated_is_named_with_its_property() -> None:
    said = details(document(model({"@id": "ex:a", "to": ["ex:b", "ex:b"]})), '"ex:b"')

    assert (said["value"], said["property"]) == ([f"{ARM}b"], [f"{ARM}to"])


@pytest.mark.parametrize(
    "node",
    [
        {"@id": "ex:a", "chain": [1, 1]},
        {"@id": "ex:a", "p": [1, "1"]},
        {"@id": "ex:a", "to": ["ex:b"], "p": [{"@id": "ex:b"}]},
        {"@id": "ex:a", "to": [{"p": 1}, {"p": 1}]},
    ],
)
def test_lists_and_different_values_and_anonymous_nodes_repeat_nothing(node: Any) -> None:
    assert losses(document(model(node))) == []


def test_nodes_within_nodes_of_a_node_are_counted_at_the_first() -> None:
    inner = {"@id": "ex:c", "p": 1, "to": {"@id": "ex:d", "p": 2}}
    outer = {"@id": "ex:a", "to": [{"@id": "ex:b", "to": inner}, {"@id": "ex:e", "p": 3}]}
    read = document(model(outer, {"@id": "ex:f", "to": {"@id": "ex:g", "to": {"p": 4}}}))

    assert losses(read) == [("NestedNode", '"ex:c"'), ("NestedNode", "{")]
    said = details(read, '"ex:c"')
    assert said["subject"] == [f"{ARM}c"]
    assert said["outermost"] == [f"{ARM}a"]
    assert (said["count"], said["depth"]) == (["2"], ["3"])


@pytest.mark.parametrize(
    "node",
    [
        {"@id": "ex:a", "to": {"@id": "ex:b", "p": 1}},
        {"@id": "ex:a", "to": {"@id": "ex:b", "to": {"@id": "ex:c"}}},
        {"@id": "ex:a", "to": {"@id": "ex:b", "p": {"@value": 1}}},
        {"@id": "ex:a", "@graph": [{"@id": "ex:b", "to": {"@id": "ex:c", "p": 1}}]},
        {"@id": "ex:a", "to": {"@id": "ex:b", f"{KL}ignore": {f"{KL}rule": "UNI001"}}},
    ],
)
def test_one_level_references_graphs_and_remarks_are_not_deep(node: Any) -> None:
    assert losses(document(model(node)), "NestedNode") == []


def test_a_malformed_value_is_stated_with_its_property() -> None:
    said = details(document(model({"@id": "ex:a", "to": "ex:#b"})), '"ex:#b"')

    assert (said["key"], said["property"]) == (["to"], [f"{ARM}to"])


@pytest.mark.parametrize("value", ["@tip", ["ex:b", "@tip"]])
def test_a_value_like_a_keyword_is_stated_with_its_key(value: Any) -> None:
    assert details(document(model({"@id": "ex:a", "to": value})), '"@tip"')["key"] == ["to"]


def test_a_malformed_identifier_has_no_key() -> None:
    assert "key" not in details(document(model({"@id": "ex:#a", "p": 1})), '"ex:#a"')


def test_the_terms_that_a_document_uses_are_stated_in_every_format() -> None:
    jsonld = document(model({"@id": "ex:a", "@type": "ex:T", "p": 1}))
    turtle = read_turtle(
        SourceText("a.ttl", f"@prefix ex: <{ARM}> . ex:a a ex:T ; ex:p 1 ."), ReadOptions()
    )
    nquads = read_nquads(
        SourceText("a.nt", f'<{ARM}a> <{ARM}p> "1" .\n<{ARM}a> a <{ARM}T> .'.replace(" a ", TYPE)),
        ReadOptions(),
    )
    for read in (jsonld, turtle, nquads):
        used = {iri_value(value) for _, prop, value in read.statements if prop == USES}
        assert used == {f"{ARM}T", f"{ARM}p"}


TYPE = " <http://www.w3.org/1999/02/22-rdf-syntax-ns#type> "
